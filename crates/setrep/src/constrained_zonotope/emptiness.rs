//! Emptiness: proven empty, proven non-empty, or undecided.

use boxlp::{Certificate, Problem};
use scalars::Interval;

use super::ConstrainedZonotope;
use super::optimizer::{prepared, refused};
use crate::{IntervalVector, SetError, Workspace};

/// Whether a set is empty, as far as it could be proven.
#[derive(Debug, Clone, PartialEq)]
pub enum Emptiness {
    /// The set has no point: the constraints contradict each other.
    ProvenEmpty(Contradiction),
    /// The set has a point in this box, which is of rounding size.
    ProvenNonEmpty(IntervalVector),
    /// Neither could be proven: to be treated as non-empty.
    Undecided,
}

/// Proof that constraints contradict each other: multipliers `y` of the rows with `sum_i max(y_i lo_i, y_i hi_i) + |A'y|_1 < 0`,
/// whereas any `|xi| <= 1` with `A xi in [b]` would give `0 <=` that sum.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Contradiction {
    multipliers: Vec<(usize, f64)>,
}

impl Contradiction {
    /// The constraints that take part, each with its multiplier.
    #[must_use]
    pub fn multipliers(&self) -> &[(usize, f64)] {
        &self.multipliers
    }

    /// Whether the multipliers prove `set` empty; shares no code with the solver.
    ///
    /// **Guarantee:** `true` only if the set is empty in real arithmetic.
    #[must_use]
    pub fn verify(&self, set: &ConstrainedZonotope) -> bool {
        self.miss(set) > 0.0
    }

    /// How far the constraints are from having a common point: every `|xi| <= 1` misses the range of some row `i` by at least
    /// `miss |A_i|_1`. At most 0 if nothing is proven.
    #[must_use]
    pub fn miss(&self, set: &ConstrainedZonotope) -> f64 {
        let (lower, upper): (Vec<f64>, Vec<f64>) = set.ranges.iter().map(|range| (range.lo(), range.hi())).unzip();
        Problem::from_columns(set.num_generators(), set.constraints.as_slice(), &lower, &upper)
            .map_or(0.0, |problem| Certificate::new(self.multipliers.clone()).miss(&problem))
    }
}

impl ConstrainedZonotope {
    /// Decides whether the set is empty, with a proof either way.
    ///
    /// **Guarantee:** both proofs hold for the exact set. A set that is a point or flat may be undecided, never called empty.
    ///
    /// # Errors
    /// [`SetError::TooLarge`].
    ///
    /// ```
    /// # use scalars::Interval;
    /// # use setrep::{ConstrainedZonotope, Emptiness, Workspace};
    /// let mut set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// let mut workspace = Workspace::new();
    /// set.intersect_half_space(&[-1.0, -1.0], -1.0, &mut workspace)?;
    /// assert!(matches!(set.emptiness(&mut workspace)?, Emptiness::ProvenNonEmpty(_)));
    /// set.intersect_half_space(&[1.0, 1.0], 0.5, &mut workspace)?;
    /// assert!(matches!(set.emptiness(&mut workspace)?, Emptiness::ProvenEmpty(proof) if proof.verify(&set)));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn emptiness(&self, workspace: &mut Workspace) -> Result<Emptiness, SetError> {
        self.optimizer(workspace)?;
        Ok(match prepared(&mut workspace.solver)?.emptiness() {
            boxlp::Emptiness::Empty(certificate) => {
                Emptiness::ProvenEmpty(Contradiction { multipliers: certificate.multipliers().to_vec() })
            }
            boxlp::Emptiness::NonEmpty(witness) => {
                let point = |i: usize| {
                    let start = Interval::point(self.center()[i]);
                    witness.point().iter().enumerate().fold(start, |sum, (j, &xi)| {
                        sum + Interval::point(xi).inflate(witness.radius()).scale(self.generators().col(j)[i])
                    })
                };
                Emptiness::ProvenNonEmpty((0..self.dim()).map(point).collect())
            }
            boxlp::Emptiness::Undecided => Emptiness::Undecided,
        })
    }

    /// Whether the set is proven to have no point.
    ///
    /// # Errors
    /// As [`emptiness`](Self::emptiness).
    pub fn is_proven_empty(&self, workspace: &mut Workspace) -> Result<bool, SetError> {
        self.optimizer(workspace)?;
        let solver = prepared(&mut workspace.solver)?;
        let objective = &mut workspace.objective;
        objective.clear();
        objective.resize(self.num_generators(), 0.0);
        Ok(solver.maximize(objective).map_err(refused)?.bound == f64::NEG_INFINITY)
    }
}
