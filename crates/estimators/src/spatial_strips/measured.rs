//! Rows of a measurement.
//!
//! The place of a sensor is `a = x + Z P l`. A box of places gives six rows `<u, a> <= h`. A known place `p` that the sensor sees at `w` in body
//! coordinates obeys `a + Z P w = p`, a known vector `g` obeys `Z P w = g`: with `w = c + w'`, `|w'_i| <= rho_i`,
//!
//! ```text
//! <u, a + Z P c> <= sup <u, p> + sum_i rho_i max |<p_i u', exp(-r)>|,      p_i the columns of C P
//! ```
//!
//! and the same without `a`. There `u` is along the columns, where the box of `w'` is smallest.

use lie_groups::{Enclose, LieGroup};
use scalars::Interval;
use scalars::rounding::{UNIT_ROUNDOFF, add_up, mul_up};

use super::SpatialStrips;
use super::frame::ENTRIES;
use super::measurement::{Reading, SpatialMeasurement};
use super::space::{
    AXES, Matrix, Region, Vector, apply, inner, largest_radius, matrix_of, middle, middle_of, norm1, point, product,
    sum, transposed,
};
use super::spread::Spread;
use crate::EstimatorError;
use crate::invariant_strips::{Origin, Tag};

impl SpatialStrips {
    /// Appends the rows of all measurements of an instant.
    pub(super) fn push_measurements(&mut self, measurements: &[SpatialMeasurement]) -> Result<(), EstimatorError> {
        for (m, measurement) in measurements.iter().enumerate() {
            for k in 0..6 {
                let origin = Origin::Measured { step: self.step, entry: 3 * m + k / 2 };
                let tag = Tag { origin, class: 2 * (6 * m + k), born: self.instant, used: 0 };
                self.push_measured(measurement, k / 2, if k % 2 == 0 { 1.0 } else { -1.0 }, tag)?;
            }
        }
        Ok(())
    }

    fn push_measured(
        &mut self,
        measurement: &SpatialMeasurement,
        axis: usize,
        sign: f64,
        tag: Tag,
    ) -> Result<(), EstimatorError> {
        let facing = matrix_of(&self.frame.attitude);
        let arm = apply(&facing, &point(measurement.arm));
        let vector = Some(measurement.vector);
        match &measurement.reading {
            Reading::Place(place) => {
                let u = AXES[axis].map(|x| sign * x);
                self.push_functional(vector, u, &arm, inner(&point(u), place).hi(), tag)
            }
            Reading::Landmark { place, seen } => {
                let u = self.body_axis(axis).map(|x| sign * x);
                let lever = sum(&arm, &apply(&facing, &point(middle(seen))));
                let limit = add_up(inner(&point(u), place).hi(), self.turned_noise(u, seen));
                self.push_functional(vector, u, &lever, limit, tag)
            }
            Reading::Direction { world, seen } => {
                let u = self.body_axis(axis).map(|x| sign * x);
                let lever = apply(&facing, &point(middle(seen)));
                let limit = add_up(inner(&point(u), world).hi(), self.turned_noise(u, seen));
                self.push_functional(None, u, &lever, limit, tag)
            }
        }
    }

    /// About where body axis `i` lies in the world.
    fn body_axis(&self, i: usize) -> Vector {
        let center = self.cells[self.cells.len() / 2].center.compose(&self.frame.attitude);
        let column = center.rotation_matrix().column(i).into_owned();
        [column[0], column[1], column[2]]
    }

    /// Upper bound of `max <u, R w>` over the cells and the box of `w` around 0 with the radii of `seen`.
    fn turned_noise(&self, u: Vector, seen: &Region) -> f64 {
        let facing = matrix_of(&self.frame.attitude);
        let mut most = 0.0_f64;
        for cell in &self.cells {
            let axes = transposed(&product(&matrix_of(&cell.center), &facing));
            let (spread, columns) = (Spread::new(&cell.turn), middle_of(&axes));
            let pad = norm1(u) * (30.0 * largest_radius(&axes) + 1000.0 * UNIT_ROUNDOFF);
            let mut noise = 0.0;
            for i in 0..3 {
                let k: Matrix = columns[i].map(|p| u.map(|u| p * u));
                noise = add_up(noise, mul_up(seen[i].rad(), add_up(spread.sup_abs(&k), pad)));
            }
            most = most.max(noise);
        }
        most
    }

    /// Appends `<u, x_j + Z a> <= limit`, or `<u, Z a> <= limit`.
    pub(super) fn push_functional(
        &mut self,
        j: Option<usize>,
        u: Vector,
        a: &Region,
        limit: f64,
        tag: Tag,
    ) -> Result<(), EstimatorError> {
        let constant = self.frame.aim(&mut self.exact, j, &point(u), a);
        let lost = self.round();
        let limit = (Interval::point(limit) - constant).hi();
        self.push_row(add_up(limit, lost), tag)
    }

    /// The functional `self.exact`, rounded, into `self.normal`; by how much its value is off at most.
    pub(super) fn round(&mut self) -> f64 {
        let mut lost = 0.0;
        for (k, (normal, exact)) in self.normal.iter_mut().zip(&self.exact).enumerate() {
            *normal = exact.mid();
            let farthest = if k < ENTRIES { 1.0 } else { self.reach.as_flattened()[k - ENTRIES].mag() };
            lost = add_up(lost, mul_up(exact.rad(), farthest));
        }
        lost
    }

    /// Appends the row in `self.normal`.
    pub(super) fn push_row(&mut self, limit: f64, tag: Tag) -> Result<(), EstimatorError> {
        self.rows.push(&self.normal, limit)?;
        self.tags.push(tag);
        Ok(())
    }

    /// The box of each vector as rows, along the axes of the world.
    pub(super) fn push_hulls(&mut self) -> Result<(), EstimatorError> {
        for j in 0..self.frame.vectors() {
            for k in 0..6 {
                let (side, sign) = (self.enclosure.vectors[j][k / 2], if k % 2 == 0 { 1.0 } else { -1.0 });
                let limit = if k % 2 == 0 { side.hi() } else { -side.lo() };
                let class = 2 * (6 * j + k) + 1;
                let tag = Tag { origin: Origin::Bound, class, born: self.instant, used: 0 };
                self.push_functional(Some(j), AXES[k / 2].map(|x| sign * x), &[Interval::ZERO; 3], limit, tag)?;
            }
        }
        Ok(())
    }

    /// The hull of the cells, as attitudes.
    pub(super) fn enclose_attitude(&mut self) -> Result<(), EstimatorError> {
        let cell = super::cell::merged(&self.cells)?;
        let center = cell.center.compose(&self.frame.attitude);
        let exact = cell.center.enclose().compose(&self.frame.attitude.enclose());
        let missed = super::space::slip(&exact.compose(&center.enclose().inverse()))?;
        // exp(r) exp(nu): the vector moves by less than 2 |nu|.
        let turn = super::space::turned_on(&cell.turn, &[Interval::ZERO.inflate(missed); 3])?;
        self.enclosure.center = center;
        self.enclosure.turn_rad = turn.unwrap_or_else(super::space::any_turn);
        Ok(())
    }
}
