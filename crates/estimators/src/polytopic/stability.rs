//! Uniform boundedness of polytopic estimates: paper 004's Theorem 3, and a sharper one.

use nalgebra::{DMatrix, DVector};
use setrep::{IntervalMatrix, Part, SetError};

use crate::EstimatorError;
use crate::error::check_size;

/// Rows of `I - P J` of at most this 1-norm count as zero, as the printed theorem asks.
const IDENTITY: f64 = 1e-9;

/// Most coordinates whose choice is enumerated.
const MAX_CHOICES: usize = 12;

/// Steps of the power method.
const ITERATIONS: usize = 200;

/// Covers the relative roundings of sums and products of numbers that are not negative, at most a thousand.
const UP: f64 = 1.0 + 1e-12;

/// Which inequality `Delta_k <= L(D) Delta_(k-1) + const` of the widths `Delta` of the interval hulls is used.
///
/// `M = mag [J_f]`, `C = mid [J_g]`, `R = rad [J_g]`, `P` the pseudoinverse of `C`, `E = I - P C`, and `D` diagonal with entries 0 (the prediction's
/// bound of a coordinate is used) and 1 (the update's).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WidthBound {
    /// Paper 004, Theorem 3: `L(D) = D |P| (R + 2 |C| M) + 2 (I - D) M`, `D_ii = 1` only where row `i` of `E` is zero. It holds for any
    /// expansion point inside the sets.
    ///
    /// As `|P| |C| >= |P C|`, the rows with `D_ii = 1` are never less than the others: the least is always `D = 0`, and the theorem does not see
    /// what measurements are good for.
    Printed,
    /// For the expansion at the centers of the hulls, [`VhCenter::HullCenter`](crate::VhCenter::HullCenter): `L(D) = (D (|P| R + |E|) + I - D) M`, any `D`.
    ///
    /// The prediction has widths `Delta_f <= M Delta + const`, as `|v - p_0| <= Delta / 2`. In the update `C x` has widths of at most
    /// `R Delta_f + const`, the constant from the noise, and `x = P C x + E x`.
    Centered,
}

/// What [`stability`] has found.
#[derive(Debug, Clone, PartialEq)]
pub struct Stability {
    /// An upper bound of the spectral radius of `L(D)`, proven.
    pub radius: f64,
    /// The diagonal of the `D` that it belongs to, the best one.
    pub updated: Vec<bool>,
}

impl Stability {
    /// Whether the widths of all sets are proven to stay below one bound.
    #[must_use]
    pub fn is_proven(&self) -> bool {
        self.radius < 1.0
    }
}

/// Whether the interval hulls of polytopic estimates stay bounded, from bounds of the Jacobians: the least spectral radius of `L(D)`.
///
/// Shapes: `dynamics: n x n` encloses `df/dx`, `outputs: m x n` encloses `dg/dx`.
///
/// **Assumes** that both bounds hold on a region that contains every set of the filter, that noises and their Jacobians are bounded there,
/// and that every output is measured at every step, additive noise included. Sets without a limit on their vertices; tighter updates
/// (several passes, ranges) only make the widths less. The rounding of the filter, some ulp a step, is left out.
///
/// **Guarantee:** `radius < 1` proves that the widths stay bounded. The bound is a Collatz-Wielandt quotient `max_i (L x)_i / x_i`, which is one
/// for every positive `x`.
/// **Source:** paper 004, Definition 4 and Theorem 3; the second bound is ours.
///
/// # Errors
/// [`EstimatorError::Size`] if the shapes do not fit; [`SetError::OverBudget`] for more than 12 coordinates that updates can bound.
///
/// ```
/// use estimators::{WidthBound, stability};
/// use scalars::Interval;
/// use setrep::IntervalMatrix;
/// // x+ = a x with a in [1.4, 1.6], y = x + 0.1 sin x: unstable, but measured.
/// let dynamics = IntervalMatrix::from_intervals(1, 1, &[Interval::new(1.4, 1.6)?])?;
/// let outputs = IntervalMatrix::from_intervals(1, 1, &[Interval::new(0.9, 1.1)?])?;
/// assert!(!stability(&dynamics, &outputs, WidthBound::Printed)?.is_proven());
/// let ours = stability(&dynamics, &outputs, WidthBound::Centered)?;
/// assert!(ours.is_proven() && ours.updated == [true] && ours.radius < 0.17);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn stability(
    dynamics: &IntervalMatrix,
    outputs: &IntervalMatrix,
    bound: WidthBound,
) -> Result<Stability, EstimatorError> {
    let n = dynamics.rows();
    check_size("columns of the Jacobian of the dynamics", n, dynamics.cols())?;
    check_size("columns of the Jacobian of the outputs", n, outputs.cols())?;
    if n == 0 {
        return Err(SetError::ZeroDimension { part: Part::Map }.into());
    }
    let entry = |matrix: &IntervalMatrix, i, j| (matrix.mid()[(i, j)].abs() + matrix.rad()[(i, j)]) * UP;
    let moved = DMatrix::from_fn(n, n, |i, j| entry(dynamics, i, j));
    let middle = DMatrix::from_fn(outputs.rows(), n, |i, j| outputs.mid()[(i, j)]);
    let radius = DMatrix::from_fn(outputs.rows(), n, |i, j| outputs.rad()[(i, j)]);
    let largest = middle.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let inverse = match (outputs.rows() > 0).then(|| middle.clone().pseudo_inverse(1e-12 * largest)) {
        Some(Ok(inverse)) if inverse.iter().all(|x| x.is_finite()) => inverse,
        // Any matrix is valid; with this one updates bound nothing.
        _ => DMatrix::zeros(n, outputs.rows()),
    };
    // |I - P C|, with the roundings of the sums.
    let size = inverse.abs() * middle.abs();
    let missed = (DMatrix::identity(n, n) - &inverse * &middle).abs() + size.map(|x| (x + 1.0) * (UP - 1.0));
    let (predicted, updated) = match bound {
        WidthBound::Printed => {
            let through = inverse.abs() * (&radius + middle.abs() * &moved * 2.0) + &missed * &moved * 2.0;
            (&moved * 2.0, through)
        }
        WidthBound::Centered => (moved.clone(), (inverse.abs() * &radius + &missed) * &moved),
    };
    let allowed = |i: usize| bound == WidthBound::Centered || missed.row(i).sum() <= IDENTITY;
    // A row that is nowhere less is never the better one.
    let useful = |i: &usize| allowed(*i) && (0..n).any(|j| updated[(*i, j)] < predicted[(*i, j)]);
    let free: Vec<usize> = (0..n).filter(useful).collect();
    if free.len() > MAX_CHOICES {
        return Err(SetError::OverBudget { count: free.len(), limit: MAX_CHOICES }.into());
    }
    let mut best = Stability { radius: f64::INFINITY, updated: vec![false; n] };
    for choice in 0..1_usize << free.len() {
        let taken: Vec<bool> =
            (0..n).map(|i| free.iter().position(|&k| k == i).is_some_and(|bit| choice >> bit & 1 == 1)).collect();
        let matrix = DMatrix::from_fn(n, n, |i, j| if taken[i] { updated[(i, j)] } else { predicted[(i, j)] } * UP);
        let radius = spectral_radius(&matrix);
        if radius < best.radius {
            best = Stability { radius, updated: taken };
        }
    }
    Ok(best)
}

/// An upper bound of the spectral radius of a matrix without negative entries.
///
/// **Guarantee:** upper bound, whatever the iteration found. **Source:** Collatz 1942; Wielandt 1950.
fn spectral_radius(matrix: &DMatrix<f64>) -> f64 {
    let n = matrix.nrows();
    let largest = matrix.max();
    if largest <= 0.0 {
        return 0.0;
    }
    // Positive, hence with a positive eigenvector; doubled on the diagonal, so that the iteration does not turn in circles.
    let positive = matrix.map(|x| x + 1e-10 * largest) + DMatrix::identity(n, n) * largest;
    let mut x = DVector::from_element(n, 1.0);
    let mut bound = f64::INFINITY;
    for _ in 0..ITERATIONS {
        bound = bound.min((matrix * &x).component_div(&x).max() * UP * UP);
        x = &positive * &x;
        x /= x.max();
    }
    bound
}
