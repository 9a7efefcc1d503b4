//! Measurements that are linear in the embedding.

use scalars::Interval;

use super::space::{Region, Vector};
use crate::EstimatorError;
use crate::error::check_finite;
use crate::invariant_strips::check_bounded;

/// A measurement of three numbers with the ranges of their noises.
///
/// - [`vector`](Self::vector): `y = a + v` in world coordinates,
/// - [`landmark`](Self::landmark): `y = R'(p - a) + v` in body coordinates, `p` a known place,
/// - [`direction`](Self::direction): `y = R'g + v` in body coordinates, `g` a known vector of the world: gravity, the magnetic field,
///
/// where `a = x_j`, or `a = x_j + R l` for a sensor at a known arm ([`with_arm`](Self::with_arm)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpatialMeasurement {
    pub(super) vector: usize,
    pub(super) arm: Vector,
    pub(super) reading: Reading,
}

/// What is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Reading {
    /// The place of the sensor lies in this box of the world.
    Place(Region),
    /// The vector from the sensor to `place`, in body coordinates, lies in `seen`.
    Landmark { place: Region, seen: Region },
    /// `world`, in body coordinates, lies in `seen`.
    Direction { world: Region, seen: Region },
}

/// The values that `y = value + v` leaves.
fn without_noise(y: Vector, noise: &Region) -> Region {
    core::array::from_fn(|k| Interval::point(y[k]) - noise[k])
}

impl SpatialMeasurement {
    /// The place of a sensor, or another vector, in world coordinates, `y = a + v`, `v` in `noise`.
    #[must_use]
    pub fn vector(y: [f64; 3], noise: [Interval; 3]) -> Self {
        Self { vector: 0, arm: [0.0; 3], reading: Reading::Place(without_noise(y, &noise)) }
    }

    /// A known place seen from the sensor, `y = R'(p - a) + v`, `v` in `noise`, body axes.
    #[must_use]
    pub fn landmark(place: [Interval; 3], y: [f64; 3], noise: [Interval; 3]) -> Self {
        let reading = Reading::Landmark { place, seen: without_noise(y, &noise) };
        Self { vector: 0, arm: [0.0; 3], reading }
    }

    /// A known vector of the world seen in body axes, `y = R'g + v`, `v` in `noise`.
    #[must_use]
    pub fn direction(world: [Interval; 3], y: [f64; 3], noise: [Interval; 3]) -> Self {
        let reading = Reading::Direction { world, seen: without_noise(y, &noise) };
        Self { vector: 0, arm: [0.0; 3], reading }
    }

    /// The same measurement of vector `j` instead of the first.
    #[must_use]
    pub fn of_vector(self, j: usize) -> Self {
        Self { vector: j, ..self }
    }

    /// The same measurement by a sensor at `arm`, body coordinates.
    #[must_use]
    pub fn with_arm(self, arm: [f64; 3]) -> Self {
        Self { arm, ..self }
    }

    /// Whether its noise lies along the body's axes.
    pub(super) fn is_of_body(&self) -> bool {
        !matches!(self.reading, Reading::Place(_))
    }

    /// `Ok` if a state with this number of vectors gives the measurement.
    pub(super) fn check(&self, vectors: usize) -> Result<(), EstimatorError> {
        if self.vector >= vectors {
            return Err(EstimatorError::Size {
                what: "measured vector",
                expected: vectors,
                found: self.vector.saturating_add(1),
            });
        }
        check_finite("arm", &self.arm)?;
        match &self.reading {
            Reading::Place(place) => check_bounded("measurement", place),
            Reading::Landmark { place, seen } => {
                check_bounded("landmark", place)?;
                check_bounded("measurement", seen)
            }
            Reading::Direction { world, seen } => {
                check_bounded("direction", world)?;
                check_bounded("measurement", seen)
            }
        }
    }
}
