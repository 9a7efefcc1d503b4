//! A step of the odometry, or of an inertial unit, with the bounds of its noise.

use scalars::Interval;

use super::space::{Region, Vector, rest};
use crate::EstimatorError;
use crate::error::{check_finite, check_size};
use crate::invariant_strips::check_bounded;

/// A step: a known turn, known shifts in body and world coordinates, and ranges of their noises, which need be neither symmetric nor the same at each step.
///
/// The state `(R, x_1 .. x_K)` moves by
///
/// ```text
/// R+ = R exp(turn) exp(alpha),   x_j+ = x_j + w_j + sum_{i > j} c_ji x_i + R (U_j + n_j)
/// ```
///
/// `alpha` and `n_j` in ranges, body axes; `U_j` and `w_j` are ranges as well, point intervals for plain numbers: what is not known of `w_j` is a noise along the
/// world's axes. A vector is coupled to later ones only: position, velocity, acceleration in this order.
#[derive(Debug, Clone, PartialEq)]
pub struct SpatialIncrement {
    pub(super) turn: Vector,
    pub(super) turn_noise: Region,
    pub(super) vectors: Vec<VectorMotion>,
}

/// How one vector moves.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct VectorMotion {
    /// `U`.
    pub(super) shift: Region,
    pub(super) noise: Region,
    /// `w`.
    pub(super) drift: Region,
    pub(super) couplings: Vec<(usize, f64)>,
}

impl VectorMotion {
    fn new(shift: Region, noise: Region) -> Self {
        Self { shift, noise, drift: [Interval::ZERO; 3], couplings: Vec::new() }
    }
}

impl SpatialIncrement {
    /// A measured turn (a rotation vector, rad) and shift of the first vector, in the body frame before the turn, with noises added.
    ///
    /// ```
    /// use estimators::SpatialIncrement;
    /// use scalars::Interval;
    /// let (angle, length) = (Interval::new(-1e-3, 1e-3)?, Interval::new(-0.01, 0.01)?);
    /// // Half a metre ahead, and a turn of 0.05 rad to the left.
    /// let step = SpatialIncrement::odometry([0.0, 0.0, 0.05], [0.5, 0.0, 0.0].map(Interval::point), [angle; 3], [length; 3]);
    /// # Ok::<(), scalars::ScalarError>(())
    /// ```
    #[must_use]
    pub fn odometry(
        turn: [f64; 3],
        shift: [Interval; 3],
        turn_noise: [Interval; 3],
        shift_noise: [Interval; 3],
    ) -> Self {
        Self { turn, turn_noise, vectors: vec![VectorMotion::new(shift, shift_noise)] }
    }

    /// A step of an inertial unit, vectors position and velocity: angular rate and specific force, body axes, constant over `dt_s` seconds.
    ///
    /// ```text
    /// R+ = R exp(dt (rate + n)),   v+ = v + dt g + dt R (force + m),   p+ = p + dt v + dt^2/2 g + dt^2/2 R (force + m)
    /// ```
    ///
    /// with `n`, `m` in the ranges given; the force is turned by the attitude at the beginning of the step.
    ///
    /// # Errors
    /// Numbers that are not finite.
    pub fn inertial(
        rate: [f64; 3],
        force: [f64; 3],
        rate_noise: [Interval; 3],
        force_noise: [Interval; 3],
        gravity: [Interval; 3],
        dt_s: f64,
    ) -> Result<Self, EstimatorError> {
        let dt = Interval::point(dt_s);
        let half = (dt * dt).scale(0.5);
        let turn = rate.map(|r| r * dt_s);
        check_finite("turn", &turn)?;
        check_bounded("noise of the rate", &rate_noise)?;
        // exp(turn + n) = exp(turn) exp(alpha), with the rounding of the turn in n.
        let off =
            core::array::from_fn(|k| Interval::point(rate[k]) * dt - Interval::point(turn[k]) + dt * rate_noise[k]);
        let turn_noise = rest(turn, &off)?;
        let motion = |factor: Interval| VectorMotion {
            shift: force.map(|f| Interval::point(f) * factor),
            noise: force_noise.map(|n| n * factor),
            drift: gravity.map(|g| g * factor),
            couplings: Vec::new(),
        };
        let mut position = motion(half);
        position.couplings.push((1, dt_s));
        Ok(Self { turn, turn_noise, vectors: vec![position, motion(dt)] })
    }

    /// The same step with the shift and the noise of one more vector, body axes, in the order of the state.
    #[must_use]
    pub fn with_vector(mut self, shift: [Interval; 3], noise: [Interval; 3]) -> Self {
        self.vectors.push(VectorMotion::new(shift, noise));
        self
    }

    /// The same step with `w` for vector `j`, world axes.
    ///
    /// # Errors
    /// No such vector.
    pub fn with_drift(mut self, j: usize, drift: [Interval; 3]) -> Result<Self, EstimatorError> {
        self.vector(j)?.drift = drift;
        Ok(self)
    }

    /// The same step with `c x_i` added to vector `j`, `i > j`.
    ///
    /// # Errors
    /// No such vectors, or not in this order.
    pub fn with_coupling(mut self, j: usize, i: usize, c: f64) -> Result<Self, EstimatorError> {
        let expected = self.vectors.len();
        if i <= j || i >= expected {
            return Err(EstimatorError::Size { what: "coupled vector", expected, found: i.saturating_add(1) });
        }
        self.vector(j)?.couplings.push((i, c));
        Ok(self)
    }

    fn vector(&mut self, j: usize) -> Result<&mut VectorMotion, EstimatorError> {
        let expected = self.vectors.len();
        self.vectors.get_mut(j).ok_or(EstimatorError::Size {
            what: "moved vector",
            expected,
            found: j.saturating_add(1),
        })
    }

    pub(super) fn check(&self, vectors: usize) -> Result<(), EstimatorError> {
        check_size("increment", vectors, self.vectors.len())?;
        check_finite("turn", &self.turn)?;
        check_bounded("turn noise", &self.turn_noise)?;
        for motion in &self.vectors {
            check_bounded("shift", &motion.shift)?;
            check_bounded("noise of the shift", &motion.noise)?;
            check_bounded("drift", &motion.drift)?;
            for &(_, c) in &motion.couplings {
                check_finite("coupling", &[c])?;
            }
        }
        Ok(())
    }
}
