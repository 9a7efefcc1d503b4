//! Choice of the eigenvectors in pole placement: the determinant of the unit eigenvectors is made large.
//!
//! A row vector `x'` can be a left eigenvector of `A - L C` to the eigenvalue `l` for some `L` if and only if `x` lies in a
//! space `S_l` of dimension `rank C`. What is left free is used to keep the eigenvectors far from dependent, which keeps the
//! gain and the sensitivity of the eigenvalues small: `|det X|` is maximised over two columns at a time.
//!
//! **Source:** Kautsky, Nichols, Van Dooren 1985 (the spaces, one column at a time); Tits, Yang 1996 (two columns at a time).

use nalgebra::{Complex, ComplexField, DMatrix, DVector, SVD, SymmetricEigen};

use super::poles::Pole;
use crate::EstimatorError;

/// Sweeps over all columns; a sweep that gains less than [`GAIN_LIMIT`] in `ln |det X|` is the last.
const MAX_SWEEPS: usize = 200;
const GAIN_LIMIT: f64 = 1e-9;
/// Starting points tried; ascent of a determinant can end in a local maximum.
const STARTS: usize = 2;
const MAX_ITERATIONS: usize = 1_000;

/// Orthonormal basis of the space of eigenvectors one pole allows.
enum Space {
    Real(DMatrix<f64>),
    Pair(DMatrix<Complex<f64>>),
}

/// Real and imaginary parts of the eigenvectors (`n x n`): one column for a real pole, two for a pair, in order.
///
/// `hidden`: `n x (n - rank C)`, an orthonormal basis of the kernel of `C`.
pub(super) fn choose(a: &DMatrix<f64>, hidden: &DMatrix<f64>, poles: &[Pole]) -> Result<DMatrix<f64>, EstimatorError> {
    let spaces: Vec<Space> = poles.iter().map(|&pole| space(a, hidden, pole)).collect();
    let mut best: Option<(f64, DMatrix<f64>)> = None;
    for start in 0..STARTS {
        let mut x = start_columns(&spaces, a.nrows(), start);
        ascend(&spaces, &mut x)?;
        let det = x.determinant().abs();
        // A later start must be better by more than rounding, so that equal maxima resolve to the first.
        if best.as_ref().is_none_or(|(d, _)| det > d * (1.0 + 1e-6)) {
            best = Some((det, x));
        }
    }
    best.map(|(_, x)| x).ok_or(EstimatorError::NoConvergence { what: "choice of eigenvectors" })
}

/// `S_l = { x : U' (A' - l I) x = 0 }` with `U` a basis of the kernel of `C`: the orthogonal complement of `(A - conj(l) I) U`.
fn space(a: &DMatrix<f64>, hidden: &DMatrix<f64>, pole: Pole) -> Space {
    match pole {
        Pole::Real(l) => Space::Real(complement(&(a * hidden - hidden * l))),
        Pole::Pair(l) => {
            let u = hidden.map(Complex::from);
            Space::Pair(complement(&(a.map(Complex::from) * &u - u * l.conj())))
        }
    }
}

/// Orthonormal basis of the orthogonal complement of the columns of `m` (`n x k`, independent): `n x (n - k)`.
pub(super) fn complement<T: ComplexField>(m: &DMatrix<T>) -> DMatrix<T> {
    let (n, k) = m.shape();
    // Zero columns beside `m` make the QR factorisation return a full basis.
    let mut square = DMatrix::zeros(n, n);
    square.columns_mut(0, k).copy_from(m);
    square.qr().q().columns(k, n - k).into_owned()
}

/// Deterministic columns in general position: coefficients from an additive sequence of the golden ratio.
fn start_columns(spaces: &[Space], n: usize, start: usize) -> DMatrix<f64> {
    let mut index = start as f64 * 101.0;
    let mut coefficient = || {
        index += 1.0;
        1.0 + (index * 0.618_033_988_749_894_8).fract() * if start == 0 { 0.5 } else { -3.0 }
    };
    let mut columns: Vec<DVector<f64>> = Vec::with_capacity(n);
    for space in spaces {
        match space {
            Space::Real(s) => columns.push((s * DVector::from_fn(s.ncols(), |_, _| coefficient())).normalize()),
            Space::Pair(s) => {
                let w = DVector::from_fn(s.ncols(), |_, _| Complex::new(coefficient(), coefficient()));
                let x = (s * w).normalize();
                columns.push(x.map(|v| v.re));
                columns.push(x.map(|v| v.im));
            }
        }
    }
    DMatrix::from_columns(&columns)
}

/// Sweeps over pairs of columns until the determinant stops growing.
fn ascend(spaces: &[Space], x: &mut DMatrix<f64>) -> Result<(), EstimatorError> {
    let mut real: Vec<(usize, &DMatrix<f64>)> = Vec::new();
    let mut pairs: Vec<(usize, &DMatrix<Complex<f64>>)> = Vec::new();
    let mut column = 0;
    for space in spaces {
        match space {
            Space::Real(s) => {
                real.push((column, s));
                column += 1;
            }
            Space::Pair(s) => {
                pairs.push((column, s));
                column += 2;
            }
        }
    }
    for _ in 0..MAX_SWEEPS {
        let mut gained = 0.0;
        if let [(i, s)] = real[..] {
            gained += raise_one(x, i, s);
        }
        for (first, second) in neighbours(real.len()) {
            gained += raise_two(x, real[first], real[second])?;
        }
        for &(i, s) in &pairs {
            gained += raise_pair(x, i, s)?;
        }
        if gained <= GAIN_LIMIT {
            break;
        }
    }
    Ok(())
}

/// `(0,1), (1,2), .., (k-1,0)`; one pair for two, none for fewer.
fn neighbours(k: usize) -> impl Iterator<Item = (usize, usize)> {
    let count = match k {
        0 | 1 => 0,
        2 => 1,
        _ => k,
    };
    (0..count).map(move |i| (i, (i + 1) % k))
}

/// The columns of `x` but those listed.
fn others(x: &DMatrix<f64>, without: &[usize]) -> DMatrix<f64> {
    x.clone().remove_columns_at(without)
}

/// Best `x_i` for fixed others: the projection on its space of the normal to the others. Returns the growth of `ln |det|`.
fn raise_one(x: &mut DMatrix<f64>, i: usize, s: &DMatrix<f64>) -> f64 {
    let normal = complement(&others(x, &[i]));
    let normal = normal.column(0);
    let now = normal.dot(&x.column(i)).abs();
    let projected = s.tr_mul(&normal);
    let best = projected.norm();
    let gained = growth(now, best);
    if gained > 0.0 {
        x.set_column(i, &(s * projected / best));
    }
    gained
}

/// Best unit `x_i`, `x_j` for fixed others. With `y, z` orthonormal and normal to the others, `|det X|` is proportional to
/// `|x_i' (y z' - z y') x_j|`: the leading singular vectors of `S_i' (y z' - z y') S_j`.
fn raise_two(
    x: &mut DMatrix<f64>,
    (i, s_i): (usize, &DMatrix<f64>),
    (j, s_j): (usize, &DMatrix<f64>),
) -> Result<f64, EstimatorError> {
    let skew = skew_normal(&others(x, &[i.min(j), i.max(j)]));
    let now = x.column(i).dot(&(&skew * x.column(j))).abs();
    let form = s_i.tr_mul(&(skew * s_j));
    let failed = EstimatorError::NoConvergence { what: "singular values in pole placement" };
    // nalgebra's SVD panics on NaN.
    if form.iter().any(|v| !v.is_finite()) {
        return Err(failed);
    }
    let svd = SVD::try_new(form, true, true, f64::EPSILON, MAX_ITERATIONS).ok_or(failed)?;
    let gained = growth(now, svd.singular_values[0]);
    if let (true, Some(u), Some(vt)) = (gained > 0.0, &svd.u, &svd.v_t) {
        x.set_column(i, &(s_i * u.column(0)));
        x.set_column(j, &(s_j * vt.row(0).transpose()));
    }
    Ok(gained)
}

/// Best unit complex `x = S w`: `Re(x)' (y z' - z y') Im(x) = x^H (-i/2) (y z' - z y') x`, a Hermitian form in `w`.
fn raise_pair(x: &mut DMatrix<f64>, i: usize, s: &DMatrix<Complex<f64>>) -> Result<f64, EstimatorError> {
    let skew = skew_normal(&others(x, &[i, i + 1]));
    let now = x.column(i).dot(&(&skew * x.column(i + 1))).abs();
    let form = s.adjoint() * (skew.map(|v| Complex::new(0.0, -0.5 * v)) * s);
    let eigen = SymmetricEigen::try_new(form, f64::EPSILON, MAX_ITERATIONS)
        .ok_or(EstimatorError::NoConvergence { what: "eigenvalues in pole placement" })?;
    let best = eigen.eigenvalues.iamax();
    let gained = growth(now, eigen.eigenvalues[best].abs());
    if gained > 0.0 {
        let column = s * eigen.eigenvectors.column(best);
        x.set_column(i, &column.map(|v| v.re));
        x.set_column(i + 1, &column.map(|v| v.im));
    }
    Ok(gained)
}

/// `y z' - z y'` for an orthonormal basis `y, z` of the complement of `n - 2` columns.
fn skew_normal(others: &DMatrix<f64>) -> DMatrix<f64> {
    let normals = complement(others);
    let (y, z) = (normals.column(0), normals.column(1));
    y * z.transpose() - z * y.transpose()
}

/// `ln(best / now)`, and 0 where the difference is rounding.
fn growth(now: f64, best: f64) -> f64 {
    if best > now * (1.0 + 1e-14) { (best / now.max(f64::MIN_POSITIVE)).ln() } else { 0.0 }
}
