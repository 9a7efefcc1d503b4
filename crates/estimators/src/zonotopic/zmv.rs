//! Prediction by the mean value theorem.

use nonlin_bounds::{Domain, Form};

use super::{Scratch, State};
use crate::{EstimatorError, System};
use scalars::Interval;

/// Replaces the set by its image under the dynamics,
///
/// ```text
/// f(X, W) in f(c, c_w) + J (X - c) + J_w (W - c_w),    J = f_x(H, W),  J_w = f_w(c, W),
/// ```
///
/// where the products with the interval matrices are `mid J (X - c)` and the box of `rad J |G| 1`, `c` the center of the set and `H` its
/// hull.
///
/// **Source:** Alamo, Bravo, Camacho 2005, Theorem 4; paper 003, Proposition 1 with Remark 4.
pub(super) fn image(
    system: &System,
    input: &[Interval],
    state: &mut State,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    let noise = system.process_noise();
    scratch.about_centers(state, Some(noise))?;
    let Scratch { bounds, enclosure, stacked, .. } = scratch;
    let domain = Domain::new(&stacked.sides, &stacked.point).with_parameters(input).with_noises(noise.dim());
    enclosure.enclose(Form::MeanValue, system.dynamics().function(), &domain, bounds)?;
    state.set.product_assign(noise);
    Ok(enclosure.image_in_place(&mut state.set, bounds)?)
}
