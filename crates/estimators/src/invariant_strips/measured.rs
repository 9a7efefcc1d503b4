//! Rows of a measurement.
//!
//! The place of a sensor is `a = x + e^{i theta_hat} z r` (known arm, scale 1) or `a = x + e^{i theta_hat} xi` (unknown arm). A box of places
//! gives four rows `<d, a> <= h`. A known place `p` that the sensor sees at `w` in body coordinates obeys
//! `a + e^{i theta_hat} z w = p`, so with `w = c + w'` and `w'` in a turned rectangle
//!
//! ```text
//! <d, a + e^{i theta_hat} z c> <= sup <d, p> + sup <d, e^{i theta} w'>
//! ```

use scalars::Interval;
use scalars::rounding::{add_up, mul_up};

use super::InvariantStrips;
use super::measurement::{Arm, PlanarMeasurement, Reading};
use super::plane::{
    Region, Vector, conjugate_product, inner, largest_modulus, middle, norm1, point, product, radius, sum, unit,
};
use super::sweep::Sweep;
use super::tags::{Origin, Tag};
use crate::EstimatorError;

/// The four directions of the axes: those along which ranges are given.
const AXES: [Vector; 4] = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];

impl InvariantStrips {
    /// Appends the rows of all measurements of an instant.
    pub(super) fn push_measurements(&mut self, measurements: &[PlanarMeasurement]) -> Result<(), EstimatorError> {
        for (m, measurement) in measurements.iter().enumerate() {
            for k in 0..4 {
                let origin = Origin::Measured { step: self.step, entry: 2 * m + k / 2 };
                self.push_measured(
                    measurement,
                    k,
                    Tag { origin, class: 2 * (4 * m + k), born: self.instant, used: 0 },
                )?;
            }
        }
        Ok(())
    }

    fn push_measured(&mut self, measurement: &PlanarMeasurement, k: usize, tag: Tag) -> Result<(), EstimatorError> {
        match &measurement.reading {
            Reading::Place(place) => {
                let d = AXES[k];
                let limit = inner(&point(d), place).hi();
                self.push_place_row(d, measurement.vector, measurement.arm, &[Interval::ZERO; 2], limit, tag)
            }
            Reading::Body { place, center, axis, radii } => {
                // Along the sides of the rectangle as they lie in the world for the middle of the arc.
                let turned = product(&unit(self.middle_heading()), &product(&point(*axis), &point(AXES[k])));
                let d = middle(&turned);
                let corner = |across: f64| middle(&product(&point(*axis), &point([radii[0], across])));
                // Corners are rounded by some units of their length.
                let lost = mul_up(8.0 * f64::EPSILON, add_up(radii[0], radii[1]));
                let sweep = Sweep::new(self.heading(), &[corner(radii[1]), corner(-radii[1])]);
                let noise = add_up(sweep.sup_abs(d), mul_up(lost, norm1(d)));
                let limit = add_up(inner(&point(d), place).hi(), noise);
                self.push_place_row(d, measurement.vector, measurement.arm, &point(*center), limit, tag)
            }
        }
    }

    /// Appends `<d, a + e^{i theta_hat} z c> <= limit`, where `a` is the place of the sensor; `c` other than 0 only with scale 1.
    fn push_place_row(
        &mut self,
        d: Vector,
        vector: usize,
        arm: Arm,
        c: &Region,
        limit: f64,
        tag: Tag,
    ) -> Result<(), EstimatorError> {
        let reference = unit(Interval::point(self.reference));
        let levers = match arm {
            Arm::Known(r) => sum(c, &point(r)),
            Arm::None | Arm::Unknown(_) => *c,
        };
        // <d, S z + e^{i theta_hat} c z> = <conj(S + e^{i theta_hat} c) d, z>
        let path = sum(&point(self.path[vector]), &product(&reference, &levers));
        let heading = conjugate_product(&path, &point(d));
        let mut limit = add_up(limit, mul_up(radius(&heading), self.enclosure.scale.hi()));
        self.normal.fill(0.0);
        self.normal[..2].copy_from_slice(&middle(&heading));
        let column = self.embedding.fixed(vector);
        self.normal[column..column + 2].copy_from_slice(&d);
        if let Arm::Unknown(l) = arm {
            let turned = conjugate_product(&reference, &point(d));
            let column = self.embedding.body(l);
            self.normal[column..column + 2].copy_from_slice(&middle(&turned));
            limit = add_up(limit, mul_up(radius(&turned), largest_modulus(&self.enclosure.body[l])));
        }
        self.push_row(limit, tag)
    }

    /// Appends the row in `self.normal`.
    pub(super) fn push_row(&mut self, limit: f64, tag: Tag) -> Result<(), EstimatorError> {
        self.rows.push(&self.normal, limit)?;
        self.tags.push(tag);
        Ok(())
    }

    /// The heading of the middle of the arc.
    pub(super) fn middle_heading(&self) -> Interval {
        Interval::point(self.reference) + Interval::point(self.arc.middle())
    }
}
