//! [`SigmaPoints`]: where the unscented transformation looks, and with which weights.

use crate::EstimatorError;

/// Sets of sigma points of a variable of dimension `n~`: the center, and `center +- spread * column` for each column of a root of the
/// covariance.
///
/// | set | spread^2 | weight of the others | of the center: mean | covariance |
/// |---|---|---|---|---|
/// | symmetric | `n~` | `1 / 2n~` | 0 | 0 |
/// | central, weight `w` | `n~ / (1 - w)` | `(1 - w) / 2n~` | `w` | `w` |
/// | scaled, `lambda = alpha^2 (n~ + kappa) - n~` | `n~ + lambda` | `1 / 2(n~ + lambda)` | `lambda / (n~ + lambda)` | this `+ 1 - alpha^2 + beta` |
///
/// **Source:** symmetric: paper 001, Algorithm 2.1; central: Julier and Uhlmann 2004; scaled: Wan and van der Merwe 2000.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum SigmaPoints {
    /// Two points for every dimension, all of the same weight.
    #[default]
    Symmetric,
    /// With the center.
    Central {
        /// Weight of the center, below 1.
        weight: f64,
    },
    /// With the center, and with weights of the covariance that differ from those of the mean.
    Scaled {
        /// Spread of the points around the mean, positive.
        alpha: f64,
        /// What is known of the distribution: 2 for a Gaussian.
        beta: f64,
        /// A second scale, above `-n~`; 0 or `3 - n~` as a rule.
        kappa: f64,
    },
}

/// The numbers of a set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Weights {
    /// Factor of the columns of the root.
    pub(super) spread: f64,
    /// Weight of each point but the center.
    pub(super) others: f64,
    /// Weights of the center.
    pub(super) mean: f64,
    pub(super) covariance: f64,
}

impl SigmaPoints {
    /// The weights in `n` dimensions.
    pub(super) fn weights(self, n: usize) -> Result<Weights, EstimatorError> {
        let n = n.max(1) as f64;
        let (squared, mean, covariance) = match self {
            Self::Symmetric => (n, 0.0, 0.0),
            Self::Central { weight } => (n / (1.0 - weight), weight, weight),
            Self::Scaled { alpha, beta, kappa } => {
                let squared = alpha * alpha * (n + kappa);
                let mean = (squared - n) / squared;
                (squared, mean, mean + 1.0 - alpha * alpha + beta)
            }
        };
        let weights = Weights { spread: squared.sqrt(), others: 0.5 / squared, mean, covariance };
        let finite = [weights.spread, weights.others, mean, covariance].iter().all(|x| x.is_finite());
        if finite && squared > 0.0 {
            Ok(weights)
        } else {
            Err(EstimatorError::NoSigmaPoints { squared_spread: squared })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{SigmaPoints, Weights};

    /// Weights sum to 1 and reproduce a covariance; the scaled set with `alpha = 1, beta = 0` is the central one.
    #[test]
    fn weights_are_consistent() {
        let scaled = SigmaPoints::Scaled { alpha: 0.3, beta: 2.0, kappa: -1.0 };
        for set in [SigmaPoints::Symmetric, SigmaPoints::Central { weight: 0.4 }, scaled] {
            let w = set.weights(5).unwrap();
            assert!((w.mean + 10.0 * w.others - 1.0).abs() < 1e-14, "{set:?}");
            assert!((2.0 * w.others * w.spread * w.spread - 1.0).abs() < 1e-14, "{set:?}");
        }
        let unscaled = SigmaPoints::Scaled { alpha: 1.0, beta: 0.0, kappa: 2.0 };
        let central = SigmaPoints::Central { weight: 1.0 / 3.0 }.weights(4).unwrap();
        let fields = |w: Weights| [w.spread, w.others, w.mean, w.covariance];
        for (a, b) in fields(unscaled.weights(4).unwrap()).into_iter().zip(fields(central)) {
            // The two formulas round differently.
            assert!((a - b).abs() <= 1e-15 * b.abs(), "{a} {b}");
        }
        for bad in [1.0, 1.5, f64::NAN, f64::NEG_INFINITY] {
            assert!(SigmaPoints::Central { weight: bad }.weights(4).is_err());
        }
        assert!(SigmaPoints::Scaled { alpha: 0.0, beta: 2.0, kappa: 0.0 }.weights(4).is_err());
    }
}
