//! A step of the odometry with the bounds of its noise.

use scalars::Interval;

use super::planar_box::check_bounded;
use crate::EstimatorError;

/// A step: a known turn and known shifts in body coordinates, and ranges of their noises, which need not be symmetric nor the same at each step.
///
/// The state `(theta, s, x_j, X_l)` moves by
///
/// ```text
/// theta+ = theta + turn + alpha,   x_j+ = x_j + s e^{i theta} (U_j + m_j),   s+ = s,   X_l+ = X_l
/// ```
///
/// with `m_j = n_j` for [`odometry`](Self::odometry) and `m_j = e^{i turn} V(i alpha) n_j`, `V(z) = (e^z - 1) / z`, for
/// [`exponential`](Self::exponential); for [`chord`](Self::chord) `U_j + m_j = e^{i alpha/2} (U_j + n_j U_j / |U_j|)`. `alpha` and the `n_j` are in
/// their ranges. What is known is an interval too: point intervals for plain numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanarIncrement {
    pub(super) turn: Interval,
    pub(super) turn_noise: Interval,
    pub(super) first: BodyShift,
    pub(super) others: Vec<BodyShift>,
    pub(super) form: Form,
}

/// How the noises enter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    Additive,
    Exponential,
    Chord,
}

/// The shift of one vector of the world, and the range of its noise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BodyShift {
    pub(super) shift: [Interval; 2],
    pub(super) noise: [Interval; 2],
}

impl PlanarIncrement {
    /// The motion of a group with noise on its right, `X+ = X exp(xi) exp(w)`, `xi = (turn, forward, left)` and `w` in `noise` likewise.
    ///
    /// **Source:** paper 000, (18), where `xi = delta u` and `w` is its `delta w`.
    ///
    /// ```
    /// use estimators::PlanarIncrement;
    /// use scalars::Interval;
    /// let noise = Interval::new(-1e-3, 1e-3)?;
    /// // A turn of 0.004 rad on an arc of 0.08 m.
    /// let step = PlanarIncrement::exponential([0.004, 0.08, 0.0].map(Interval::point), [noise; 3]);
    /// # Ok::<(), scalars::ScalarError>(())
    /// ```
    #[must_use]
    pub fn exponential(tangent: [Interval; 3], noise: [Interval; 3]) -> Self {
        let [turn, forward, left] = tangent;
        // V(i turn) = C_1 + i turn C_2 with the Stumpff functions C_k(turn^2).
        let (c, s) = (turn.sqr().stumpff(1), turn * turn.sqr().stumpff(2));
        let first = BodyShift { shift: [c * forward - s * left, s * forward + c * left], noise: [noise[1], noise[2]] };
        Self { turn, turn_noise: noise[0], first, others: Vec::new(), form: Form::Exponential }
    }

    /// Measured turn and shift with additive noises: the shift is that of the body frame before the turn.
    ///
    /// With a scale this is the odometry of paper 002, Problem 3; with scale 1 it is also the Euler discretisation of a
    /// unicycle, paper 000, (14).
    #[must_use]
    pub fn odometry(turn: Interval, shift: [Interval; 2], turn_noise: Interval, shift_noise: [Interval; 2]) -> Self {
        let first = BodyShift { shift, noise: shift_noise };
        Self { turn, turn_noise, first, others: Vec::new(), form: Form::Additive }
    }

    /// A longer way by its chord: `shift` is what dead reckoning makes of it, `noise` its error along and across itself, after half of the error
    /// of the turn is taken off.
    ///
    /// ```text
    /// theta+ = theta + turn + alpha,   x+ = x + s e^{i (theta + alpha/2)} (U + n U / |U|)
    /// ```
    ///
    /// A gyro that errs evenly turns the chord by half of what it errs in all: that is no error of the shift here, as it would be for
    /// [`odometry`](Self::odometry). `U / |U|` is 1 for `U = 0`. See [`InvariantStrips::bound_span`](crate::InvariantStrips::bound_span).
    #[must_use]
    pub fn chord(turn: Interval, shift: [Interval; 2], turn_noise: Interval, noise: [Interval; 2]) -> Self {
        Self { form: Form::Chord, ..Self::odometry(turn, shift, turn_noise, noise) }
    }

    /// The same step with the shift and the noise of one more vector of the world, in the order of the state.
    #[must_use]
    pub fn with_vector(mut self, shift: [Interval; 2], noise: [Interval; 2]) -> Self {
        self.others.push(BodyShift { shift, noise });
        self
    }

    /// Number of vectors of the world that are moved.
    pub(super) fn vectors(&self) -> usize {
        1 + self.others.len()
    }

    /// The shift of vector `j`.
    pub(super) fn of_vector(&self, j: usize) -> &BodyShift {
        if j == 0 { &self.first } else { &self.others[j - 1] }
    }

    pub(super) fn check(&self, vectors: usize) -> Result<(), EstimatorError> {
        crate::error::check_size("increment", vectors, self.vectors())?;
        check_bounded("turn", &[self.turn, self.turn_noise])?;
        for j in 0..self.vectors() {
            let shift = self.of_vector(j);
            check_bounded("shift", &shift.shift)?;
            check_bounded("noise of the shift", &shift.noise)?;
        }
        Ok(())
    }
}
