//! Bounds of the set at one instant, kept as rows with a noise account of their own.
//!
//! Two old rows that together bound a position each pay the noise of all steps since; their sum as one row pays it once.

use scalars::Interval;

use super::InvariantStrips;
use super::measurement::{Arm, PlanarMeasurement};
use super::plane::{Vector, conjugate_product, middle, point, product, unit};
use super::tags::{Origin, Tag};
use crate::EstimatorError;

/// Directions, an even turn apart, in which the place of a sensor is bounded.
const SENSOR: u32 = 8;

/// The same for a position, an arm and the scaled heading.
const OTHER: u32 = 4;

/// The four directions of the axes.
const AXES: [Vector; 4] = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];

impl InvariantStrips {
    /// The hull of each vector of the world as rows: no program is needed.
    pub(super) fn push_hulls(&mut self) -> Result<(), EstimatorError> {
        for j in 0..self.enclosure.fixed.len() {
            for (k, d) in AXES.into_iter().enumerate() {
                let [x, y] = self.enclosure.fixed[j];
                let limit = [x.hi(), -x.lo(), y.hi(), -y.lo()][k];
                self.aim(j, d);
                self.push_row(limit, self.bound_tag(4 * j + k))?;
            }
        }
        Ok(())
    }

    /// Bounds of each measured sensor along, across and between the axes of the track, of the position, the arms and the scaled
    /// heading along and across it: the noise of the turns is transversal to the track, and world axes would pay it twice.
    pub(super) fn push_aligned(&mut self, measurements: &[PlanarMeasurement]) -> Result<(), EstimatorError> {
        let toward = self.middle_heading();
        self.union.asked.clear();
        for measurement in measurements {
            for k in 0..SENSOR {
                self.aim_at_sensor(measurement, spoke(toward, k, SENSOR));
                self.ask();
            }
        }
        for j in 0..self.enclosure.fixed.len() {
            for k in 0..OTHER {
                self.aim(j, spoke(toward, k, OTHER));
                self.ask();
            }
        }
        let middle_of_arc = Interval::point(self.arc.middle());
        for l in 0..=self.enclosure.body.len() {
            // The arms, then the heading.
            let column = if l < self.enclosure.body.len() { self.embedding.body(l) } else { 0 };
            for k in 0..OTHER {
                let d = spoke(middle_of_arc, k, OTHER);
                self.normal.fill(0.0);
                self.normal[column..column + 2].copy_from_slice(&d);
                self.ask();
            }
        }
        self.push_asked(4 * self.enclosure.fixed.len())
    }

    /// Puts the functional `self.normal` on the list.
    fn ask(&mut self) {
        self.union.asked.extend_from_slice(&self.normal);
    }

    /// The bounds of all functionals on the list as rows, of classes from `class` on.
    fn push_asked(&mut self, class: usize) -> Result<(), EstimatorError> {
        self.bound_asked()?;
        let n = self.normal.len();
        for k in 0..self.union.bounds.len() {
            self.normal.copy_from_slice(&self.union.asked[k * n..(k + 1) * n]);
            self.push_row(self.union.bounds[k], self.bound_tag(class + k))?;
        }
        Ok(())
    }

    /// The functional `<d, x_j>` into `self.normal`, up to rounding: whatever stands there is bounded.
    pub(super) fn aim(&mut self, j: usize, d: Vector) {
        let s = self.path[j];
        self.normal.fill(0.0);
        self.normal[0] = s[0] * d[0] + s[1] * d[1];
        self.normal[1] = s[0] * d[1] - s[1] * d[0];
        let column = self.embedding.fixed(j);
        self.normal[column..column + 2].copy_from_slice(&d);
    }

    /// The functional `<d, a>` for the place `a` of a sensor, up to rounding.
    fn aim_at_sensor(&mut self, measurement: &PlanarMeasurement, d: Vector) {
        self.aim(measurement.vector, d);
        let reference = unit(Interval::point(self.reference));
        let turned = middle(&conjugate_product(&reference, &point(d)));
        match measurement.arm {
            Arm::None => {}
            Arm::Known(r) => {
                let lever = middle(&conjugate_product(&product(&reference, &point(r)), &point(d)));
                self.normal[0] += lever[0];
                self.normal[1] += lever[1];
            }
            Arm::Unknown(l) => {
                let column = self.embedding.body(l);
                self.normal[column..column + 2].copy_from_slice(&turned);
            }
        }
    }

    /// Classes of bounds are odd, those of measurements even.
    fn bound_tag(&self, class: usize) -> Tag {
        Tag { origin: Origin::Bound, class: 2 * class + 1, born: self.instant, used: 0 }
    }
}

/// Direction `k` of `count` around `toward`.
fn spoke(toward: Interval, k: u32, count: u32) -> Vector {
    let angle = toward.mid() + core::f64::consts::TAU * f64::from(k) / f64::from(count);
    middle(&unit(Interval::point(angle)))
}
