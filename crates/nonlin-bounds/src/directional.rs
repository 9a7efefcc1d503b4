//! [`Directional`]: ranges of derivatives along axes and generators.

use scalars::Interval;
use scalars::rounding::{add_up, mul_up};
use setrep::ConstrainedZonotope;

use crate::function::evaluate;
use crate::range::enclose_as_far_as_possible;
use crate::{BoundError, DynFunction, Jet, Order, Smoothness};

/// Derivatives of a function over a box, with second ones where it offers them, and first ones at a point of the box.
///
/// The derivative along `v` lies in `J v`, and where the output is `C2` also in `J(point) v + (x - point)'H v`. With `H v` formed first, the latter has no
/// width along directions in which `f` does not curve, whatever the single entries of the gradient do.
pub(crate) struct Directional {
    pub(crate) over: Jet,
    at: Jet,
    has_second: bool,
}

impl Directional {
    /// Evaluates `f` over the box `x` and at `point`.
    pub(crate) fn over(f: &dyn DynFunction, x: &[Interval], point: &[f64], p: &[Interval]) -> Result<Self, BoundError> {
        let (mut over, mut at) = (Jet::new(), Jet::new());
        let order = enclose_as_far_as_possible(f, x, p, &mut over)?;
        if order == Order::Value {
            return Err(BoundError::OrderNotAvailable { order: Order::Jacobian as usize });
        }
        let point: Vec<Interval> = point.iter().map(|&x| Interval::point(x)).collect();
        evaluate(f, Order::Jacobian, &point, p, &mut at)?;
        Ok(Self { over, at, has_second: order == Order::Hessian })
    }

    /// Derivatives of output `i` by the coordinates of the box `x` about `point`.
    pub(crate) fn along_axes(&self, i: usize, x: &[Interval], point: &[f64]) -> Vec<Interval> {
        let n = x.len();
        let unit = |k: usize| (0..n).map(|l| if l == k { 1.0 } else { 0.0 }).collect::<Vec<_>>();
        let along = |k: usize| {
            let (first, second) = self.along(i, &unit(k));
            let terms = second.iter().zip(x.iter().zip(point));
            first.intersection(
                terms.fold(self.slope_at(i, &unit(k)), |sum, (h, (side, &c))| sum + *h * side.add_f64(-c)),
            )
        };
        (0..n).map(along).collect()
    }

    /// Derivatives of output `i` by the coordinates `xi` of a set whose center is the point and whose hull, without the constraints, is the box.
    pub(crate) fn along_generators(&self, i: usize, set: &ConstrainedZonotope) -> Vec<Interval> {
        let along = |column: &[f64]| {
            let (first, second) = self.along(i, column);
            // |(x - c)'H v| <= sum_k |G_k'H v| + r'|H v|.
            let dot = |g: &[f64]| g.iter().zip(&second).fold(Interval::ZERO, |sum, (&g, h)| sum + h.scale(g)).mag();
            let reach = set.generators().columns().fold(0.0, |sum, g| add_up(sum, dot(g)));
            let remainder = set.remainder().iter().zip(&second).filter(|(r, _)| **r > 0.0);
            let reach = remainder.fold(reach, |sum, (&r, h)| add_up(sum, mul_up(r, h.mag())));
            first.intersection(self.slope_at(i, column).inflate(reach))
        };
        set.generators().columns().map(along).collect()
    }

    /// `[J_i] v` and `[H_i] v` over the box; the latter the whole line where nothing is known of it.
    fn along(&self, i: usize, v: &[f64]) -> (Interval, Vec<Interval>) {
        let n = v.len();
        let slopes = &self.over.jacobian()[i * n..(i + 1) * n];
        let first = slopes.iter().zip(v).fold(Interval::ZERO, |sum, (j, &v)| sum + j.scale(v));
        if !self.has_second || self.over.smoothness()[i] < Smoothness::C2 {
            return (first, vec![Interval::ENTIRE; n]);
        }
        let size = n * (n + 1) / 2;
        let mut entries = self.over.hessians()[i * size..(i + 1) * size].iter();
        let mut second = vec![Interval::ZERO; n];
        for j in 0..n {
            for (k, h) in (j..n).zip(&mut entries) {
                second[j] += h.scale(v[k]);
                if k > j {
                    second[k] += h.scale(v[j]);
                }
            }
        }
        (first, second)
    }

    /// `J_i v` at the point.
    fn slope_at(&self, i: usize, v: &[f64]) -> Interval {
        let slopes = &self.at.jacobian()[i * v.len()..(i + 1) * v.len()];
        slopes.iter().zip(v).fold(Interval::ZERO, |sum, (j, &v)| sum + j.scale(v))
    }
}
