//! Size of a set: F-radius and covariation.

use scalars::rounding::sqrt_up;

use crate::bounds::product_sum_bound;
use crate::{Matrix, Zonotope};

impl Zonotope {
    /// F-radius: the Frobenius norm `(sum_ij G_ij^2 + sum_i r_i^2)^(1/2)` of the generators, the box remainder counted as such.
    ///
    /// **Guarantee:** an upper bound of the exact norm, above it by rounding only; `inf` where the squares overflow.
    /// **Source:** Combastel 2015; paper 000.
    #[must_use]
    pub fn f_radius(&self) -> f64 {
        let entries = self.generators.as_slice().len() + self.dim();
        let sum: f64 = self.generators.as_slice().iter().chain(&self.remainder).map(|x| x * x).sum();
        let zero = sum == 0.0 && self.generators.as_slice().iter().chain(&self.remainder).all(|&x| x == 0.0);
        if zero { 0.0 } else { sqrt_up(product_sum_bound(sum, entries, entries)) }
    }

    /// Covariation `G G' + diag(r)^2` (approximate: plain floating point), shape `n x n`; the box remainder counts as generators.
    ///
    /// It takes the place of a covariance in gains; no guarantee rests on it.
    /// **Source:** Combastel 2015; paper 000.
    #[must_use]
    pub fn covariation(&self) -> Matrix {
        let mut covariation = Matrix::zeros(0, 0);
        self.covariation_into(&mut covariation);
        covariation
    }

    /// [`covariation`](Self::covariation) into a matrix; allocates nothing within its capacity.
    pub fn covariation_into(&self, covariation: &mut Matrix) {
        let n = self.dim();
        covariation.reset(n, n);
        let data = self.generators.as_slice();
        let target = covariation.as_mut_slice();
        match n {
            2 => gram::<2>(data, target),
            3 => gram::<3>(data, target),
            4 => gram::<4>(data, target),
            _ => gram_any(data, n, target),
        }
        for i in 0..n {
            target[i * n + i] += self.remainder[i] * self.remainder[i];
        }
    }

    /// Largest half-width of the interval hull.
    ///
    /// **Guarantee:** an upper bound of the exact value; `inf` where it overflows.
    #[must_use]
    pub fn radius(&self) -> f64 {
        let mut radii = vec![0.0; self.dim()];
        self.hull_radii(&mut radii);
        radii.into_iter().fold(0.0, f64::max)
    }
}

/// `G G'` for `N` rows, two columns in flight.
fn gram<const N: usize>(data: &[f64], target: &mut [f64]) {
    let mut sums = [[[0.0; N]; N]; 2];
    let (pairs, rest) = data.as_chunks::<N>().0.as_chunks::<2>();
    for pair in pairs {
        for (sum, g) in sums.iter_mut().zip(pair) {
            for i in 0..N {
                for k in 0..N {
                    sum[i][k] += g[i] * g[k];
                }
            }
        }
    }
    for g in rest {
        for i in 0..N {
            for k in 0..N {
                sums[0][i][k] += g[i] * g[k];
            }
        }
    }
    for i in 0..N {
        for k in 0..N {
            target[i * N + k] = sums[0][i][k] + sums[1][i][k];
        }
    }
}

/// `G G'` through faer.
fn gram_any(data: &[f64], n: usize, target: &mut [f64]) {
    use faer::{Accum, MatMut, MatRef, Par, linalg::matmul::matmul};
    let g = MatRef::from_column_major_slice(data, n, data.len() / n.max(1));
    matmul(MatMut::from_column_major_slice_mut(target, n, n), Accum::Replace, g, g.transpose(), 1.0, Par::Seq);
}
