//! What the rows say about heading, scale, arms and positions: each by linear programs, each bound proven.

use scalars::Interval;
use scalars::rounding::{add_down, add_up, div_up, mul_up, sub_down, sub_up};

use super::InvariantStrips;
use super::arc::{Arc, Cap, TURN};
use super::plane::{Region, Vector, middle, norm1, radius, unit};
use super::tags::Origin;
use crate::{EstimatorError, Evidence};

/// Most passes over the arc of one update, and the share of its width that a pass must take off for another one.
const PASSES: usize = 5;
const WORTHWHILE: f64 = 0.05;

/// Half width of an arc above which it is cut by caps, below which by its ends.
const WIDE: f64 = 1.2;

impl InvariantStrips {
    /// The arc, again while it shrinks a good deal (which it does in the first updates only), and everything else once.
    pub(super) fn contract(&mut self) -> Result<(), EstimatorError> {
        self.union.left.clear();
        if self.is_worth_cutting() {
            self.contract_by_pieces()?;
        } else {
            self.contract_whole()?;
        }
        let cut = !self.union.left.is_empty();
        self.suspects.clear();
        if !cut {
            self.contract_scale()?;
        }
        self.axis = middle(&unit(Interval::point(self.arc.middle())));
        for l in 0..self.enclosure.body.len() {
            self.suspects.clear();
            self.contract_arm(l)?;
        }
        for j in 0..self.enclosure.fixed.len() {
            self.suspects.clear();
            if !cut {
                self.contract_vector(j)?;
            }
        }
        self.enclosure.heading_rad = self.heading();
        Ok(())
    }

    /// The arc in one piece; its rows stay.
    fn contract_whole(&mut self) -> Result<(), EstimatorError> {
        self.push_derived()?;
        for pass in 1..=PASSES {
            let before = self.arc.width();
            self.contract_arc()?;
            if self.arc.width() > (1.0 - WORTHWHILE) * before || pass == PASSES {
                break;
            }
            self.drop_derived();
            self.push_derived()?;
        }
        Ok(())
    }

    /// The ends of a narrow arc, or the caps of a wide one.
    fn contract_arc(&mut self) -> Result<(), EstimatorError> {
        self.suspects.clear();
        if self.arc.is_whole() || self.half_width() > WIDE {
            return self.contract_by_caps();
        }
        // With |phi - hi| < pi: s sin(phi - hi) = <z, i e^{i hi}> <= v < 0 gives sin(phi - hi) <= v / s2.
        let end = unit(Interval::point(self.arc.hi));
        let by = self.step_inward([-end[1], end[0]])?;
        let hi = sub_up(self.arc.hi, by);
        let end = unit(Interval::point(self.arc.lo));
        let by = self.step_inward([end[1], -end[0]])?;
        let lo = add_down(self.arc.lo, by);
        if lo > hi {
            let shifted = |a: f64, b: f64| Interval::new(a, b).unwrap_or(Interval::EMPTY);
            return Err(self.disjoint(shifted(lo, f64::INFINITY), shifted(f64::NEG_INFINITY, hi)));
        }
        self.arc = Arc { lo, hi };
        Ok(())
    }

    /// Angle, rounded down, by which an end moves whose outward tangent is `d`.
    fn step_inward(&mut self, d: Region) -> Result<f64, EstimatorError> {
        let v = self.heading_support(d)?;
        Ok(self.inward(v))
    }

    /// The same for the maximum `v` along the tangent.
    pub(super) fn inward(&self, v: f64) -> f64 {
        if v >= 0.0 {
            return 0.0;
        }
        let sine = (-div_up(v, self.enclosure.scale.hi())).clamp(0.0, 1.0);
        Interval::point(sine).asin().lo().max(0.0)
    }

    /// `max <z, e^{i psi}> = v < s1` excludes the angles within `acos(v / s1)` of `psi` (`acos(v / s2)` if `v < 0`).
    fn contract_by_caps(&mut self) -> Result<(), EstimatorError> {
        self.caps.clear();
        let scale = self.enclosure.scale;
        for k in 0..self.options.caps {
            let psi = TURN * k as f64 / self.options.caps as f64;
            let v = self.heading_support(unit(Interval::point(psi)))?;
            let cosine = div_up(v, if v < 0.0 { scale.hi() } else { scale.lo() });
            if cosine < 1.0 {
                let reach = Interval::point(cosine.max(-1.0)).acos().lo();
                self.caps.push(Cap { center: psi, reach });
            }
        }
        match self.arc.without(&self.caps) {
            Some(left) => {
                self.arc = left;
                Ok(())
            }
            None => {
                let evidence = self.evidence_of_caps()?;
                Err(self.contradiction(evidence))
            }
        }
    }

    /// `s cos t = <z, e^{ic}>` with `|t| <= w`: the maximum over `cos w` bounds `s` from above, the minimum from below.
    fn contract_scale(&mut self) -> Result<(), EstimatorError> {
        let scale = self.enclosure.scale;
        if scale.lo() == scale.hi() || self.arc.is_whole() || self.half_width() > 1.5 {
            return Ok(());
        }
        let toward = unit(Interval::point(self.arc.middle()));
        let cosine = Interval::point(self.half_width()).sin_cos().1.lo();
        let most = self.heading_support(toward)?;
        let least = -self.heading_support(toward.map(|t| -t))?;
        let (lo, hi) = (scale.lo().max(least), scale.hi().min(div_up(most, cosine)));
        match Interval::new(lo, hi) {
            Ok(scale) => {
                self.enclosure.scale = scale;
                Ok(())
            }
            Err(_) => {
                let required = Interval::new(f64::NEG_INFINITY, hi).unwrap_or(Interval::EMPTY);
                Err(self.disjoint(Interval::new(lo, f64::INFINITY).unwrap_or(Interval::EMPTY), required))
            }
        }
    }

    /// The box of `A = conj(e^{ic}) xi`, and with `X = e^{-it} A`, `|t| <= w`, that of the arm.
    fn contract_arm(&mut self, l: usize) -> Result<(), EstimatorError> {
        let Some(sides) = self.turned_box(self.embedding.body(l), self.axis)? else { return Err(self.empty()) };
        self.turned[l] = sides;
        if !self.arc.is_whole() && self.half_width() <= 3.0 {
            self.enclosure.body[l] = self.meet(self.enclosure.body[l], self.arm_of(sides))?;
        }
        Ok(())
    }

    /// The box of `conj(axis) y` for the pair `y` at `column`; none if the rows contradict each other.
    pub(super) fn turned_box(&mut self, column: usize, axis: Vector) -> Result<Option<Region>, EstimatorError> {
        let across = [-axis[1], axis[0]];
        let mut sides = [Interval::EMPTY; 2];
        for (side, d) in sides.iter_mut().zip([axis, across]) {
            let hi = self.pair_bound(column, d)?;
            let lo = -self.pair_bound(column, [-d[0], -d[1]])?;
            // |axis|^2 is 1 but for four roundings.
            let slip = mul_up(lo.abs().max(hi.abs()), 8.0 * f64::EPSILON);
            let Ok(found) = Interval::new(sub_down(lo, slip), add_up(hi, slip)) else { return Ok(None) };
            *side = found;
        }
        Ok(Some(sides))
    }

    /// `X = e^{-it} A`, `|t| <= w`, for a box of `A = conj(e^{ic}) xi`.
    pub(super) fn arm_of(&self, sides: Region) -> Region {
        // e^{-ic} axis is 1 but for rounding.
        let slip = mul_up(add_up(sides[0].mag(), sides[1].mag()), 8.0 * f64::EPSILON);
        let a = sides.map(|side| side.inflate(slip));
        let half = self.half_width();
        let [cos, sin] = unit(Interval::new(-half, half).unwrap_or(Interval::ENTIRE));
        [cos * a[0] + sin * a[1], cos * a[1] - sin * a[0]]
    }

    /// The hull of vector `j` of the world.
    fn contract_vector(&mut self, j: usize) -> Result<(), EstimatorError> {
        let Some(seen) = self.place_box(j)? else { return Err(self.empty()) };
        self.enclosure.fixed[j] = self.meet(self.enclosure.fixed[j], seen)?;
        Ok(())
    }

    /// The box of vector `j` of the world; none if the rows contradict each other. Levers along axes are exact.
    pub(super) fn place_box(&mut self, j: usize) -> Result<Option<Region>, EstimatorError> {
        let mut seen = [Interval::EMPTY; 2];
        for (side, d) in seen.iter_mut().zip([[1.0, 0.0], [0.0, 1.0]]) {
            self.aim(j, d);
            let hi = self.bound()?;
            self.aim(j, [-d[0], -d[1]]);
            let lo = -self.bound()?;
            let Ok(found) = Interval::new(lo, hi) else { return Ok(None) };
            *side = found;
        }
        Ok(Some(seen))
    }

    /// The intersection, or the contradiction.
    pub(super) fn meet(&self, known: Region, seen: Region) -> Result<Region, EstimatorError> {
        let mut common = [Interval::EMPTY; 2];
        for k in 0..2 {
            common[k] = known[k].intersection(seen[k]);
            if common[k].is_empty() {
                return Err(self.disjoint(known[k], seen[k]));
            }
        }
        Ok(common)
    }

    /// Upper bound of `<d, z>` for a direction known to rounding.
    fn heading_support(&mut self, d: Region) -> Result<f64, EstimatorError> {
        let v = self.heading_bound(d)?;
        if v == f64::NEG_INFINITY { Err(self.empty()) } else { Ok(v) }
    }

    /// The same; `-inf` if the rows contradict each other.
    pub(super) fn heading_bound(&mut self, d: Region) -> Result<f64, EstimatorError> {
        let v = self.pair_bound(0, middle(&d))?;
        let lost = mul_up(radius(&d), self.enclosure.scale.hi());
        Ok(if self.emptied { v } else { add_up(v, lost) })
    }

    /// Upper bound of `<d, .>` of the pair at `column`; `-inf` if the rows contradict each other.
    fn pair_bound(&mut self, column: usize, d: Vector) -> Result<f64, EstimatorError> {
        self.normal.fill(0.0);
        self.normal[column..column + 2].copy_from_slice(&d);
        self.bound()
    }

    /// Upper bound of `<d, x_j>`. The lever `conj(S) d` is exact for units of the axes; elsewhere its rounding is added.
    pub(super) fn place_support(&mut self, j: usize, d: Vector) -> Result<f64, EstimatorError> {
        let s = self.path[j];
        let unit = |along: f64, across: f64| along.abs() == 1.0 && across == 0.0;
        let lost = if unit(d[0], d[1]) || unit(d[1], d[0]) {
            0.0
        } else {
            mul_up(8.0 * f64::EPSILON, mul_up(norm1(s), mul_up(norm1(d), self.enclosure.scale.hi())))
        };
        self.aim(j, d);
        let value = self.support()?;
        Ok(if lost == 0.0 { value } else { add_up(value, lost) })
    }

    /// Upper bound of `<self.normal, .>` over the rows; marks those that carry it.
    pub(super) fn support(&mut self) -> Result<f64, EstimatorError> {
        let value = self.bound()?;
        if value == f64::NEG_INFINITY { Err(self.empty()) } else { Ok(value) }
    }

    /// The same; `-inf` if the rows are proven to contradict each other.
    pub(super) fn bound(&mut self) -> Result<f64, EstimatorError> {
        self.programs += 1;
        let value = self.rows.support(&self.normal)?;
        self.emptied = value == f64::NEG_INFINITY;
        for &(i, _) in self.rows.active() {
            self.tags[i].used = self.instant;
            self.suspects.push(i);
        }
        Ok(value)
    }

    /// The error of the last bound: a proof that the rows contradict each other, or two bounds that cross.
    pub(super) fn empty(&self) -> EstimatorError {
        match self.rows.contradiction().filter(|_| self.emptied) {
            Some(proof) => {
                let culprits = proof.rows().iter().map(|&i| self.culprit(i)).collect();
                let evidence = Evidence::HalfSpaces { proof: Box::new(proof.clone()) };
                if proof.rows().iter().any(|&i| self.tags[i].origin == Origin::Derived) {
                    self.inconsistent_with_arc(culprits, evidence)
                } else {
                    self.inconsistent(culprits, evidence)
                }
            }
            None => self.contradiction(self.unproven()),
        }
    }
}
