//! The box remainder taken into the hull.

use scalars::rounding::{add_up, div_up, mul_up, sub_down};

use super::VPolytope;
use super::walk::{Walk, residual};

/// A remainder that would make the set larger by more than this share stays.
const LARGEST: f64 = 1e-2;

/// Share of the way to the boundary of the points that prove the hull to be thick.
const WITHIN: f64 = 0.99;

impl VPolytope {
    /// The set with its remainder taken into the hull, `conv V + [-r, r]` in `conv { v + eps (v - c) }`: as many columns, `r = 0`.
    ///
    /// Points `c +- t_k e_k` are proven to lie in `conv V`, so `[-r, r]` lies in `eps (conv V - c)` with `eps = sum_k r_k / t_k`. A remainder grows
    /// with `|J|` from step to step, a hull with `J`: sets that are propagated should not carry one. Where the hull is flat, or too thin
    /// for `r` (`eps` above one percent), the set is returned as it is.
    ///
    /// **Guarantee:** superset of the set, rounding included.
    ///
    /// ```
    /// # use setrep::{Matrix, VPolytope};
    /// let columns = Matrix::from_columns(&[&[0.0, 0.0], &[3.0, 0.0], &[0.0, 3.0]])?;
    /// let rounded = VPolytope::with_remainder(columns, &[1e-12, 1e-12])?;
    /// let exact = rounded.absorb_remainder();
    /// assert!(exact.remainder() == [0.0, 0.0] && exact.num_vertices() == 3);
    /// assert!(exact.support(&[1.0, 1.0])? < 3.0 + 1e-11);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    #[must_use]
    pub fn absorb_remainder(&self) -> Self {
        if self.is_exact() { self.clone() } else { self.scaled_up().unwrap_or_else(|| self.clone()) }
    }

    /// The set scaled about a point inside until it holds the remainder.
    fn scaled_up(&self) -> Option<Self> {
        let n = self.dim();
        let mut walk = Walk::new(&self.vertices)?;
        if walk.rank() < n {
            return None;
        }
        walk.kept = (0..self.num_vertices()).collect();
        let center = walk.center.clone();
        let (mut reach, mut missed) = (vec![f64::INFINITY; n], vec![0.0_f64; n]);
        let mut lost = vec![0.0; n];
        for at in 0..n {
            let k = walk.coordinates[at];
            for sign in [1.0, -1.0] {
                let mut axis = vec![0.0; n];
                axis[at] = sign;
                let (t, mut weights) = walk.shoot(&axis, WITHIN)?;
                let mut x = center.clone();
                x[k] += sign * WITHIN * t * walk.units[k];
                if !residual(&self.vertices, &x, &mut weights, &mut lost) {
                    return None;
                }
                missed.iter_mut().zip(&lost).for_each(|(all, e)| *all = all.max(*e));
                reach[k] = reach[k].min(sub_down(x[k].max(center[k]), x[k].min(center[k])));
            }
        }
        // With the roundings d of the new columns: [-(r + d + e)] lies in eps (cross-polytope), that in eps (conv V - c + [-e]). What two
        // sides of an inclusion of convex sums have in common cancels.
        let hull = self.interval_hull();
        let mut share = 0.0;
        for k in 0..n {
            let rounding = mul_up(8.0 * f64::EPSILON, hull[k].mag()) + f64::MIN_POSITIVE;
            let length = add_up(add_up(self.remainder[k], rounding), missed[k]);
            share = add_up(share, div_up(length, reach[k]));
        }
        if !(share <= LARGEST && reach.iter().all(|&t| t > 0.0)) {
            return None;
        }
        let mut vertices = self.vertices.clone();
        for j in 0..vertices.cols() {
            vertices.col_mut(j).iter_mut().zip(&center).for_each(|(v, c)| *v += share * (*v - c));
        }
        if vertices.as_slice().iter().any(|x| !x.is_finite()) {
            return None;
        }
        Some(Self { vertices, remainder: vec![0.0; n] })
    }
}
