//! A member of the family of enclosures of an intersection with a strip, rounding included.

use scalars::Interval;
use scalars::rounding::{add_up, mul_up};

use crate::bounds::{add_lengths, gamma, product_sum_bound, underflow_bound};
use crate::{SetError, Workspace, Zonotope};

impl Zonotope {
    /// Replaces the set by `< c + l (m - a'c), [(I - l a') G, sigma l], |I - l a'| r >` for the bounded strip `a'x in m +- sigma` and the
    /// weights `l` in `workspace.scales`. The generator `replaced`, which the weights make zero up to rounding, gives its place to
    /// `sigma l`; what rounding leaves of it goes to the remainder, as does all other rounding.
    ///
    /// With `t_j = a'g_j` as computed, `g_ij - l_i t_j` goes through at most `n + 2` roundings, so the entries of a row are off by at most
    /// `gamma_{n+3} sum_j (|g_ij| + |l_i| sum_k |a_k g_kj|)` together, underflow aside. Rows with `l_i = 0` are exact.
    ///
    /// After an error the set is unchanged.
    pub(super) fn replace_by_member(
        &mut self,
        a: &[f64],
        range: Interval,
        replaced: Option<usize>,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        let n = self.dim();
        let columns = self.num_generators();
        let (middle, sigma) = (range.mid(), range.rad());
        let Workspace { scales: weights, coordinates: along, remainder, center, frame: strip, .. } = workspace;

        // a'g_j, and the sum over all j of sum_k |a_k g_kj|.
        along.clear();
        let mut reach = 0.0;
        for column in self.generators.columns() {
            let mut sum = 0.0;
            for (a, g) in a.iter().zip(column) {
                let product = a * g;
                sum += product;
                reach += product.abs();
            }
            along.push(sum);
        }
        let products = columns * n;
        let reach = product_sum_bound(reach, products, n + columns);
        // Weights can be zero because a product overflowed; NaN fails the comparison.
        let representable = reach < f64::MAX;
        if !representable {
            return Err(SetError::Overflow { row: 0 });
        }

        let mut innovation = Interval::point(middle);
        for (&a, &c) in a.iter().zip(&self.center).filter(|(a, _)| **a != 0.0) {
            innovation -= Interval::point(c).scale(a);
        }
        center.clear();
        strip.clear();
        remainder.clear();
        for i in 0..n {
            let weight = weights[i];
            // What the weights leave of the generator that gives its place, all of it where a weight has underflowed.
            let leftover = replaced.map_or(0.0, |j| (self.generators.col(j)[i] - weight * along[j]).abs());
            if weight == 0.0 {
                center.push(self.center[i]);
                strip.push(0.0);
                remainder.push(add_lengths(self.remainder[i], leftover));
                continue;
            }
            let extent: f64 = self.generators.columns().map(|column| column[i].abs()).sum();
            let magnitude = add_up(product_sum_bound(extent, columns, columns), mul_up(weight.abs(), reach));
            let lost = mul_up(add_up(1.0, weight.abs()), underflow_bound(products + columns));
            let rounding = add_up(product_sum_bound(gamma(n + 3) * magnitude, products, 1), lost);

            let moved = Interval::point(self.center[i]) + innovation.scale(weight);
            let segment = Interval::point(weight).scale(sigma);
            let mut rest = add_lengths(moved.rad(), segment.rad());
            rest = add_lengths(rest, add_lengths(rounding, leftover));
            for (k, (&a, &r)) in a.iter().zip(&self.remainder).enumerate() {
                if r > 0.0 {
                    let share = Interval::point(weight).scale(a);
                    let kept = if k == i { Interval::ONE - share } else { share };
                    rest = add_lengths(rest, mul_up(kept.mag(), r));
                }
            }
            center.push(moved.mid());
            strip.push(segment.mid());
            remainder.push(rest);
            // The magnitude bounds every entry and partial sum; NaN fails the comparison.
            let bounded = magnitude + rest < f64::MAX && center[i].is_finite() && strip[i].is_finite();
            if !bounded {
                return Err(SetError::Overflow { row: i });
            }
        }

        for (column, &t) in self.generators.as_mut_slice().chunks_exact_mut(n).zip(along.iter()) {
            for (g, weight) in column.iter_mut().zip(weights.iter()) {
                *g -= weight * t;
            }
        }
        match replaced {
            Some(j) => self.generators.col_mut(j).copy_from_slice(strip),
            None => self.generators.append_columns(strip),
        }
        self.center.copy_from_slice(center);
        self.remainder.copy_from_slice(remainder);
        Ok(())
    }
}
