//! What the rows say about heading, scale, arms and positions: each by linear programs, each bound proven.

use scalars::Interval;
use scalars::rounding::{add_up, div_up, mul_up, sub_down, sub_up};

use super::InvariantStrips;
use super::arc::{Arc, Cap, TURN};
use super::plane::{Region, Vector, middle, norm1, radius, unit};
use crate::{Culprit, EstimatorError, Evidence};

/// Most passes over the arc of one update, and the share of its width that a pass must take off for another one.
const PASSES: usize = 5;
const WORTHWHILE: f64 = 0.05;

/// Half width of an arc above which it is cut by caps, below which by its ends.
const WIDE: f64 = 1.2;

impl InvariantStrips {
    /// The arc, again while it shrinks a good deal (which it does in the first updates only), and everything else once.
    pub(super) fn contract(&mut self) -> Result<(), EstimatorError> {
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
        self.contract_scale()?;
        self.axis = middle(&unit(Interval::point(self.arc.middle())));
        for l in 0..self.enclosure.body.len() {
            self.contract_arm(l)?;
        }
        for j in 0..self.enclosure.fixed.len() {
            self.contract_vector(j)?;
        }
        self.enclosure.heading_rad = self.heading();
        Ok(())
    }

    /// The ends of a narrow arc, or the caps of a wide one.
    fn contract_arc(&mut self) -> Result<(), EstimatorError> {
        if self.arc.is_whole() || self.half_width() > WIDE {
            return self.contract_by_caps();
        }
        // With |phi - hi| < pi: s sin(phi - hi) = <z, i e^{i hi}> <= v < 0 gives sin(phi - hi) <= v / s2.
        let end = unit(Interval::point(self.arc.hi));
        let by = self.step_inward([-end[1], end[0]])?;
        let hi = sub_up(self.arc.hi, by);
        let end = unit(Interval::point(self.arc.lo));
        let by = self.step_inward([end[1], -end[0]])?;
        let lo = sub_down(self.arc.lo, -by);
        // lo + by, rounded down.
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
        if v >= 0.0 {
            return Ok(0.0);
        }
        let sine = (-div_up(v, self.enclosure.scale.hi())).clamp(0.0, 1.0);
        Ok(Interval::point(sine).asin().lo().max(0.0))
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
                Err(self.contradiction(Evidence::Propagation { hull: self.enclosure.fixed.as_flattened().to_vec() }))
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
        let axis = self.axis;
        let column = self.embedding.body(l);
        let across = [-axis[1], axis[0]];
        let mut sides = [Interval::EMPTY; 2];
        for (side, d) in sides.iter_mut().zip([axis, across]) {
            let hi = self.pair_support(column, d)?;
            let lo = -self.pair_support(column, [-d[0], -d[1]])?;
            // |axis|^2 is 1 but for four roundings.
            let slip = mul_up(lo.abs().max(hi.abs()), 8.0 * f64::EPSILON);
            *side = Interval::new(sub_down(lo, slip), add_up(hi, slip)).unwrap_or(Interval::EMPTY);
            if side.is_empty() {
                let one = |bound: f64| Interval::point(bound);
                return Err(self.disjoint(one(lo), one(hi)));
            }
        }
        self.turned[l] = sides;
        if self.arc.is_whole() || self.half_width() > 3.0 {
            return Ok(());
        }
        // e^{-ic} axis is 1 but for rounding.
        let slip = mul_up(add_up(sides[0].mag(), sides[1].mag()), 8.0 * f64::EPSILON);
        let a = sides.map(|side| side.inflate(slip));
        let half = self.half_width();
        let [cos, sin] = unit(Interval::new(-half, half).unwrap_or(Interval::ENTIRE));
        let seen = [cos * a[0] + sin * a[1], cos * a[1] - sin * a[0]];
        self.enclosure.body[l] = self.meet(self.enclosure.body[l], seen)?;
        Ok(())
    }

    /// The hull of vector `j` of the world.
    fn contract_vector(&mut self, j: usize) -> Result<(), EstimatorError> {
        let mut seen = [Interval::EMPTY; 2];
        for (k, d) in [[1.0, 0.0], [0.0, 1.0]].into_iter().enumerate() {
            let hi = self.place_support(j, d)?;
            let lo = -self.place_support(j, [-d[0], -d[1]])?;
            seen[k] = match Interval::new(lo, hi) {
                Ok(side) => side,
                Err(_) => return Err(self.disjoint(Interval::point(lo), Interval::point(hi))),
            };
        }
        self.enclosure.fixed[j] = self.meet(self.enclosure.fixed[j], seen)?;
        Ok(())
    }

    /// The intersection, or the contradiction.
    fn meet(&mut self, known: Region, seen: Region) -> Result<Region, EstimatorError> {
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
        let v = self.pair_support(0, middle(&d))?;
        Ok(add_up(v, mul_up(radius(&d), self.enclosure.scale.hi())))
    }

    /// Upper bound of `<d, .>` of the pair at `column`.
    pub(super) fn pair_support(&mut self, column: usize, d: Vector) -> Result<f64, EstimatorError> {
        self.normal.fill(0.0);
        self.normal[column..column + 2].copy_from_slice(&d);
        self.support()
    }

    /// Upper bound of `<d, x_j>`. The lever `conj(S) d` is exact along an axis; elsewhere its rounding is added.
    pub(super) fn place_support(&mut self, j: usize, d: Vector) -> Result<f64, EstimatorError> {
        let s = self.path[j];
        let lost = if d[0] == 0.0 || d[1] == 0.0 {
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
        self.programs += 1;
        let value = self.rows.support(&self.normal)?;
        if value == f64::NEG_INFINITY {
            let proof = self.rows.contradiction().cloned();
            let culprits: Vec<Culprit> = match &proof {
                Some(proof) => proof.rows().iter().map(|&i| self.culprit(i)).collect(),
                None => Vec::new(),
            };
            let evidence = match proof {
                Some(proof) => Evidence::HalfSpaces { proof: Box::new(proof) },
                None => Evidence::Propagation { hull: self.enclosure.fixed.as_flattened().to_vec() },
            };
            return Err(self.inconsistent(culprits, evidence));
        }
        for &(i, _) in self.rows.active() {
            self.tags[i].used = self.instant;
        }
        Ok(value)
    }
}
