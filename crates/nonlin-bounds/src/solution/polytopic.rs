//! Solution sets in V-polytopes, cut vertex by vertex.

use scalars::Interval;
use scalars::rounding::add_up;
use setrep::{HPolytope, Matrix, SetError, VPolytope};

use crate::expanded::Expanded;
use crate::{BoundError, DynFunction, Expansion, Operand, Workspace};

/// Where the widths of a row at the vertices differ by less than this share of its values, it is as good as affine.
const THIN: f64 = 1e-12;

/// Solution set `{ x in X : g(x, p) in Y }` in a polytope `X = conv V + [-r, r]`, `Y = { y : A y <= b }`.
///
/// For `x = sum_i l_i v_i + e` with `l` in the unit simplex, row `j` of `A g(x) <= b` implies
/// `sum_i l_i low_ji <= b_j + |[J_j]| r`, `low_ji` the least value of `A_j g(x_0) + [J_j] (v_i - x_0)`, `[J]` the range of the Jacobian of `A g`
/// over the interval hull of `X`. So a row leaves the points below which the hull of the points `(v_i, low_ji)` in `R^(n+1)` reaches
/// down to the level, a polytope whose edges are found exactly. The rows are taken in turn; each is evaluated at the vertices
/// that the ones before have left. A row affine in `x` is an intersection with a half-space.
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
    at: Expansion<'_>,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<VPolytope, BoundError> {
    let rows = rows_over(g, set, y, at, p, workspace)?;
    let mut solution = set.clone();
    for (j, &offset) in y.offsets().iter().enumerate() {
        let level = add_up(offset, rows.spread(j, solution.remainder()));
        solution = cut(solution, &rows, j, level)?;
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

/// Cuts a set by row `j`, `sum_i l_i low_i <= level`, with `low_i` the least value of the row at vertex `i`.
fn cut(set: VPolytope, rows: &Expanded, j: usize, level: f64) -> Result<VPolytope, SetError> {
    let low: Vec<f64> = set.vertices().columns().map(|v| rows.reach(j, v).lo()).collect();
    // A row without a lower bound at some vertex says nothing.
    if low.contains(&f64::NEG_INFINITY) || low.iter().all(|&low| low <= level) {
        return Ok(set);
    }
    if low.iter().all(|&low| low > level) {
        return Err(SetError::EmptySet);
    }
    let hull = VPolytope::new(set.vertices().clone())?;
    let slope = rows.middle(j);
    let gap = |(v, &low): (&[f64], &f64)| {
        let linear =
            v.iter().zip(&slope).fold(Interval::point(-low), |sum, (&x, &a)| sum + Interval::point(x).scale(a));
        linear.hi()
    };
    let gaps = || set.vertices().columns().zip(&low).map(gap);
    let (widest, narrowest) = (gaps().fold(f64::NEG_INFINITY, f64::max), gaps().fold(f64::INFINITY, f64::min));
    let extent =
        low.iter().fold(f64::NEG_INFINITY, |m, &x| m.max(x)) - low.iter().fold(f64::INFINITY, |m, &x| m.min(x));
    let kept = if widest - narrowest <= THIN * extent {
        // a'v_i <= low_i + widest for all i, so the weights that are left fulfil a'x <= level + widest.
        hull.intersection(&HPolytope::new(Matrix::from_rows(&[&slope])?, &[add_up(level, widest)])?)?
    } else {
        below(&hull, &low, level)?
    };
    let remainder: Vec<f64> = set.remainder().iter().zip(kept.remainder()).map(|(&r, &lost)| add_up(r, lost)).collect();
    VPolytope::with_remainder(kept.vertices().clone(), &remainder)?.remove_redundant()
}

/// `{ sum_i l_i v_i : sum_i l_i low_i <= level }`: the hull of the points `(v_i, low_i)` up to the level, seen from above.
fn below(hull: &VPolytope, low: &[f64], level: f64) -> Result<VPolytope, SetError> {
    let n = hull.dim();
    let mut lifted = Matrix::zeros(n + 1, 0);
    for (v, &low) in hull.vertices().columns().zip(low) {
        lifted.push_col(&[v, &[low]].concat())?;
    }
    let mut up = Matrix::zeros(1, n + 1);
    up[(0, n)] = 1.0;
    let left = VPolytope::new(lifted)?.intersection(&HPolytope::new(up, &[level])?)?;
    let mut vertices = Matrix::zeros(n, 0);
    left.vertices().columns().try_for_each(|v| vertices.push_col(&v[..n]))?;
    VPolytope::with_remainder(vertices, &left.remainder()[..n])
}
