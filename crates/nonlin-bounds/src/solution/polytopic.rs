//! Solution sets in V-polytopes, cut vertex by vertex.

use scalars::Interval;
use scalars::rounding::{add_up, div_up, sub_down, sub_up};
use setrep::{HPolytope, MAX_FACES, Matrix, SetError, VPolytope};

use crate::expanded::Expanded;
use crate::{BoundError, DynFunction, Operand, Workspace};

/// Solution set `{ x in X : g(x, p) in Y }` in a polytope `X = conv V + [-r, r]`, `Y = { y : A y <= b }`, shape `at: n`.
///
/// For `x = sum_i l_i v_i + e` with `l` in the unit simplex, row `j` of `A g(x) <= b` implies
/// `sum_i l_i low_ji <= b_j + |[J_j]| r`, `low_ji` the least value of `A_j g(x_0) + [J_j] (v_i - x_0)`, `[J]` the range of the Jacobian of `A g`
/// over the interval hull of `X` and `x_0`. So each row cuts the simplex over the vertices by a half-space, whose corners are the
/// vertices that fulfil it and a point on each edge that leaves it. The rows are taken in turn; each is evaluated at the
/// vertices that the ones before have left. A row affine in `x` is an intersection with a half-space.
///
/// A box `Y` is [`HPolytope::from_intervals`]; additive noise widens it. For other noise stack it with the states and project.
/// Calling it again on the result, with the Jacobian over the smaller hull, tightens further.
///
/// **Guarantee:** superset of the solution set, rounding included, and a subset of `X` but for rounding.
/// **Source:** paper 004, Theorem 2, whose points `sum_i l_i (v_i - x_0)` and remainders `sum_i l'_i rad [J] |v_i - x_0|` have weights that do
/// not depend on each other; with one row this set lies in its.
///
/// # Errors
/// [`BoundError::Dimension`], [`BoundError::NonFinite`]; [`BoundError::NotSmooth`] unless every output is proven `C1` on the hull;
/// [`BoundError::UnboundedResult`]; [`SetError::EmptySet`], proven; [`SetError::OverBudget`].
pub fn polytopic_solution(
    g: &dyn DynFunction,
    set: &VPolytope,
    y: &HPolytope,
    at: &[f64],
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<VPolytope, BoundError> {
    let rows = rows_over(g, set, y, at, p, workspace)?;
    let mut solution = set.clone();
    for (j, &offset) in y.offsets().iter().enumerate() {
        let level = add_up(offset, rows.spread(j, solution.remainder()));
        let low: Vec<f64> = solution.vertices().columns().map(|v| rows.reach(j, v).lo()).collect();
        solution = cut(solution, &low, level)?;
    }
    Ok(solution)
}

/// `A g` around `at`.
pub(super) fn rows_over(
    g: &dyn DynFunction,
    set: &VPolytope,
    y: &HPolytope,
    at: &[f64],
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<Expanded, BoundError> {
    if y.dim() != g.outputs() {
        return Err(BoundError::Dimension { operand: Operand::Outputs, expected: g.outputs(), found: y.dim() });
    }
    Ok(Expanded::over(g, set, at, p, &mut workspace.jet)?.combined(y.normals()))
}

/// A superset of `{ sum_i l_i v_i : l in the simplex, sum_i l_i low_i <= level } + [-r, r]`.
fn cut(set: VPolytope, low: &[f64], level: f64) -> Result<VPolytope, SetError> {
    let (inside, outside): (Vec<usize>, Vec<usize>) = (0..low.len()).partition(|&i| low[i] <= level);
    if outside.is_empty() {
        return Ok(set);
    }
    let count = inside.len() * (1 + outside.len());
    if count > MAX_FACES {
        return Err(SetError::OverBudget { count, limit: MAX_FACES });
    }
    let (vertices, n) = (set.vertices(), set.dim());
    let mut corners = Matrix::zeros(n, 0);
    let mut lost = vec![0.0_f64; n];
    let mut crossing = vec![0.0; n];
    for &i in &inside {
        corners.push_col(vertices.col(i))?;
        for &k in outside.iter().filter(|_| low[i] < level) {
            // Going too far along the edge only adds points.
            let t = div_up(sub_up(level, low[i]), sub_down(low[k], low[i])).min(1.0);
            for c in 0..n {
                let (from, to) = (Interval::point(vertices[(c, i)]), Interval::point(vertices[(c, k)]));
                let x = from + (to - from).scale(t);
                crossing[c] = x.mid();
                lost[c] = lost[c].max(x.rad());
            }
            corners.push_col(&crossing)?;
        }
    }
    let remainder: Vec<f64> = set.remainder().iter().zip(&lost).map(|(&r, &lost)| add_up(r, lost)).collect();
    VPolytope::with_remainder(corners, &remainder)?.remove_redundant()
}
