//! The papers' metrics of one run: RMSE and AAR.

use std::f64::consts::{PI, TAU};

/// The angle modulo `2 pi` in `(-pi, pi]`, up to rounding.
#[must_use]
pub fn wrap_angle(angle_rad: f64) -> f64 {
    let wrapped = angle_rad - TAU * (angle_rad / TAU).round();
    if wrapped <= -PI { wrapped + TAU } else { wrapped }
}

/// Sums over the steps of one run, from which its metrics follow.
///
/// **Source:** paper 000, section IV: `RMSE(theta)`, `RMSE(x)`, `AAR(theta)`, `AAR(x)`, all over `k = 1..N`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RunSums {
    steps: usize,
    heading_sq: f64,
    position_sq: f64,
    heading_width: f64,
    position_area: f64,
}

impl RunSums {
    /// Adds one step: the errors of the centre (heading in rad, wrapped here; position in m) and the widths of the box
    /// (`theta`, `x1`, `x2`) of the set.
    pub fn add_step(&mut self, heading_error_rad: f64, position_error: [f64; 2], widths: [f64; 3]) {
        let heading = wrap_angle(heading_error_rad);
        self.steps += 1;
        self.heading_sq += heading * heading;
        self.position_sq += position_error[0] * position_error[0] + position_error[1] * position_error[1];
        self.heading_width += widths[0];
        self.position_area += widths[1] * widths[2];
    }

    /// The metrics of the steps added so far (NaN when there is none).
    #[must_use]
    pub fn metrics(&self) -> RunMetrics {
        let steps = self.steps as f64;
        RunMetrics {
            rmse_heading: (self.heading_sq / steps).sqrt(),
            rmse_position: (self.position_sq / steps).sqrt(),
            aar_heading: self.heading_width / steps,
            aar_position: self.position_area / steps,
        }
    }
}

/// The metrics of one run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RunMetrics {
    /// Root mean square of the heading error, rad.
    pub rmse_heading: f64,
    /// Root mean square of the position error, m.
    pub rmse_position: f64,
    /// Mean width of the heading interval, rad.
    pub aar_heading: f64,
    /// Mean area of the position box, m^2.
    pub aar_position: f64,
}

impl RunMetrics {
    /// Names of the metrics and their units, in the order of [`values`](Self::values).
    pub const NAMES: [(&'static str, &'static str); 4] =
        [("RMSE(theta)", "rad"), ("RMSE(x)", "m"), ("AAR(theta)", "rad"), ("AAR(x)", "m^2")];

    /// The four values, in the order of [`NAMES`](Self::NAMES).
    #[must_use]
    pub fn values(&self) -> [f64; 4] {
        [self.rmse_heading, self.rmse_position, self.aar_heading, self.aar_position]
    }
}
