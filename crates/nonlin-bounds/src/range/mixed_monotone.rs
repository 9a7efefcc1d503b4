//! Mixed-monotone ranges by remainder-form decomposition.
//!
//! For shifts `m` that make `g = f_i - m'x` monotone in every coordinate ([`Signs`]), `g` has its extremes at two opposite
//! corners `zl`, `zu` of the box, and `m'(x - zl) >= -sum_j |m_j| w_j` for the widths `w`, `m'(x - zu)` likewise from above:
//! `f_i` lies in `[f_i(zl) - sum |m_j| w_j, f_i(zu) + sum |m_j| w_j]`.
//!
//! **Source:** Khajenejad and Yong, *Tight Remainder-Form Decomposition Functions with Applications to Constrained Reachability and Guaranteed State
//! Estimation* (2021).

use scalars::Interval;
use scalars::rounding::{add_up, mul_up};

use super::Scratch;
use crate::function::evaluate;
use crate::signs::{Purpose, Signs};
use crate::{BoundError, DynFunction, Order};

/// Intersects the range of output `i` with the bounds of every choice of signs; needs the gradients over the box.
pub(super) fn tighten(
    f: &dyn DynFunction,
    x: &[Interval],
    p: &[Interval],
    i: usize,
    scratch: &mut Scratch,
) -> Result<(), BoundError> {
    let n = x.len();
    let gradient = &scratch.over.jacobian()[i * n..(i + 1) * n];
    scratch.signs.plan(Purpose::Range, gradient.iter().copied(), |j| x[j].width());
    for choice in 0..scratch.signs.choices() {
        scratch.signs.choose(choice);
        let signs = &scratch.signs;
        let loss = (0..n).fold(0.0, |sum, j| add_up(sum, mul_up(signs.shift(j).abs(), x[j].width())));
        if !loss.is_finite() {
            continue;
        }
        let mut corner = |low: bool| {
            scratch.point.clear();
            let at = |j: usize| if scratch.signs.rises(j) == low { x[j].lo() } else { x[j].hi() };
            scratch.point.extend((0..n).map(|j| Interval::point(at(j))));
            evaluate(f, Order::Value, &scratch.point, p, &mut scratch.at)?;
            Ok::<_, BoundError>(scratch.at.values()[i])
        };
        let bound = Signs::between(corner(true)?, corner(false)?, loss);
        scratch.bounds[i] = scratch.bounds[i].intersection(bound);
    }
    Ok(())
}
