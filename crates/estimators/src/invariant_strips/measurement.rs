//! Measurements that are linear in the embedding.

use scalars::Interval;

use super::planar_box::check_bounded;
use crate::EstimatorError;

/// A measurement of two numbers with the ranges of their noises.
///
/// - [`position`](Self::position): `y = a + v` in world coordinates,
/// - [`landmark`](Self::landmark): `y = R(theta)^T (p - a) + v` in body coordinates, `p` a known place,
/// - [`range_bearing`](Self::range_bearing) of a known place,
///
/// where `a` is the place of the sensor: `a = x_j`, `a = x_j + R(theta) r` with a known arm `r`
/// ([`with_arm`](Self::with_arm)) or `a = x_j + R(theta) X_l` with an arm of the state ([`with_unknown_arm`](Self::with_unknown_arm)).
///
/// Known arms and landmarks are linear in the embedding only if the scale is known to be 1; otherwise a filter refuses them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanarMeasurement {
    pub(super) vector: usize,
    pub(super) arm: Arm,
    pub(super) reading: Reading,
}

/// Where the sensor is on the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Arm {
    None,
    Known([f64; 2]),
    Unknown(usize),
}

/// What is known of the sensor's place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Reading {
    /// The place lies in this box of the world.
    Place([Interval; 2]),
    /// The vector from the sensor to `place`, in body coordinates, lies in `center + axis (along + i across)`, `|axis| = 1` but for rounding.
    Body { place: [Interval; 2], center: [f64; 2], axis: [f64; 2], radii: [f64; 2] },
}

impl PlanarMeasurement {
    /// The place of the sensor in world coordinates, `y = a + v`, `v` in `noise`.
    #[must_use]
    pub fn position(y: [f64; 2], noise: [Interval; 2]) -> Self {
        let place = [0, 1].map(|k| Interval::point(y[k]) - noise[k]);
        Self { vector: 0, arm: Arm::None, reading: Reading::Place(place) }
    }

    /// A known place seen from the sensor, `y = R(theta)^T (p - a) + v`, `v` in `noise`, body coordinates.
    #[must_use]
    pub fn landmark(place: [Interval; 2], y: [f64; 2], noise: [Interval; 2]) -> Self {
        let seen = [0, 1].map(|k| Interval::point(y[k]) - noise[k]);
        let reading =
            Reading::Body { place, center: seen.map(|s| s.mid()), axis: [1.0, 0.0], radii: seen.map(|s| s.rad()) };
        Self { vector: 0, arm: Arm::None, reading }
    }

    /// Distance and bearing (rad, from the body's first axis) of a known place, each in a range that holds the true value.
    ///
    /// The polar box is enclosed in a rectangle along the middle of the bearings.
    #[must_use]
    pub fn range_bearing(place: [Interval; 2], range: Interval, bearing_rad: Interval) -> Self {
        let middle = Interval::point(bearing_rad.mid());
        let (sin, cos) = (bearing_rad - middle).sin_cos();
        let (axis_sin, axis_cos) = middle.sin_cos();
        let axis = [axis_cos.mid(), axis_sin.mid()];
        // The axis is off the direction `middle` by at most 4 units of 2^-53 of itself in each entry.
        let slip = scalars::rounding::mul_up(range.mag(), 16.0 * scalars::rounding::UNIT_ROUNDOFF);
        let (along, across) = ((range * cos).inflate(slip), (range * sin).inflate(slip));
        let center = [
            Interval::point(axis[0]).scale(along.mid()) - Interval::point(axis[1]).scale(across.mid()),
            Interval::point(axis[1]).scale(along.mid()) + Interval::point(axis[0]).scale(across.mid()),
        ];
        let lost = scalars::rounding::add_up(center[0].rad(), center[1].rad());
        let radii = [along, across].map(|side| scalars::rounding::add_up(side.rad(), 2.0 * lost));
        let reading = Reading::Body { place, center: center.map(|c| c.mid()), axis, radii };
        Self { vector: 0, arm: Arm::None, reading }
    }

    /// The same measurement of vector `j` of the world instead of the first.
    #[must_use]
    pub fn of_vector(self, j: usize) -> Self {
        Self { vector: j, ..self }
    }

    /// The same measurement by a sensor at `arm`, body coordinates.
    #[must_use]
    pub fn with_arm(self, arm: [f64; 2]) -> Self {
        Self { arm: Arm::Known(arm), ..self }
    }

    /// The same measurement by a sensor at vector `l` of the body.
    #[must_use]
    pub fn with_unknown_arm(self, l: usize) -> Self {
        Self { arm: Arm::Unknown(l), ..self }
    }

    /// `Ok` if a state with these numbers of vectors gives the measurement, linear in the embedding.
    pub(super) fn check(&self, fixed: usize, body: usize, scale: Interval) -> Result<(), EstimatorError> {
        if self.vector >= fixed {
            return Err(EstimatorError::Size {
                what: "measured vector",
                expected: fixed,
                found: self.vector.saturating_add(1),
            });
        }
        let mut linear = true;
        match self.arm {
            Arm::None => {}
            Arm::Known(arm) => {
                crate::error::check_finite("arm", &arm)?;
                linear = false;
            }
            Arm::Unknown(l) if l >= body => {
                return Err(EstimatorError::Size { what: "measured arm", expected: body, found: l.saturating_add(1) });
            }
            Arm::Unknown(_) => {}
        }
        match &self.reading {
            Reading::Place(place) => check_bounded("measurement", place)?,
            Reading::Body { place, center, radii, .. } => {
                check_bounded("landmark", place)?;
                crate::error::check_finite("measurement", center)?;
                crate::error::check_finite("noise of the measurement", radii)?;
                linear = false;
            }
        }
        if linear || scale == Interval::ONE { Ok(()) } else { Err(EstimatorError::ScaleUnknown { scale }) }
    }
}
