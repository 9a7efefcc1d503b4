//! Dense matrix functions in double-double: the definitions themselves, without any structure of the groups.

use nalgebra::{DMatrix, Dim, Matrix, RawStorage};

use super::dd::Dd;

/// A square matrix in double-double.
#[derive(Clone, Debug)]
pub(crate) struct Dense {
    pub(crate) size: usize,
    entries: Vec<Dd>,
}

impl Dense {
    pub(crate) fn from_fn(size: usize, entry: impl Fn(usize, usize) -> Dd) -> Self {
        Self { size, entries: (0..size * size).map(|k| entry(k / size, k % size)).collect() }
    }

    /// The given `f64` matrix, exactly.
    pub(crate) fn exact<R: Dim, C: Dim, T: RawStorage<f64, R, C>>(m: &Matrix<f64, R, C, T>) -> Self {
        Self::from_fn(m.nrows(), |row, col| m[(row, col)].into())
    }

    pub(crate) fn identity(size: usize) -> Self {
        Self::from_fn(size, |row, col| if row == col { Dd::ONE } else { Dd::ZERO })
    }

    pub(crate) fn get(&self, row: usize, col: usize) -> Dd {
        self.entries[row * self.size + col]
    }

    pub(crate) fn multiply(&self, other: &Self) -> Self {
        let n = self.size;
        Self::from_fn(n, |row, col| {
            let terms = (0..n).map(|k| (self.get(row, k), other.get(k, col)));
            terms.filter(|(a, b)| a.hi != 0.0 && b.hi != 0.0).fold(Dd::ZERO, |sum, (a, b)| sum + a * b)
        })
    }

    pub(crate) fn map(&self, f: impl Fn(Dd) -> Dd) -> Self {
        Self { size: self.size, entries: self.entries.iter().map(|&x| f(x)).collect() }
    }

    /// Largest entry in modulus, rounded.
    pub(crate) fn max_norm(&self) -> f64 {
        self.entries.iter().fold(0.0, |m, x| x.hi.abs().max(m))
    }

    /// `phi_k(A) = sum_j A^j / (j + k)!` from the definition; `k = 0` is `expm(A)`.
    pub(crate) fn phi(&self, k: usize) -> Self {
        self.phi_both_signs(k).0
    }

    /// `phi_k(A)` and `phi_k(-A)`: sum and difference of the even and the odd terms.
    pub(crate) fn phi_both_signs(&self, k: usize) -> (Self, Self) {
        let factorial = (1..=k).fold(Dd::ONE, |f, i| f * (i as f64).into());
        let mut term = Self::identity(self.size).map(|x| x / factorial);
        let (mut even, mut odd) = (term.clone(), Self::from_fn(self.size, |_, _| Dd::ZERO));
        for j in 1..200 {
            let factor = Dd::ONE / ((j + k) as f64).into();
            term = term.multiply(self).map(|x| x * factor);
            let sum = if j % 2 == 0 { &mut even } else { &mut odd };
            for (total, &x) in sum.entries.iter_mut().zip(&term.entries) {
                *total = *total + x;
            }
            if term.max_norm() <= 1e-36 * even.max_norm().max(odd.max_norm()) {
                let join = |sign: f64| Self::from_fn(self.size, |r, c| even.get(r, c) + odd.get(r, c) * sign.into());
                return (join(1.0), join(-1.0));
            }
        }
        panic!("series of phi_{k} needs more than 200 terms: norm {}", self.max_norm());
    }

    /// `expm(A) = I + A phi_1(A)` from `phi_1(A)`.
    pub(crate) fn exp_from_phi1(&self, phi1: &Self) -> Self {
        let product = self.multiply(phi1);
        Self::from_fn(self.size, |r, c| product.get(r, c) + if r == c { Dd::ONE } else { Dd::ZERO })
    }

    /// Inverse by elimination; the pivot is the largest entry relative to its row, so that triangular blocks stay exact.
    pub(crate) fn inverse(&self) -> Self {
        let n = self.size;
        let (mut left, mut right) = (self.clone(), Self::identity(n));
        for col in 0..n {
            let weight = |row: usize| {
                let largest = (col..n).fold(0.0, |m: f64, k| m.max(left.get(row, k).hi.abs()));
                if largest == 0.0 { 0.0 } else { left.get(row, col).hi.abs() / largest }
            };
            // The first of equal ones.
            let pivot = (col..n).rev().max_by(|&a, &b| weight(a).total_cmp(&weight(b))).unwrap();
            for k in 0..n {
                left.entries.swap(col * n + k, pivot * n + k);
                right.entries.swap(col * n + k, pivot * n + k);
            }
            let scale = Dd::ONE / left.get(col, col);
            for k in 0..n {
                left.entries[col * n + k] = left.get(col, k) * scale;
                right.entries[col * n + k] = right.get(col, k) * scale;
            }
            for row in (0..n).filter(|&row| row != col) {
                let factor = left.get(row, col);
                for k in 0..n {
                    left.entries[row * n + k] = left.get(row, k) - factor * left.get(col, k);
                    right.entries[row * n + k] = right.get(row, k) - factor * right.get(col, k);
                }
            }
        }
        right
    }

    /// Norm-wise relative error of an `f64` matrix: largest difference over largest entry.
    pub(crate) fn error_of<R: Dim, C: Dim, T: RawStorage<f64, R, C>>(&self, computed: &Matrix<f64, R, C, T>) -> f64 {
        let n = self.size;
        let worst = (0..n * n).fold(0.0_f64, |m, k| {
            let difference = Dd::from(computed[(k / n, k % n)]) - self.get(k / n, k % n);
            if difference.hi.is_nan() { f64::INFINITY } else { m.max(difference.hi.abs()) }
        });
        worst / self.max_norm()
    }

    /// First entry outside an interval matrix.
    pub(crate) fn escapes<R: Dim, C: Dim, T: RawStorage<scalars::Interval, R, C>>(
        &self,
        bounds: &Matrix<scalars::Interval, R, C, T>,
    ) -> Option<(usize, usize)> {
        let n = self.size;
        (0..n * n).map(|k| (k / n, k % n)).find(|&at| !self.get(at.0, at.1).in_interval(&bounds[at]))
    }
}

impl Dense {
    /// As [`escapes`](Self::escapes) for references that themselves come from products or an inverse: an error of 1e-27 of their largest entry is allowed for.
    pub(crate) fn escapes_computed<R: Dim, C: Dim, T: RawStorage<scalars::Interval, R, C>>(
        &self,
        bounds: &Matrix<scalars::Interval, R, C, T>,
    ) -> Option<(usize, usize)> {
        let error = Dd::from(1e-27 * self.max_norm());
        let outside = |at: (usize, usize)| {
            let (value, range) = (self.get(at.0, at.1), &bounds[at]);
            !((value + error).at_least(range.lo()) && (error - value).at_least(-range.hi()))
        };
        (0..self.size * self.size).map(|k| (k / self.size, k % self.size)).find(|&at| outside(at))
    }
}

/// Rounded copy, for messages.
impl From<&Dense> for DMatrix<f64> {
    fn from(m: &Dense) -> Self {
        DMatrix::from_fn(m.size, m.size, |row, col| m.get(row, col).hi)
    }
}
