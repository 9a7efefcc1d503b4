//! Prediction by Taylor's theorem of first order.

use nonlin_bounds::{BoundError, Copies, Domain, QuadraticEnclosure};
use scalars::Interval;

use super::{Scratch, State, zmv};
use crate::{EstimatorError, System};

/// Replaces the set by its image under the dynamics: the linear part about the center `c` of `Z = X x W`, and the quadratic term
/// `(z - c)' Q (z - c)`, `Q = f''(H) / 2`, in the coordinates of the set, for `p = 0`. Dynamics that are not `C2` on the hull, or without
/// Hessians, go by the mean value theorem.
///
/// **Source:** Combastel 2005; paper 003, Proposition 2 with `gamma = c` and no constraints.
pub(super) fn image(
    system: &System,
    input: &[Interval],
    state: &mut State,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    let (f, noise) = (system.dynamics().function(), system.process_noise());
    scratch.about_centers(state, Some(noise))?;
    let Scratch { bounds, quadratic, product, stacked, .. } = scratch;
    let domain = Domain::new(&stacked.sides, &stacked.point).with_parameters(input).with_noises(noise.dim());
    let product = product.get_or_insert_with(|| state.set.clone());
    product.clone_from(&state.set);
    product.product_assign(noise);
    let renewed = match quadratic {
        Some(enclosure) => enclosure.renew(f, product, &domain, Copies::Shared, bounds),
        None => QuadraticEnclosure::new(f, product, &domain, Copies::Shared, bounds)
            .map(|enclosure| *quadratic = Some(enclosure)),
    };
    match (renewed, quadratic) {
        (Ok(()), Some(enclosure)) => {
            enclosure.image_in_place(product, bounds)?;
            core::mem::swap(&mut state.set, product);
            Ok(())
        }
        (Err(BoundError::NotSmooth { .. } | BoundError::OrderNotAvailable { .. }), _) => {
            zmv::image(system, input, state, scratch)
        }
        (result, _) => Ok(result?),
    }
}
