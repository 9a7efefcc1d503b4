//! Solution sets in V-polytopes as constrained zonotopes: the simplex over the vertices, all rows at once.

use scalars::Interval;
use scalars::rounding::add_up;
use setrep::{ConstrainedZonotope, HPolytope, Matrix, VPolytope};

use super::polytopic::rows_over;
use crate::{BoundError, DynFunction, Expansion, Workspace};

/// The solution set of [`polytopic_solution`](super::polytopic_solution) with all rows at once, as a constrained zonotope.
///
/// `{ sum_i l_i v_i : l in the unit simplex, sum_i l_i low_ji <= b_j + |[J_j]| r for all j } + [-r, r]`: with `l = (1 + xi) / 2` one generator a
/// vertex, one constraint for the simplex and one a row. Its support function costs one linear program with a proven bound, in any
/// dimension, where the vertices of [`polytopic_solution`](super::polytopic_solution) would be too many. The weights of all rows are the same,
/// but the rows are not evaluated anew where others have cut: neither set contains the other.
///
/// **Guarantee:** superset of the solution set, rounding included; a subset of that of paper 004 but for rounding.
/// **Source:** paper 004, Theorem 2, with equal weights of points and remainders.
///
/// # Errors
/// As [`polytopic_solution`](super::polytopic_solution), but an empty set is a valid answer.
pub fn polytopic_solution_lift(
    g: &dyn DynFunction,
    set: &VPolytope,
    y: &HPolytope,
    at: Expansion<'_>,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<ConstrainedZonotope, BoundError> {
    let rows = rows_over(g, set, y, at, p, workspace)?;
    let (count, m) = (set.num_vertices(), y.num_half_spaces());
    let mut constraints = Matrix::zeros(m + 1, count);
    let mut ranges = Vec::with_capacity(m + 1);
    constraints.as_mut_slice().iter_mut().step_by(m + 1).for_each(|one| *one = 1.0);
    ranges.push(Interval::point(2.0 - count as f64));
    for (j, &offset) in y.offsets().iter().enumerate() {
        let mut level = Interval::point(add_up(offset, rows.spread(j, set.remainder())));
        for (i, vertex) in set.vertices().columns().enumerate() {
            // A float below half of the bound, though a half may underflow.
            let half = Interval::point(rows.reach(j, vertex).lo()).scale(0.5).lo();
            constraints[(j + 1, i)] = half;
            level -= Interval::point(half);
        }
        if !level.is_bounded() {
            return Err(BoundError::UnboundedResult { output: j });
        }
        ranges.push(Interval::new(f64::NEG_INFINITY, level.hi()).unwrap_or(Interval::ENTIRE));
    }
    let simplex = ConstrainedZonotope::from_v_polytope(set)?;
    Ok(ConstrainedZonotope::with_constraints(simplex.unconstrained(), &constraints, &ranges)?)
}
