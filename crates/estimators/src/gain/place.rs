//! Pole placement for several outputs.

use nalgebra::{Complex, DMatrix, SVD};

use super::eigenvectors;
use super::observability::{binade, check_pair, largest, observability_rank};
use super::poles::{Pole, pair_up};
use crate::EstimatorError;
use crate::error::check_finite;

/// Largest accepted distance of an eigenvalue to its pole, relative to `|A| + max |pole|`.
const TOLERANCE: f64 = 1e-8;

/// The gain `L` that gives `A - L C` the eigenvalues `poles`; with several outputs, one with well-conditioned eigenvectors.
///
/// Shapes `A: n x n`, `C: p x n`, `L: n x p`. The poles are real or come with their conjugates, and each is repeated at most
/// `rank C` times. With one output `L` is unique. With more, the left eigenvectors `X` are chosen to maximise
/// `|det X|` (unit columns) by rank-two updates, and `L = (A - (X D X^-1)') C^+` with `D` the block diagonal of the poles.
/// The same input gives the same bits.
///
/// **Guarantee:** approximate, but checked: with `E = X^-1 (A - L C)' X - D`, every eigenvalue lies within `|E|` of a pole
/// (Bauer-Fike); the gain is returned only if this is below `1e-8 (|A| + max |pole|)`.
/// **Source:** Tits and Yang 1996, Kautsky, Nichols and Van Dooren 1985; used by paper 000, Theorem 3.2.
///
/// # Errors
/// - [`EstimatorError::Size`], [`EstimatorError::NotFinite`]: `A`, `C` or a pole, or a gain that overflows;
/// - [`EstimatorError::NotObservable`]: the pair, with the rank found;
/// - [`EstimatorError::PoleCount`], [`EstimatorError::PoleNotConjugate`], [`EstimatorError::PoleMultiplicity`]: the list;
/// - [`EstimatorError::PlacementInaccurate`]: the pair is so close to unobservable, or the poles so close to repeated too
///   often, that f64 cannot place them.
///
/// ```
/// use estimators::place;
/// use nalgebra::{Complex, DMatrix};
/// // The vehicle of paper 000 in body coordinates: heading, forward and lateral position; both positions measured.
/// let a = DMatrix::from_row_slice(3, 3, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.004, 0.08, -0.004, 1.0]);
/// let c = DMatrix::from_row_slice(2, 3, &[0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
/// let poles = [0.95, 0.98, 0.98].map(|re| Complex::new(re, 0.0));
/// let gain = place(&a, &c, &poles)?;
/// assert!((gain - DMatrix::from_row_slice(3, 2, &[0.0, 0.0125, 0.02, 0.004, -0.004, 0.07])).norm() < 1e-12);
/// # Ok::<(), estimators::EstimatorError>(())
/// ```
pub fn place(a: &DMatrix<f64>, c: &DMatrix<f64>, poles: &[Complex<f64>]) -> Result<DMatrix<f64>, EstimatorError> {
    let n = check_pair(a, c)?;
    let rank = observability_rank(a, c)?;
    if rank < n {
        return Err(EstimatorError::NotObservable { rank, states: n });
    }
    if n == 0 {
        pair_up(poles, 0, 0)?;
        return Ok(DMatrix::zeros(0, c.nrows()));
    }
    // With A, the poles and C divided by powers of two the gain scales with them: L = L' s_A / s_C.
    let s_c = binade(largest(c));
    let c = c / s_c;
    let outputs = Outputs::of(&c)?;
    let poles = pair_up(poles, n, outputs.rank)?;
    let s_a = binade(largest(a).max(largest_pole(&poles)));
    let (a, poles) = (a / s_a, scaled(poles, s_a));
    let gain = place_scaled(&a, &c, &outputs, &poles)? * s_a / s_c;
    check_finite("placed gain", gain.as_slice())?;
    Ok(gain)
}

/// [`place`] for an observable pair whose largest entries are about 1.
fn place_scaled(
    a: &DMatrix<f64>,
    c: &DMatrix<f64>,
    outputs: &Outputs,
    poles: &[Pole],
) -> Result<DMatrix<f64>, EstimatorError> {
    let n = a.nrows();
    let blocks = block_diagonal(poles, n);
    let vectors =
        if outputs.rank == n { DMatrix::identity(n, n) } else { eigenvectors::choose(a, &outputs.hidden, poles)? };
    let tolerance = TOLERANCE * (a.norm() + largest_pole(poles));
    let inaccurate = |error| EstimatorError::PlacementInaccurate { error, tolerance };
    // N' = X^-T D' X' is the closed loop wanted; it differs from A only within the reach of L C.
    let closed =
        vectors.transpose().lu().solve(&(blocks.tr_mul(&vectors.transpose()))).ok_or(inaccurate(f64::INFINITY))?;
    let gain = (a - closed) * &outputs.inverse;
    let reached = (a - &gain * c).tr_mul(&vectors);
    let error = (vectors.lu().solve(&reached).ok_or(inaccurate(f64::INFINITY))? - &blocks).norm();
    if error <= tolerance { Ok(gain) } else { Err(inaccurate(error)) }
}

/// What `C` sees and what it does not.
struct Outputs {
    rank: usize,
    /// Orthonormal basis of the kernel, `n x (n - rank)`.
    hidden: DMatrix<f64>,
    /// Pseudo-inverse, `n x p`.
    inverse: DMatrix<f64>,
}

impl Outputs {
    fn of(c: &DMatrix<f64>) -> Result<Self, EstimatorError> {
        let failed = EstimatorError::NoConvergence { what: "singular values of C" };
        let svd = SVD::try_new(c.clone(), true, true, f64::EPSILON, 10_000).ok_or(failed.clone())?;
        let (Some(u), Some(v_t)) = (&svd.u, &svd.v_t) else { return Err(failed) };
        let n = c.ncols();
        let threshold = svd.singular_values.max() * (n * n) as f64 * 2f64.powi(-48);
        let rank = svd.singular_values.iter().filter(|s| **s > threshold).count();
        let seen = v_t.rows(0, rank).transpose();
        let hidden = eigenvectors::complement(&seen);
        let mut scaled = seen;
        for (mut column, s) in scaled.column_iter_mut().zip(&svd.singular_values) {
            column /= *s;
        }
        Ok(Self { rank, hidden, inverse: scaled * u.columns(0, rank).transpose() })
    }
}

/// `D`: the real poles, and `[re im; -im re]` for a pair acting on real and imaginary part of its vector.
fn block_diagonal(poles: &[Pole], n: usize) -> DMatrix<f64> {
    let mut d = DMatrix::zeros(n, n);
    let mut i = 0;
    for &pole in poles {
        match pole {
            Pole::Real(l) => d[(i, i)] = l,
            Pole::Pair(l) => {
                d[(i, i)] = l.re;
                d[(i + 1, i + 1)] = l.re;
                d[(i, i + 1)] = l.im;
                d[(i + 1, i)] = -l.im;
            }
        }
        i += pole.count();
    }
    d
}

/// The poles divided by `s`.
fn scaled(poles: Vec<Pole>, s: f64) -> Vec<Pole> {
    let divide = |pole| match pole {
        Pole::Real(l) => Pole::Real(l / s),
        Pole::Pair(l) => Pole::Pair(l / s),
    };
    poles.into_iter().map(divide).collect()
}

/// Largest modulus.
fn largest_pole(poles: &[Pole]) -> f64 {
    poles.iter().fold(0.0, |m, pole| match pole {
        Pole::Real(l) => m.max(l.abs()),
        Pole::Pair(l) => m.max(l.norm()),
    })
}
