//! Rows that follow from the arc, the scale and the arms of the moment: what is not linear in the embedding, relaxed to its convex hull.

use scalars::Interval;
use scalars::rounding::{add_up, mul_up, sub_up};

use super::InvariantStrips;
use super::plane::{Region, Vector, middle, point, radius, unit};
use super::sweep::Sweep;
use super::tags::{Origin, Tag};
use crate::EstimatorError;

/// Tangents of the whole circle.
const AROUND: u32 = 16;

/// Directions in which a turned arm is bounded.
const ARM_DIRECTIONS: u32 = 8;

impl InvariantStrips {
    /// Appends the rows
    ///
    /// - `<z, e^{i psi}> <= s2` at some angles of the arc, all around if it is the whole circle,
    /// - `<z, e^{ic}> >= s1 cos w` (`s2 cos w` if that is negative) for an arc of middle `c` and half width `w`,
    /// - `<z, i e^{i hi}> <= 0 <= <z, i e^{i lo}>` for an arc below a half turn, if the scale is unknown,
    /// - `<d, xi> <= max { <d, e^{i phi} X> }` over arc and box of the arm.
    pub(super) fn push_derived(&mut self) -> Result<(), EstimatorError> {
        let (arc, scale) = (self.arc, self.enclosure.scale);
        let width = arc.width();
        let (start, parts) = if arc.is_whole() {
            (0.0, AROUND)
        } else if width < 0.4 {
            (arc.lo, 2)
        } else if width < 2.0 {
            (arc.lo, 4)
        } else {
            (arc.lo, 10)
        };
        let count = if arc.is_whole() { parts } else { parts + 1 };
        for k in 0..count {
            let angle = start + width * f64::from(k) / f64::from(parts);
            self.push_heading_row(unit(Interval::point(angle)), scale.hi())?;
        }
        if !arc.is_whole() {
            let (toward, half) = (unit(Interval::point(arc.middle())), self.half_width());
            // cos w falls with w up to pi, where it is -1; wider arcs say nothing here.
            let least = if half < 3.1 { Interval::point(half).sin_cos().1.lo() } else { -1.0 };
            let farness = if least >= 0.0 { scale.lo() } else { scale.hi() };
            self.push_heading_row(toward.map(|t| -t), mul_up(farness, -least))?;
            if width < 3.1 && scale != Interval::ONE {
                let (first, last) = (unit(Interval::point(arc.lo)), unit(Interval::point(arc.hi)));
                self.push_heading_row([-last[1], last[0]], 0.0)?;
                self.push_heading_row([first[1], -first[0]], 0.0)?;
            }
        }
        for l in 0..self.enclosure.body.len() {
            let [x, y] = self.enclosure.body[l];
            let corners = [[x.lo(), y.lo()], [x.hi(), y.lo()], [x.lo(), y.hi()], [x.hi(), y.hi()]];
            let sweep = Sweep::new(arc.angles(), &corners);
            for k in 0..ARM_DIRECTIONS {
                let angle = arc.middle() + core::f64::consts::TAU * f64::from(k) / f64::from(ARM_DIRECTIONS);
                let d = middle(&unit(Interval::point(angle)));
                self.normal.fill(0.0);
                let column = self.embedding.body(l);
                self.normal[column..column + 2].copy_from_slice(&d);
                self.push_row(sweep.sup(d), self.derived_tag())?;
            }
        }
        Ok(())
    }

    /// Appends `<d, z> <= limit` for a direction known to rounding.
    pub(super) fn push_heading_row(&mut self, d: Region, limit: f64) -> Result<(), EstimatorError> {
        self.normal.fill(0.0);
        self.normal[..2].copy_from_slice(&middle(&d));
        self.push_row(add_up(limit, mul_up(radius(&d), self.enclosure.scale.hi())), self.derived_tag())
    }

    fn derived_tag(&self) -> Tag {
        Tag { origin: Origin::Derived, class: 0, born: self.instant, used: 0 }
    }

    /// Drops the rows of [`push_derived`](Self::push_derived).
    pub(super) fn drop_derived(&mut self) {
        let tags = &mut self.tags;
        self.rows.retain(|i| tags[i].origin != Origin::Derived);
        tags.retain(|tag| tag.origin != Origin::Derived);
    }

    /// Upper bound of the distance of the ends of the arc from its middle.
    pub(super) fn half_width(&self) -> f64 {
        let c = self.arc.middle();
        sub_up(self.arc.hi, c).max(sub_up(c, self.arc.lo))
    }

    /// A point in the middle of the set: `(z, x_j, xi_l)` by pairs, into `self.center`; rounded.
    pub(super) fn find_center(&mut self) {
        let scale = self.enclosure.scale.mid();
        let toward = middle(&unit(Interval::point(self.arc.middle())));
        let depth = if self.arc.is_whole() { 0.0 } else { scale * (0.5 * self.half_width()).cos() };
        let z: Vector = [depth * toward[0], depth * toward[1]];
        self.center.clear();
        self.center.extend(z);
        for (hull, path) in self.enclosure.fixed.iter().zip(&self.path) {
            let reached = super::plane::product(&point(*path), &point(z));
            self.center.extend([0, 1].map(|k| hull[k].mid() - reached[k].mid()));
        }
        for sides in &self.turned {
            let xi = super::plane::product(&point(self.axis), &point(middle(sides)));
            self.center.extend(middle(&xi));
        }
    }
}
