//! Solution sets in V-polytopes, cut vertex by vertex.

use scalars::Interval;
use scalars::rounding::{add_up, sub_down};
use setrep::{HPolytope, SetError, VPolytope};

use crate::expanded::Expanded;
use crate::{BoundError, DynFunction, Expansion, Operand, Workspace};

/// New vertices that lie in the hull of the others up to this share of the set's extents are dropped.
const THIN: f64 = 1e-10;

/// Solution set `{ x in X : g(x, p) in Y }` in a polytope `X = conv V + [-r, r]`, `Y = { y : A y <= b }`.
///
/// For `x = sum_i l_i v_i + e` with `l` in the unit simplex, row `j` of `A g(x) <= b` implies
/// `sum_i l_i low_ji <= b_j + |[J_j]| r`, `low_ji` the least value of `A_j g(x_0) + [J_j] (v_i - x_0)`, `[J]` the range of the Jacobian of `A g`
/// over the interval hull of `X`. So a row leaves the convex combinations whose values combine to at most the level
/// ([`VPolytope::cut_by_values`]). The rows are taken in turn; each is evaluated at the vertices that the ones before have left. A row affine
/// in `x` is an intersection with a half-space.
///
/// A box `Y` is [`HPolytope::from_intervals`]; additive noise widens it. For boxes of noise see [`polytopic_strips`].
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
    at: Expansion<'_>,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<VPolytope, BoundError> {
    let rows = rows_over(g, set, y, at, p, workspace)?;
    let mut solution = set.clone();
    for (j, &offset) in y.offsets().iter().enumerate() {
        let level = add_up(offset, rows.spread(j, solution.remainder()));
        let values: Vec<f64> = solution.vertices().columns().map(|v| rows.reach(j, v).lo()).collect();
        // A row without a lower bound at some vertex, or with a level beyond the floats, says nothing.
        if level.is_finite() && values.iter().all(|value| value.is_finite()) {
            solution = solution.cut_by_values(&values, level, THIN)?;
        }
    }
    Ok(solution)
}

/// `A g` around `at`.
pub(super) fn rows_over(
    g: &dyn DynFunction,
    set: &VPolytope,
    y: &HPolytope,
    at: Expansion<'_>,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<Expanded, BoundError> {
    BoundError::check_size(Operand::Outputs, g.outputs(), y.dim())?;
    Ok(Expanded::over(g, set, at, p, &mut workspace.jet)?.combined(y.normals()))
}

/// Most columns after a cut for which a row keeps a value of its own at every vertex. In the plane few of them stay, and those are found by sorting.
const fn most_columns(dim: usize) -> usize {
    if dim <= 2 { 256 } else { 24 }
}

/// Most columns in between, unless the set has more than half as many to begin with: sets nearly without interior can multiply.
const MOST_BETWEEN: usize = 128;

/// What [`polytopic_strips`] has left of a polytope.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub enum PolytopicCut {
    /// A superset of the solutions.
    Left(VPolytope),
    /// There is none: on what the outputs before have left this one lies in a range that the required one does not meet.
    ProvenEmpty {
        /// Index of the output.
        output: usize,
        /// Its range, noise included.
        reach: Interval,
    },
}

/// Solution set `{ x in X : g((x, v), p) in [y] for some v in [v] }` in a polytope, `[y]` a box whose sides may be unbounded and `[v]` a box of
/// noises that are the last variables of `g`.
///
/// As [`polytopic_solution`] with the noises in the lower bounds at the vertices; each output is a row from above and one from below. A row that is
/// not affine bends the set it cuts, with a vertex for every pair of columns; where that would leave more than 24 of them (256 in the plane), it is
/// taken as the half-space `mid [J_j] x <= const` with the widest of the remainders at the vertices, so that the number of vertices stays that of a polytope cut
/// by half-spaces.
///
/// **Guarantee:** superset of the solution set, rounding included, and a subset of `X` but for rounding.
/// **Source:** paper 004, Theorem 2; see [`polytopic_solution`]. Its remainders have weights that the rows share, but not with the points; here
/// they are the points' own, or each row has its own.
///
/// # Errors
/// As [`polytopic_solution`], but an empty set is a valid answer; outputs with an unbounded side on both ends need not be smooth;
/// [`BoundError::EmptyInterval`] for a side of `[y]`; [`SetError::OverBudget`] where the cuts leave more than 128 columns and twice those of the set.
pub fn polytopic_strips(
    g: &dyn DynFunction,
    (set, noise): (&VPolytope, &[Interval]),
    y: &[Interval],
    at: Expansion<'_>,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<PolytopicCut, BoundError> {
    BoundError::check_size(Operand::Outputs, g.outputs(), y.len())?;
    if let Some(index) = y.iter().position(Interval::is_empty) {
        return Err(BoundError::EmptyInterval { operand: Operand::Outputs, index });
    }
    let n = set.dim();
    let is_asked_for = |output: usize| y[output] != Interval::ENTIRE;
    let rows = Expanded::over_product(g, (set, noise), is_asked_for, at, p, &mut workspace.jet)?;
    let mut solution = set.clone();
    for (output, required) in y.iter().enumerate().filter(|(output, _)| is_asked_for(*output)) {
        let noises = noise.iter().enumerate().fold(Interval::ZERO, |sum, (k, &v)| sum + rows.share(output, n + k, v));
        for from_above in [true, false] {
            let bound = if from_above { required.hi() } else { -required.lo() };
            if !bound.is_finite() {
                continue;
            }
            let spread = rows.spread(output, solution.remainder());
            let reaches = || solution.vertices().columns().map(|v| rows.reach(output, v) + noises);
            let low = |reach: Interval| if from_above { reach.lo() } else { -reach.hi() };
            let mut values: Vec<f64> = reaches().map(|reach| sub_down(low(reach), spread)).collect();
            if !values.iter().all(|value| value.is_finite()) {
                continue;
            }
            if values.iter().all(|&value| value > bound) {
                let reach = reaches().reduce(Interval::hull).unwrap_or(Interval::ENTIRE).inflate(spread);
                return Ok(PolytopicCut::ProvenEmpty { output, reach });
            }
            let kept = values.iter().filter(|&&value| value <= bound).count();
            if kept + kept * (values.len() - kept) > most_columns(n) {
                let sign = if from_above { 1.0 } else { -1.0 };
                let linear = solution.vertices().columns().map(|v| rows.linear(output, v).scale(sign));
                flatten(&mut values, &linear.collect::<Vec<_>>());
            }
            solution = solution.cut_by_values(&values, bound, THIN)?;
            let (count, limit) = (solution.num_vertices(), MOST_BETWEEN.max(2 * set.num_vertices()));
            if count > limit {
                return Err(SetError::OverBudget { count, limit }.into());
            }
        }
    }
    Ok(PolytopicCut::Left(solution))
}

/// Lowers values to those of a linear function, given at the same points, minus a constant; leaves them where that overflows.
fn flatten(values: &mut [f64], linear: &[Interval]) {
    let gap = |(value, at): (&f64, &Interval)| (*at - Interval::point(*value)).hi();
    let widest = values.iter().zip(linear).map(gap).fold(f64::NEG_INFINITY, f64::max);
    let lowered: Vec<f64> = linear.iter().map(|at| sub_down(at.lo(), widest)).collect();
    if lowered.iter().all(|value| value.is_finite()) {
        values.copy_from_slice(&lowered);
    }
}
