//! Outer polytopes of bounded size: a template of directions chosen by what they cut off.

use boxlp::{Problem, Solver};
use scalars::Interval;

use super::HPolytope;
use super::frame::Frame;
use crate::reduce::eigenvectors;
use crate::{Matrix, SetError, SupportFunction, VPolytope, Workspace};

/// Half-spaces that cut off less than this share of the set's width are left out.
const NOTHING: f64 = 1e-9;

impl HPolytope {
    /// A polytope around a convex set with at most `max_half_spaces` half-spaces, whose directions suit the set: those of
    /// [`enclosing_along`](Self::enclosing_along) among the principal axes of its support vectors, and the diagonals of pairs of axes
    /// and of principal axes.
    ///
    /// **Guarantee:** superset of the set, with no more half-spaces than asked for.
    ///
    /// # Errors
    /// As [`enclosing_along`](Self::enclosing_along).
    ///
    /// ```
    /// # use setrep::{HPolytope, Matrix, Workspace, Zonotope};
    /// let slanted = Zonotope::new(&[0.0, 0.0], &Matrix::from_rows(&[&[2.0, 0.1], &[2.0, -0.1]])?)?;
    /// let outer = HPolytope::enclosing(&slanted, 8, &mut Workspace::new())?;
    /// assert!(outer.num_half_spaces() <= 8 && outer.volume()?.hi() < 1.601);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn enclosing(
        set: &dyn SupportFunction,
        max_half_spaces: usize,
        workspace: &mut Workspace,
    ) -> Result<Self, SetError> {
        let directions = template(set, workspace)?;
        Self::enclosing_along(set, &directions, max_half_spaces, workspace)
    }

    /// A polytope around a convex set with at most `max_half_spaces` half-spaces: its interval hull, and of the given directions
    /// (columns, `n x k`) those that cut off most.
    ///
    /// The directions are taken one at a time: next is the one in which the polytope so far reaches beyond the set by the largest share
    /// of the set's width there, `(h_P(d) - h(d)) / sum_k |d_k| w_k`, until nothing is to gain. The offsets are the supports of the
    /// set, so the choice affects the size of the result, not its guarantee. Half-spaces that became redundant are dropped.
    ///
    /// **Guarantee:** superset of the set, with no more half-spaces than asked for.
    ///
    /// # Errors
    /// [`SetError::OverBudget`] for fewer than the `2n` half-spaces of a box; [`SetError::EmptySet`], proven; [`SetError::Unbounded`] if
    /// the supports along the axes are not finite; [`SetError::Dimension`], [`SetError::NonFinite`] for the directions; what the set's own
    /// supports say.
    pub fn enclosing_along(
        set: &dyn SupportFunction,
        directions: &Matrix,
        max_half_spaces: usize,
        workspace: &mut Workspace,
    ) -> Result<Self, SetError> {
        let n = set.dim();
        if max_half_spaces < 2 * n {
            return Err(SetError::OverBudget { count: 2 * n, limit: max_half_spaces });
        }
        let hull = set.interval_hull(workspace)?;
        if hull.iter().any(Interval::is_empty) {
            return Err(SetError::EmptySet);
        }
        if !hull.iter().all(Interval::is_bounded) {
            return Err(SetError::Unbounded);
        }
        let supports = set.support_vectors(directions, &mut Matrix::zeros(n, 0), workspace)?;
        if supports.contains(&f64::NEG_INFINITY) {
            return Err(SetError::EmptySet);
        }
        let chosen = Greedy::new(&hull, directions, &supports)?.choose(max_half_spaces - 2 * n);
        let mut normals = Matrix::zeros(chosen.len(), n);
        for (i, &j) in chosen.iter().enumerate() {
            directions.col(j).iter().enumerate().for_each(|(k, &d)| normals[(i, k)] = d);
        }
        let offsets: Vec<f64> = chosen.iter().map(|&j| supports[j]).collect();
        let all = Self::from_intervals(&hull)?.intersection(&Self::new(normals, &offsets)?)?;
        all.drop_redundant(workspace)
    }

    /// The set with at most `max_half_spaces` half-spaces: the set itself without redundant ones if that is enough, otherwise its
    /// bounding box and those of its half-spaces that cut off most; see [`enclosing_along`](Self::enclosing_along).
    ///
    /// **Guarantee:** superset of the set, with no more half-spaces than asked for.
    ///
    /// # Errors
    /// As [`enclosing_along`](Self::enclosing_along).
    pub fn simplified(&self, max_half_spaces: usize, workspace: &mut Workspace) -> Result<Self, SetError> {
        let slim = self.drop_redundant(workspace)?;
        if slim.num_half_spaces() <= max_half_spaces {
            return Ok(slim);
        }
        Self::enclosing_along(&slim, &slim.normals.transpose(), max_half_spaces, workspace)
    }
}

impl VPolytope {
    /// A half-space form of bounded size around the set; see [`HPolytope::enclosing`].
    ///
    /// **Guarantee:** superset of the set, with no more half-spaces than asked for.
    ///
    /// # Errors
    /// As [`HPolytope::enclosing_along`].
    pub fn enclosing_h_polytope(
        &self,
        max_half_spaces: usize,
        workspace: &mut Workspace,
    ) -> Result<HPolytope, SetError> {
        HPolytope::enclosing(self, max_half_spaces, workspace)
    }
}

/// The polytope being built, in the frame of the box around the set: plain floating point, for the choice of directions only.
struct Greedy {
    solver: Solver,
    /// Rows `(S d)'xi <= h - d'c`, scaled to the width of the set in `d`.
    rows: Vec<(Vec<f64>, f64)>,
    /// The last known gain of each row, which can only have fallen since.
    gains: Vec<f64>,
}

impl Greedy {
    fn new(hull: &[Interval], directions: &Matrix, supports: &[f64]) -> Result<Self, SetError> {
        let frame = Frame::around(hull, 1.0)?;
        let overflow = |_| SetError::Overflow { row: 0 };
        let mut problem = Problem::new(hull.len()).map_err(overflow)?;
        for (k, side) in hull.iter().enumerate() {
            let mut row = vec![0.0; hull.len()];
            row[k] = 1.0;
            let reach = side.rad() / frame.scales[k];
            problem.push_row(&row, -reach, reach).map_err(overflow)?;
        }
        let rows: Vec<(Vec<f64>, f64)> = directions
            .columns()
            .zip(supports)
            .map(|(d, &support)| {
                let terms = || d.iter().zip(hull).zip(&frame.center);
                let width: f64 = terms().map(|((d, side), _)| d.abs() * side.width()).sum();
                let middle: f64 = terms().map(|((d, _), c)| d * c).sum();
                let row = d.iter().zip(&frame.scales).map(|(d, s)| d * s / width).collect();
                (row, (support - middle) / width)
            })
            .collect();
        // Directions without width, or whose numbers overflow, are no candidates.
        let usable = |(row, offset): &(Vec<f64>, f64)| offset.is_finite() && row.iter().all(|x| x.is_finite());
        let gains = rows.iter().map(|row| if usable(row) { f64::INFINITY } else { 0.0 }).collect();
        Ok(Self { solver: Solver::new(problem), rows, gains })
    }

    /// Indices of at most `count` rows, the one that cuts off most first.
    fn choose(mut self, count: usize) -> Vec<usize> {
        let mut chosen = Vec::new();
        while chosen.len() < count {
            let best = (0..self.gains.len()).max_by(|&i, &j| self.gains[i].total_cmp(&self.gains[j]));
            let Some(best) = best.filter(|&best| self.gains[best] > NOTHING) else { break };
            let before = self.gains[best];
            let (row, offset) = &self.rows[best];
            let gain = self.solver.maximize(row).map_or(0.0, |solution| solution.bound - offset);
            self.gains[best] = gain.min(before);
            let next = self.gains.iter().enumerate().filter(|(k, _)| *k != best).map(|(_, gain)| *gain);
            if gain > NOTHING && gain >= next.fold(0.0, f64::max) {
                if self.solver.push_row(row, f64::NEG_INFINITY, *offset).is_ok() {
                    chosen.push(best);
                }
                self.gains[best] = 0.0;
            }
        }
        chosen
    }
}

/// Directions that suit a set: both signs of its principal axes, and of the sums and differences of two axes, in units of the widths
/// along them.
pub(super) fn template(set: &dyn SupportFunction, workspace: &mut Workspace) -> Result<Matrix, SetError> {
    let n = set.dim();
    let hull = set.interval_hull(workspace)?;
    let widths: Vec<f64> = hull.iter().map(Interval::width).collect();
    let unit = |k: usize| if widths[k] > 0.0 && widths[k].is_finite() { 1.0 / widths[k] } else { 1.0 };
    let mut axes = Matrix::zeros(n, n);
    (0..n).for_each(|k| axes[(k, k)] = unit(k));
    let diagonals = signed_pairs(&axes);
    let mut points = Matrix::zeros(n, 0);
    let asked = concatenated(&diagonals, &concatenated(&axes, &negated(&axes)));
    set.support_vectors(&asked, &mut points, workspace)?;
    // Principal axes of the points in units of the widths.
    let center = hull.mid();
    let mut covariance = vec![0.0; n * n];
    for point in points.columns().filter(|point| point.iter().all(|x| x.is_finite())) {
        for k in 0..n {
            for i in 0..n {
                covariance[k * n + i] += (point[i] - center[i]) * unit(i) * (point[k] - center[k]) * unit(k);
            }
        }
    }
    let variances = |covariance: &[f64], k: usize| covariance[k * n + k].max(1e-300).sqrt();
    let mut vectors = Vec::new();
    eigenvectors(&mut covariance, n, &mut vectors);
    let mut principal = Matrix::zeros(n, n);
    for k in 0..n {
        for i in 0..n {
            principal[(i, k)] = vectors[k * n + i] * unit(i) / variances(&covariance, k);
        }
    }
    let all = concatenated(&concatenated(&principal, &negated(&principal)), &signed_pairs(&principal));
    let mut template = concatenated(&all, &diagonals);
    // Directions of size 1: their supports neither overflow nor vanish.
    for k in 0..template.cols() {
        let largest = template.col(k).iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        template.col_mut(k).iter_mut().for_each(|x| *x = if largest.is_normal() { *x / largest } else { 0.0 });
    }
    Ok(template)
}

/// `+-a +- b` for every two columns.
fn signed_pairs(columns: &Matrix) -> Matrix {
    let mut pairs = Matrix::zeros(columns.rows(), 0);
    for j in 0..columns.cols() {
        for i in 0..j {
            for (s, t) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
                let pair: Vec<f64> = columns.col(i).iter().zip(columns.col(j)).map(|(a, b)| s * a + t * b).collect();
                pairs.append_columns(&pair);
            }
        }
    }
    pairs
}

fn negated(columns: &Matrix) -> Matrix {
    let mut negated = columns.clone();
    negated.as_mut_slice().iter_mut().for_each(|x| *x = -*x);
    negated
}

fn concatenated(left: &Matrix, right: &Matrix) -> Matrix {
    let mut both = left.clone();
    both.append_columns(right.as_slice());
    both
}
