//! Solution sets by remainder-form decomposition.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix};

use crate::decomposition::Decomposition;
use crate::{BoundError, DynFunction, Operand, Workspace};

/// Solution set `{ x in X : g(x, p) in [y] }` of a constrained zonotope, `[y]` a box whose sides may be unbounded.
///
/// The rows `h_i xi` of the decomposition of `g` over the generators of `X` (see [`decomposition_image`](crate::decomposition_image)) lie in
/// `[y_i] - [g_i]` wherever `g_i(x)` lies in `[y_i]`: one constraint an output, no generators. Outputs without bounds need not be smooth. Measurement noises that are additive widen `[y]`, others
/// are stacked with the states, and the result is projected.
///
/// **Guarantee:** superset of the solution set, rounding included.
/// **Source:** as [`decomposition_image`](crate::decomposition_image).
///
/// # Errors
/// [`BoundError::Dimension`], [`BoundError::EmptyInterval`]; [`BoundError::NotSmooth`] unless every output is proven `C1` on the hull;
/// [`BoundError::UnboundedResult`]; [`BoundError::Set`], among them an empty set.
pub fn decomposition_solution(
    g: &dyn DynFunction,
    set: &ConstrainedZonotope,
    y: &[Interval],
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<ConstrainedZonotope, BoundError> {
    BoundError::check_size(Operand::Outputs, g.outputs(), y.len())?;
    if let Some(index) = y.iter().position(Interval::is_empty) {
        return Err(BoundError::EmptyInterval { operand: Operand::Outputs, index });
    }
    let is_asked_for = |output: usize| y[output] != Interval::ENTIRE;
    let Decomposition { set, rows, residuals, .. } = Decomposition::of(g, set, p, (1, &is_asked_for), workspace)?;
    let (old, new) = (set.num_constraints(), y.len());
    let mut constraints = Matrix::zeros(old + new, set.num_generators());
    for j in 0..set.num_generators() {
        let column = constraints.col_mut(j);
        column[..old].copy_from_slice(set.constraints().col(j));
        column[old..].copy_from_slice(rows.col(j));
    }
    let mut ranges = set.ranges().to_vec();
    ranges.extend(y.iter().zip(&residuals).map(|(y, residual)| *y - *residual));
    Ok(ConstrainedZonotope::with_constraints(set.unconstrained(), &constraints, &ranges)?)
}
