//! Farkas certificates: multipliers that prove a set empty, and their independent check.

use crate::bound::Multiplier;
use crate::problem::Problem;
use crate::rounding::{add_down, add_up, mul_down, mul_up};

/// Proof that no `x` of the box satisfies all rows: multipliers `y` with `B(y) < 0` for `c = 0`,
///
/// `sum_i max(y_i lower_i, y_i upper_i) + |A'y|_1 < 0`,
///
/// whereas any feasible `x` would give `0 = 0'x <= B(y)`.
///
/// It names the rows that contradict each other ([`multipliers`](Self::multipliers)) and can be checked against the data by
/// [`verify`](Self::verify), which shares no code with the solver and rounds every operation outward.
///
/// ```
/// use boxlp::{Certificate, Problem};
/// let mut problem = Problem::new(2)?;
/// problem.push_row(&[1.0, 1.0], 1.0, 3.0)?;
/// problem.push_row(&[1.0, 1.0], -3.0, 0.5)?;
/// assert!(Certificate::new(vec![(0, -1.0), (1, 1.0)]).verify(&problem));
/// assert!(!Certificate::new(vec![(0, 1.0), (1, 1.0)]).verify(&problem));
/// # Ok::<(), boxlp::LpError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Certificate {
    pub(crate) multipliers: Vec<Multiplier>,
}

impl Certificate {
    /// A claim to be checked by [`verify`](Self::verify); multipliers of one row add up.
    #[must_use]
    pub fn new(multipliers: Vec<Multiplier>) -> Self {
        Self { multipliers }
    }

    /// The rows that contradict each other, each with its multiplier.
    #[must_use]
    pub fn multipliers(&self) -> &[Multiplier] {
        &self.multipliers
    }

    /// Whether the multipliers prove `problem` empty.
    ///
    /// **Guarantee:** `true` only if `problem` has no feasible point in real arithmetic.
    #[must_use]
    pub fn verify(&self, problem: &Problem) -> bool {
        self.miss(problem) > 0.0
    }

    /// How far the rows are from being satisfiable: every `x` of the box misses the range of some row `i` of the
    /// certificate by at least `miss * |A_i|_1`.
    ///
    /// Formula: `-B(y) / sum_i |y_i| |A_i|_1`, rounded down; at most 0 (nothing proven) if the multipliers prove nothing,
    /// are not finite, or name a row that does not exist.
    #[must_use]
    pub fn miss(&self, problem: &Problem) -> f64 {
        let rows = problem.rows();
        if self
            .multipliers
            .iter()
            .any(|&(i, y)| i >= rows || !y.is_finite())
        {
            return 0.0;
        }
        let mut bound = 0.0;
        let mut weight = 0.0;
        for &(i, y) in &self.multipliers {
            let range = &problem.ranges()[i];
            bound = add_up(bound, mul_up(y, range.lo).max(mul_up(y, range.hi)));
            weight = add_up(weight, mul_up(y.abs(), range.norm));
        }
        for j in 0..problem.variables() {
            let (mut low, mut high) = (0.0, 0.0);
            for &(i, y) in &self.multipliers {
                let a = problem.row(i)[j];
                if a != 0.0 {
                    low = add_down(low, mul_down(y, a));
                    high = add_up(high, mul_up(y, a));
                }
            }
            bound = add_up(bound, high.max(-low));
        }
        // Overflow ends as an infinite or NaN bound: nothing is proven then. A zero weight (rows of zeros whose range
        // leaves out 0) means a miss of any share of |A_i|_1 = 0.
        if bound.is_nan() || bound >= 0.0 {
            return 0.0;
        }
        if weight > 0.0 {
            (-bound / weight).next_down()
        } else {
            f64::MAX
        }
    }
}
