//! A sufficient test for a set in a set.

use scalars::Interval;
use scalars::rounding::add_up;

use super::correction::Correction;
use super::factorization::{Goal, factorize};
use crate::constrained_zonotope::optimizer::prepared;
use crate::{ConstrainedZonotope, Matrix, Part, SetError, Workspace};

/// Whether a set lies in another one, as far as it could be proven.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Containment {
    /// Every point of the one is proven to lie in the other.
    Proven,
    /// The test does not tell.
    Undecided,
}

impl ConstrainedZonotope {
    /// Sufficient test for `other` in `self`: coordinates `eta = beta + Gamma xi` of all points of `other` at once.
    ///
    /// With `X = other`, `Y = self` it is enough that `H (beta + Gamma xi) = c - d + G xi` whenever `A xi in [a]`, and that `eta` then
    /// satisfies what `Y` asks of it. A linear program (Sadraddini, Tedrake) finds such `Gamma`, `beta`; then the equations are made
    /// exact by a proven correction, and every bound of `eta` and of the constraints of `Y` is proven over `X`. Deciding containment is
    /// co-NP-complete; this test misses some sets that are contained, and those that touch the boundary.
    ///
    /// **Guarantee:** [`Containment::Proven`] holds for the exact sets.
    /// **Source:** Sadraddini, Tedrake 2019, Theorem 1.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if the sets live in different spaces, [`SetError::TooLarge`], [`SetError::Overflow`].
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Containment, Matrix, Workspace, Zonotope};
    /// let mut workspace = Workspace::new();
    /// let square = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// let diamond = Zonotope::new(&[0.125, 0.0], &Matrix::from_rows(&[&[0.25, 0.5], &[0.25, -0.5]])?)?;
    /// assert_eq!(square.contains_sufficient(&diamond.into(), &mut workspace)?, Containment::Proven);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn contains_sufficient(&self, other: &Self, workspace: &mut Workspace) -> Result<Containment, SetError> {
        SetError::check_size(Part::Center, self.dim(), other.dim())?;
        if other.is_proven_empty(workspace)? {
            return Ok(Containment::Proven);
        }
        let (mut inner, mut outer) = (other.clone(), self.clone());
        inner.materialize();
        outer.materialize();
        let proven = match Embedding::find(&inner, &outer)? {
            Some(embedding) => embedding.prove(&inner, &outer, workspace)?,
            None => false,
        };
        Ok(if proven { Containment::Proven } else { Containment::Undecided })
    }
}

/// `eta = Gamma xi + beta` (the last column), and the multipliers of the equality rows of the inner set.
struct Embedding {
    /// `[Gamma beta]`.
    map: Matrix,
    /// `M`: one row a row of the lift, one column an equality row of the inner set.
    multipliers: Matrix,
    /// Equality rows of the inner and of the outer set.
    inner_equalities: Vec<usize>,
    outer_equalities: Vec<usize>,
    /// `[H; B]` with the equality rows `B` of the outer set.
    lift: Matrix,
}

impl Embedding {
    /// The embedding of least largest coordinate, from the textbook forms of both sets.
    fn find(inner: &ConstrainedZonotope, outer: &ConstrainedZonotope) -> Result<Option<Self>, SetError> {
        let (n, m, own) = (inner.dim(), inner.num_generators(), outer.num_generators());
        let (x, y) = (inner.textbook_form()?, outer.textbook_form()?);
        let (p, k) = (n + y.num_constraints(), x.num_generators() + 1);
        let l = stacked(&y, &(0..y.num_constraints()).collect::<Vec<_>>());
        let mut t = Matrix::zeros(p, k);
        for j in 0..k - 1 {
            t.col_mut(j)[..n].copy_from_slice(x.generators().col(j));
        }
        for i in 0..p {
            t[(i, k - 1)] = if i < n { x.center()[i] - y.center()[i] } else { y.ranges[i - n].mid() };
        }
        let mut b = Matrix::zeros(x.num_constraints(), k);
        for e in 0..x.num_constraints() {
            (0..k - 1).for_each(|j| b[(e, j)] = x.constraints[(e, j)]);
            b[(e, k - 1)] = -x.ranges[e].mid();
        }
        let Some((c, multiplier)) = factorize(&l, &t, &b, Goal::LargestRow) else { return Ok(None) };
        // Slacks of the inner set are functions of its coordinates: zeta = (A_i xi - mid) / rad.
        let mut map = Matrix::zeros(own, m + 1);
        for j in 0..own {
            (0..m).for_each(|column| map[(j, column)] = c[(j, column)]);
            map[(j, m)] = c[(j, k - 1)];
            let wide = inner.ranges.iter().enumerate().filter(|(_, range)| range.width() > 0.0);
            for (slack, (i, range)) in (m..).zip(wide) {
                let share = c[(j, slack)] / range.rad();
                (0..m).for_each(|column| map[(j, column)] += share * inner.constraints[(i, column)]);
                map[(j, m)] -= share * range.mid();
            }
        }
        let equalities = |set: &ConstrainedZonotope| -> Vec<usize> {
            (0..set.num_constraints()).filter(|&i| set.ranges[i].width() == 0.0).collect()
        };
        let (inner_equalities, outer_equalities) = (equalities(inner), equalities(outer));
        let lifted_row = |i: usize| if i < n { i } else { n + outer_equalities[i - n] };
        let mut multipliers = Matrix::zeros(n + outer_equalities.len(), inner_equalities.len());
        for i in 0..multipliers.rows() {
            for (e, &row) in inner_equalities.iter().enumerate() {
                multipliers[(i, e)] = multiplier[(lifted_row(i), row)];
            }
        }
        let lift = stacked(outer, &outer_equalities);
        Ok(Some(Self { map, multipliers, inner_equalities, outer_equalities, lift }))
    }

    /// Polishes the embedding and proves it.
    fn prove(
        mut self,
        inner: &ConstrainedZonotope,
        outer: &ConstrainedZonotope,
        workspace: &mut Workspace,
    ) -> Result<bool, SetError> {
        let target = self.target(inner, outer);
        let Some(correction) = Correction::new(&self.lift) else { return Ok(false) };
        let mut middle = Matrix::zeros(self.lift.rows(), self.map.cols());
        middle.as_mut_slice().iter_mut().zip(&target).for_each(|(x, t)| *x = t.mid());
        correction.polish(&middle, &mut self.map);
        let rho: Vec<f64> = (0..self.lift.rows())
            .map(|i| {
                (0..self.map.cols()).fold(0.0, |sum, column| {
                    let entry = (0..self.map.rows()).fold(target[column * self.lift.rows() + i], |rest, j| {
                        rest - Interval::point(self.lift[(i, j)]) * Interval::point(self.map[(j, column)])
                    });
                    add_up(sum, entry.mag())
                })
            })
            .collect();
        let Some(slack) = correction.bounds(&rho) else { return Ok(false) };
        inner.optimizer(workspace)?;
        let solver = prepared(&mut workspace.solver)?;
        // The range of q'eta, eta = beta + Gamma xi + D, over the inner set.
        let mut range = |q: &dyn Fn(usize) -> f64| {
            let (m, own) = (self.map.cols() - 1, self.map.rows());
            let column = |column: usize| {
                (0..own)
                    .filter(|&j| q(j) != 0.0)
                    .fold(Interval::ZERO, |sum, j| sum + Interval::point(q(j)) * Interval::point(self.map[(j, column)]))
            };
            let entries: Vec<Interval> = (0..m).map(column).collect();
            let mut objective: Vec<f64> = entries.iter().map(Interval::mid).collect();
            let mut error = entries.iter().map(Interval::rad).fold(0.0, add_up);
            for (j, &bound) in slack.iter().enumerate().filter(|(j, _)| q(*j) != 0.0) {
                error = add_up(error, Interval::point(q(j).abs()).scale(bound).hi());
            }
            let mut maximum =
                |objective: &[f64]| solver.maximize(objective).map_or(f64::INFINITY, |answer| answer.bound);
            let hi = maximum(&objective);
            objective.iter_mut().for_each(|x| *x = -*x);
            let lo = -maximum(&objective);
            Interval::new(lo, hi).map_or(Interval::EMPTY, |range| (range + column(m)).inflate(error))
        };
        let unit = Interval::new(-1.0, 1.0).unwrap_or(Interval::EMPTY);
        for j in 0..outer.num_generators() {
            if !range(&|k| if k == j { 1.0 } else { 0.0 }).subset_of(&unit) {
                return Ok(false);
            }
        }
        for i in (0..outer.num_constraints()).filter(|i| !self.outer_equalities.contains(i)) {
            if !range(&|k| outer.constraints[(i, k)]).subset_of(&outer.ranges[i]) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// `[G  c - d; 0  b] + M [A  -a]`, column after column: what `[H; B] [Gamma beta]` must be.
    fn target(&self, inner: &ConstrainedZonotope, outer: &ConstrainedZonotope) -> Vec<Interval> {
        let (n, m, p) = (inner.dim(), inner.num_generators(), self.lift.rows());
        let mut target = Vec::with_capacity(p * (m + 1));
        for column in 0..=m {
            for i in 0..p {
                let start = match (column < m, i < n) {
                    (true, true) => Interval::point(inner.generators()[(i, column)]),
                    (true, false) => Interval::ZERO,
                    (false, true) => Interval::point(inner.center()[i]) - Interval::point(outer.center()[i]),
                    (false, false) => outer.ranges[self.outer_equalities[i - n]],
                };
                let sum = self.inner_equalities.iter().enumerate().fold(start, |sum, (e, &row)| {
                    let entry =
                        if column < m { Interval::point(inner.constraints[(row, column)]) } else { -inner.ranges[row] };
                    sum + Interval::point(self.multipliers[(i, e)]) * entry
                });
                target.push(sum);
            }
        }
        target
    }
}

/// `[G; A_rows]`.
pub(super) fn stacked(set: &ConstrainedZonotope, rows: &[usize]) -> Matrix {
    let n = set.dim();
    let mut lift = Matrix::zeros(n + rows.len(), set.num_generators());
    for j in 0..set.num_generators() {
        let column = lift.col_mut(j);
        column[..n].copy_from_slice(set.generators().col(j));
        column[n..].iter_mut().zip(rows).for_each(|(x, &row)| *x = set.constraints[(row, j)]);
    }
    lift
}
