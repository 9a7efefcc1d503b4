//! Prediction by Taylor's theorem of first order.

use nonlin_bounds::{Copies, Domain, QuadraticEnclosure};
use scalars::Interval;

use super::{Scratch, State};
use crate::{EstimatorError, System};

/// Replaces the set by its image under the dynamics: the linear part about the center `c` of `Z = X x W`, and the quadratic term
/// `(z - c)' Q (z - c)`, `Q = f''(H) / 2`, in the coordinates of the set, for `p = 0`.
///
/// **Source:** Combastel 2005; paper 003, Proposition 2 with `gamma = c` and no constraints.
pub(super) fn image(
    system: &System,
    input: &[Interval],
    state: &mut State,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    let noise = system.process_noise();
    scratch.about_centers(state, Some(noise))?;
    let Scratch { bounds, quadratic, stacked, .. } = scratch;
    let domain = Domain::new(&stacked.sides, &stacked.point).with_parameters(input).with_noises(noise.dim());
    state.set.product_assign(noise);
    let f = system.dynamics().function();
    let enclosure = match quadratic {
        Some(enclosure) => {
            enclosure.renew(f, &state.set, &domain, Copies::Shared, bounds)?;
            enclosure
        }
        None => quadratic.insert(QuadraticEnclosure::new(f, &state.set, &domain, Copies::Shared, bounds)?),
    };
    Ok(enclosure.image_in_place(&mut state.set, bounds)?)
}
