//! The nine settings of Problem 3 and what an independent computation reached there.

use std::f64::consts::PI;

use crate::guaranteed_invariant::lever::{Bounds, Constants, Increment};
use crate::noise::NoiseKind;

/// Period of the increments, s.
pub const PERIOD_S: f64 = 0.1;
/// Increments between two fixes.
pub const FIX_EVERY: usize = 10;
/// Speed of the vehicle, m/s.
const SPEED_M_S: f64 = 5.0;
/// Seconds on the circle, and all of them.
pub const SECONDS: [usize; 2] = [50, 100];
/// Seconds at which the heading is looked at.
pub const LOOKED_AT_S: [usize; 3] = [10, 60, 100];
/// Prior bounds of the scale.
pub const SCALE_PRIOR: [f64; 2] = [0.8, 1.25];
/// Prior bound of each coordinate of the arm, m.
pub const ARM_PRIOR_M: f64 = 3.0;
/// Prior bound of each coordinate of the position, m.
pub const POSITION_PRIOR_M: f64 = 10.0;

/// Widths that an independent computation in plain floating point reached in one run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Heading at 10, 60 and 100 s, rad.
    pub heading_rad: [f64; 3],
    /// Scale at 100 s.
    pub scale: f64,
    /// Arm at 100 s, m.
    pub arm_m: [f64; 2],
}

/// One setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// ASCII label of the row.
    pub label: &'static str,
    /// Turn rate on the circle, rad/s.
    pub turn_rate_rad_s: f64,
    /// Bounds: gyro (rad/s), speed (m/s), position (m).
    pub bounds: [f64; 3],
    /// The noises.
    pub kind: NoiseKind,
    /// The truth.
    pub constants: Constants,
    /// Widths to compare with.
    pub reference: Reference,
}

impl Setting {
    /// Bounds per increment.
    #[must_use]
    pub fn step_bounds(&self) -> Bounds {
        let [gyro, speed, fix_m] = self.bounds;
        Bounds { turn_rad: PERIOD_S * gyro, shift_m: [PERIOD_S * speed; 2], fix_m }
    }

    /// The measured increments: a circle, then a straight line. The wheels see the true speed divided by the scale.
    #[must_use]
    pub fn increments(&self) -> Vec<Increment> {
        let shift_m = [SPEED_M_S * PERIOD_S / self.constants.scale, 0.0];
        let [circle, all] = SECONDS.map(|seconds| seconds * FIX_EVERY);
        let turn = |k: usize| if k < circle { PERIOD_S * self.turn_rate_rad_s } else { 0.0 };
        (0..all).map(|k| Increment { turn_rad: turn(k), shift_m }).collect()
    }
}

const SLOW: f64 = PI / 25.0;
const FAST: f64 = 2.0 * PI / 10.0;
const ONE: Constants = Constants { scale: 1.0, arm_m: [1.0, 0.5] };
const LARGE: Constants = Constants { scale: 1.2, arm_m: [-2.0, 1.0] };
const UNIFORM: NoiseKind = NoiseKind::Uniform;
const CONSTANT: NoiseKind = NoiseKind::ConstantVertex;

/// All settings, in the order of the table.
pub const SETTINGS: [Setting; 9] = [
    setting("pi/25;.01,.1,1", SLOW, [0.01, 0.1, 1.0], UNIFORM, ONE, ([0.396, 0.250, 0.218], 0.137, [6.0, 6.0])),
    setting("pi/25;.01,.1,1;const", SLOW, [0.01, 0.1, 1.0], CONSTANT, ONE, ([0.564, 0.323, 0.290], 0.219, [6.0, 6.0])),
    setting("pi/25;.001,.02,1", SLOW, [0.001, 0.02, 1.0], UNIFORM, ONE, ([0.236, 0.087, 0.050], 0.026, [5.7, 5.4])),
    setting("2pi/10;.001,.02,1", FAST, [0.001, 0.02, 1.0], UNIFORM, ONE, ([1.40, 0.084, 0.049], 0.025, [2.11, 2.30])),
    setting("2pi/10;.01,.1,.1", FAST, [0.01, 0.1, 0.1], UNIFORM, ONE, ([1.47, 0.119, 0.115], 0.071, [4.2, 4.1])),
    setting("2pi/10;.001,.02,.1", FAST, [0.001, 0.02, 0.1], UNIFORM, ONE, ([1.31, 0.025, 0.022], 0.011, [0.91, 0.95])),
    setting("pi/25;.001,.02,.1", SLOW, [0.001, 0.02, 0.1], UNIFORM, ONE, ([0.204, 0.025, 0.022], 0.013, [3.42, 2.63])),
    setting(
        "2pi/10;.001,.02,.1;const",
        FAST,
        [0.001, 0.02, 0.1],
        CONSTANT,
        ONE,
        ([1.33, 0.030, 0.027], 0.016, [1.08, 1.08]),
    ),
    setting(
        "2pi/10;.001,.02,.1;s=1.2",
        FAST,
        [0.001, 0.02, 0.1],
        UNIFORM,
        LARGE,
        ([1.09, 0.024, 0.021], 0.013, [0.98, 1.03]),
    ),
];

/// Index in [`SETTINGS`] of the setting with the sharpest sensors on the fast circle.
pub const SHARP: usize = 5;

const fn setting(
    label: &'static str,
    turn_rate_rad_s: f64,
    bounds: [f64; 3],
    kind: NoiseKind,
    constants: Constants,
    (heading_rad, scale, arm_m): ([f64; 3], f64, [f64; 2]),
) -> Setting {
    Setting { label, turn_rate_rad_s, bounds, kind, constants, reference: Reference { heading_rad, scale, arm_m } }
}
