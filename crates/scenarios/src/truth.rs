//! The truth contract: what an experiment may call the truth.
//!
//! A simulation in floating point follows no trajectory of its model exactly, so it cannot tell a filter that loses the state
//! from a simulator that leaves the model. Here a state is *any* sequence of numbers, and every step is proven afterwards: the noise that
//! leads exactly from one state to the next is enclosed in intervals and must lie in its bounds. So the states are one exact
//! trajectory, known without error; only the proof has rounding, and a [`MARGIN`](crate::noise::MARGIN) pays for it.
//!
//! An output is the float `y` such that `y - h(x)`, enclosed in intervals, lies in the noise bounds.

use scalars::Interval;

/// How often an output is moved inwards by one ulp before giving up.
const MAX_NUDGES: usize = 64;

/// Why a simulated trajectory is not a trajectory of the model.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TruthError {
    /// The noise that leads to the state after this step is not proven to lie in its bounds.
    #[error("step {step}: process noise component {component} is only known to be below {found}, bound {bound}")]
    ProcessNoise {
        /// Step the noise acts in.
        step: usize,
        /// Component of the noise.
        component: usize,
        /// Bound on its absolute value.
        bound: f64,
        /// Largest absolute value in its enclosure (infinite when it could not be computed).
        found: f64,
    },
    /// No float near the output is proven to be a measurement within the bounds.
    #[error("step {step}: no output component {component} is proven within {bound} of the true one")]
    Output {
        /// Step of the output.
        step: usize,
        /// Component of the output.
        component: usize,
        /// Bound on the measurement noise.
        bound: f64,
    },
}

/// A real number held as the unevaluated sum of two floats: an exact coordinate of the truth on a grid far finer than one ulp.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Exact {
    head: f64,
    tail: f64,
}

impl Exact {
    /// The number `value`.
    #[must_use]
    pub fn new(value: f64) -> Self {
        Self { head: value, tail: 0.0 }
    }

    /// A number near `self + step`; which one is said by [`difference`](Self::difference).
    #[must_use]
    pub fn moved_by(self, step: f64) -> Self {
        let (head, error) = two_sum(self.head, step);
        let (head, tail) = two_sum(head, self.tail + error);
        Self { head, tail }
    }

    /// The nearest float, up to one ulp.
    #[must_use]
    pub fn value(self) -> f64 {
        self.head
    }

    /// **Guarantee:** contains the number; width at most a few ulp, whatever the number of steps before.
    #[must_use]
    pub fn enclosure(self) -> Interval {
        Interval::point(self.head) + Interval::point(self.tail)
    }

    /// **Guarantee:** contains `self - earlier`; its width is rounding of the difference, not of the numbers.
    #[must_use]
    pub fn difference(self, earlier: Self) -> Interval {
        (Interval::point(self.head) - Interval::point(earlier.head))
            + (Interval::point(self.tail) - Interval::point(earlier.tail))
    }
}

/// `a + b` rounded, and its exact rounding error (Knuth).
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// `a + b` if it is a float.
#[must_use]
pub fn exact_sum(a: f64, b: f64) -> Option<f64> {
    let (sum, error) = two_sum(a, b);
    (error == 0.0 && sum.is_finite()).then_some(sum)
}

/// True if every number of the noise interval has absolute value at most `bound`.
///
/// The bound itself is left out, so the noise lies also in the box of a decimal bound that the float `bound` rounds up.
#[must_use]
pub fn proven_within(noise: &Interval, bound: f64) -> bool {
    !noise.is_empty() && noise.mag() < bound
}

/// The output near `h + noise`: a float `y` with `y - h` proven within `bound`, moved towards `h` by ulps where rounding requires it.
///
/// `h` encloses the true output component; none if 64 ulps do not suffice (`h` too wide for the bound).
#[must_use]
pub fn output_within(h: &Interval, noise: f64, bound: f64) -> Option<f64> {
    let center = h.mid();
    let mut output = center + noise;
    for _ in 0..MAX_NUDGES {
        if proven_within(&(Interval::point(output) - *h), bound) {
            return Some(output);
        }
        output = if output > center { output.next_down() } else { output.next_up() };
    }
    None
}
