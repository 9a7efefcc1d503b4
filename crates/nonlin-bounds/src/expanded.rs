//! A function around a point of a box, by the mean value theorem.

use scalars::Interval;
use scalars::rounding::{add_up, mul_up};
use setrep::{IntervalVector, Matrix, VPolytope, Zonotope};

use crate::function::evaluate;
use crate::{BoundError, DynFunction, Expansion, Jet, Operand, Order, Smoothness};

/// `f(x) = f(x_0) + J (x - x_0)` with some `J` in `[J]` for every `x` of a box that contains `x_0`; the entries of `J` depend on `x`.
pub(crate) struct Expanded {
    /// `x_0`.
    point: Vec<f64>,
    /// `f(x_0)`.
    value: Vec<Interval>,
    /// `[J]` over the box, row by row.
    jacobian: Vec<Interval>,
}

impl Expanded {
    /// Expands `f` over the interval hull of a polytope; its center, for [`Expansion::SetCenter`], is the mean of the vertices.
    pub(crate) fn over(
        f: &dyn DynFunction,
        set: &VPolytope,
        at: Expansion<'_>,
        p: &[Interval],
        jet: &mut Jet,
    ) -> Result<Self, BoundError> {
        Self::over_product(f, (set, &[]), |_| true, at, p, jet)
    }

    /// Expands `f` over the interval hull of a polytope and a box of noises, whose center is its middle. Outputs that are not asked for need not be
    /// smooth or bounded; nothing is to be concluded from them.
    pub(crate) fn over_product(
        f: &dyn DynFunction,
        (set, noise): (&VPolytope, &[Interval]),
        is_asked_for: impl Fn(usize) -> bool,
        at: Expansion<'_>,
        p: &[Interval],
        jet: &mut Jet,
    ) -> Result<Self, BoundError> {
        let n = f.variables();
        BoundError::check_size(Operand::Variables, n, set.dim() + noise.len())?;
        let share = 1.0 / set.num_vertices() as f64;
        let mut mean: Vec<f64> = (0..set.dim()).map(|k| set.vertices().columns().map(|v| v[k] * share).sum()).collect();
        mean.extend(noise.iter().map(Interval::mid));
        let hull: IntervalVector = set.interval_hull().iter().chain(noise).copied().collect();
        BoundError::check_box(Operand::Hull, n, &hull)?;
        let mut point = vec![0.0; n];
        at.of_zonotope(&Zonotope::point(&mean)?, &hull, &mut point)?;
        evaluate(f, Order::Jacobian, &hull, p, jet)?;
        BoundError::check_smooth_where(jet, Smoothness::C1, &is_asked_for)?;
        let jacobian = jet.jacobian().to_vec();
        evaluate(f, Order::Value, &IntervalVector::point(&point), p, jet)?;
        let value = jet.values().to_vec();
        let unbounded =
            |i: &usize| !(value[*i].is_bounded() && jacobian[i * n..(i + 1) * n].iter().all(Interval::is_bounded));
        match (0..value.len()).filter(|&i| is_asked_for(i)).find(unbounded) {
            Some(output) => Err(BoundError::UnboundedResult { output }),
            None => Ok(Self { point, value, jacobian }),
        }
    }

    /// Number of outputs.
    pub(crate) fn outputs(&self) -> usize {
        self.value.len()
    }

    /// Row `i` of `[J]`.
    fn row(&self, i: usize) -> &[Interval] {
        let n = self.point.len();
        &self.jacobian[i * n..(i + 1) * n]
    }

    /// `f_i(x_0) + [J_i] (x - x_0)`; coordinates that `x` does not have stay at `x_0`.
    pub(crate) fn reach(&self, i: usize, x: &[f64]) -> Interval {
        self.row(i).iter().zip(x.iter().zip(&self.point)).fold(self.value[i], |sum, (slope, (&x, &x0))| {
            if x == x0 { sum } else { sum + *slope * (Interval::point(x) - Interval::point(x0)) }
        })
    }

    /// `[J_ik] (x_k - x_0k)` for the values of one coordinate.
    pub(crate) fn share(&self, i: usize, k: usize, values: Interval) -> Interval {
        let slope = self.row(i)[k];
        if slope == Interval::ZERO { Interval::ZERO } else { slope * (values - Interval::point(self.point[k])) }
    }

    /// `mid [J_i]` times `x`, for as many coordinates as `x` has.
    pub(crate) fn linear(&self, i: usize, x: &[f64]) -> Interval {
        let terms = self.row(i).iter().zip(x);
        terms.fold(Interval::ZERO, |sum, (slope, &x)| sum + Interval::point(x).scale(slope.mid()))
    }

    /// `[J_i] e` for `|e| <= r`, as a half-width.
    pub(crate) fn spread(&self, i: usize, r: &[f64]) -> f64 {
        let terms = self.row(i).iter().zip(r).filter(|(_, r)| **r != 0.0);
        terms.fold(0.0, |sum, (slope, &r)| add_up(sum, mul_up(slope.mag(), r)))
    }

    /// The function `A f` of the rows `A`.
    pub(crate) fn combined(&self, normals: &Matrix) -> Self {
        let (n, rows) = (self.point.len(), normals.rows());
        let mut combined = Self {
            point: self.point.clone(),
            value: vec![Interval::ZERO; rows],
            jacobian: vec![Interval::ZERO; rows * n],
        };
        for i in 0..self.outputs() {
            for j in 0..rows {
                let a = normals[(j, i)];
                if a != 0.0 {
                    combined.value[j] += self.value[i].scale(a);
                    for k in 0..n {
                        let slope = &mut combined.jacobian[j * n + k];
                        *slope += self.jacobian[i * n + k].scale(a);
                    }
                }
            }
        }
        combined
    }
}
