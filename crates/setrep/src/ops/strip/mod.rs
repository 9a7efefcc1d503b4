//! Intersection with a strip `{ x : a'x in [d] }`, enclosed in a zonotope.
//!
//! With `[d] = m +- sigma`, every vector `l` of weights gives an enclosure: `x = (I - l a') x + l (a'x)`, so the points `c + G xi + e` of
//! the set that lie in the strip lie in
//!
//! ```text
//! < c + l (m - a'c), [(I - l a') G, sigma l], |I - l a'| r >.
//! ```
//!
//! A rule chooses `l`, in plain floating point; whatever it chooses, the result holds. A file for the family, one for the rules, one for
//! the volumes of the candidates.
//!
//! **Source:** Bravo, Alamo, Camacho 2006, *Bounded error identification of systems with time-varying parameters*; Alamo, Bravo, Camacho
//! 2005, *Guaranteed state estimation by zonotopes*; paper 001, (34)-(41).

mod member;
mod rules;
mod volumes;

use scalars::Interval;

use super::materialize::is_model_size;
use crate::{Part, SetError, Workspace, Zonotope};
use rules::Choice;

/// How the weights of a strip are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum StripRule {
    /// The least `det(G G')` among the set itself and the candidates `l = g_j / (a'g_j)`, which replace the generator `g_j` by one along
    /// which the strip is crossed: `ng` stays. By the formula of Cauchy and Binet candidate `j` has `det(G_j G_j') / det(G G')` equal to
    /// `sigma^2 g_j'(G G')^-1 g_j / (a'g_j)^2`, so one factorisation serves all; flat sets are judged within their span.
    #[default]
    Determinant,
    /// The least volume among the set itself and the same candidates; all volumes together cost about as much as one
    /// ([`approx_candidate_volumes`](Zonotope::approx_candidate_volumes)). Flat sets, and sets with more than
    /// [`MINOR_LIMIT`](crate::MINOR_LIMIT) minors or of more than 14 dimensions, are judged by `Determinant`.
    Volume,
    /// The least F-radius among all weights, `l = P a / (a'P a + sigma^2)` with `P = G G' + diag(r)^2`: `ng` grows by 1.
    Segments,
}

/// What a strip did to a set.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub enum StripCut {
    /// No point of the set lies in the strip, for `a'x` lies in `reach`. The set is as it was.
    ProvenEmpty {
        /// Where the set reaches along `a`; disjoint from `[d]`.
        reach: Interval,
    },
    /// The set is as it was: the strip holds all of it, or no candidate was smaller.
    Unchanged,
    /// The set was replaced by an enclosure of the intersection.
    Cut,
}

impl Zonotope {
    /// Where the set reaches along `a`, `[-h(-a), h(a)]` with the support function `h`.
    ///
    /// **Guarantee:** contains `a'x` for every `x` in the set; wider by rounding only.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in the direction.
    ///
    /// ```
    /// # use setrep::{Workspace, Zonotope};
    /// let reach = Zonotope::from_box(&[1.0, 0.0], &[1.0, 0.5])?.reach(&[1.0, 2.0], &mut Workspace::new())?;
    /// assert!(reach.contains(-1.0) && reach.contains(3.0) && reach.width() < 4.0 + 1e-14);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn reach(&self, direction: &[f64], workspace: &mut Workspace) -> Result<Interval, SetError> {
        let high = self.support(direction)?;
        let opposite = &mut workspace.objective;
        opposite.clear();
        opposite.extend(direction.iter().map(|a| -a));
        let low = -self.support(opposite)?;
        // The two bounds enclose the same nonempty range; NaN beside an overflow bounds nothing.
        Ok(Interval::new(low, high).unwrap_or(Interval::ENTIRE))
    }

    /// Encloses the intersection with the strip `{ x : a'x in [d] }` in a zonotope, in place. Shape `a: n`; `[d]` may be unbounded on a
    /// side or both: it is clipped to where the set [reaches](Self::reach) first.
    ///
    /// Components of `r` of [model size](Self::materialize_model_size) with `a_k != 0` take part as generators. Allocates nothing within
    /// the capacity of set and workspace.
    ///
    /// **Guarantee:** superset of the exact intersection, whatever the rule chooses, rounding included; it may reach beyond the set and the
    /// strip. Emptiness is proven.
    /// **Source:** Bravo, Alamo, Camacho 2006; paper 001, (34)-(36), (40) with the clipping of the first.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in the direction, [`SetError::EmptyInterval`], [`SetError::Overflow`]; the set is
    /// then unchanged.
    ///
    /// ```
    /// # use scalars::Interval;
    /// # use setrep::{StripCut, StripRule, Workspace, Zonotope};
    /// let mut workspace = Workspace::new();
    /// let mut set = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// let cut = set.intersect_strip(&[1.0, 0.0], Interval::point(1.0).inflate(0.5), StripRule::Determinant, &mut workspace)?;
    /// assert_eq!(cut, StripCut::Cut);
    /// // The part of the square with x_1 in [1/2, 3/2] is the box [1/2, 1] x [-1, 1].
    /// assert!(set.interval_hull()[0].lo() > 0.5 - 1e-14 && set.interval_hull()[0].hi() < 1.0 + 1e-14);
    /// let cut = set.intersect_strip(&[1.0, 1.0], Interval::point(9.0), StripRule::Determinant, &mut workspace)?;
    /// assert!(matches!(cut, StripCut::ProvenEmpty { reach } if reach.hi() < 9.0));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn intersect_strip(
        &mut self,
        direction: &[f64],
        range: Interval,
        rule: StripRule,
        workspace: &mut Workspace,
    ) -> Result<StripCut, SetError> {
        if range.is_empty() {
            return Err(SetError::EmptyInterval { part: Part::Range, row: 0 });
        }
        let reach = self.reach(direction, workspace)?;
        let within = range.intersection(reach);
        if within.is_empty() {
            return Ok(StripCut::ProvenEmpty { reach });
        }
        if reach.subset_of(&range) || !within.is_bounded() {
            return Ok(StripCut::Unchanged);
        }
        self.cut(direction, within, rule, workspace)
    }

    /// [`intersect_strip`](Self::intersect_strip) without the clipping and without the proof of emptiness, as paper 001 has it: the strip
    /// counts with its whole width. Larger sets, but a strip that misses the set pulls it over instead of refuting it.
    ///
    /// **Guarantee:** superset of the exact intersection, which may be empty. The answer is `Unchanged` or `Cut`.
    /// **Source:** paper 001, (34)-(41).
    ///
    /// # Errors
    /// As [`intersect_strip`](Self::intersect_strip); [`SetError::UnboundedInterval`] unless `[d]` is bounded.
    pub fn intersect_whole_strip(
        &mut self,
        direction: &[f64],
        range: Interval,
        rule: StripRule,
        workspace: &mut Workspace,
    ) -> Result<StripCut, SetError> {
        self.check_strip(direction, range)?;
        self.cut(direction, range, rule, workspace)
    }

    /// The member of the family with the weights `l: n`: `< c + l (m - a'c), [(I - l a') G, sigma l], |I - l a'| r >` for the bounded
    /// strip `a'x in m +- sigma`, in place. One generator more.
    ///
    /// **Guarantee:** superset of the exact intersection for every `l`, rounding included.
    /// **Source:** Alamo, Bravo, Camacho 2005; paper 001, (37)-(39).
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in direction or weights, [`SetError::EmptyInterval`],
    /// [`SetError::UnboundedInterval`], [`SetError::Overflow`]; the set is then unchanged.
    ///
    /// ```
    /// # use scalars::Interval;
    /// # use setrep::{Workspace, Zonotope};
    /// let mut set = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// set.intersect_strip_by(&[1.0, 0.0], Interval::point(0.5).inflate(0.25), &[0.5, 0.0], &mut Workspace::new())?;
    /// assert!((set.center()[0] - 0.25).abs() < 1e-15 && (set.interval_hull()[0].rad() - 0.625).abs() < 1e-14);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn intersect_strip_by(
        &mut self,
        direction: &[f64],
        range: Interval,
        weights: &[f64],
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        self.check_strip(direction, range)?;
        SetError::check_size(Part::Factor, self.dim(), weights.len())?;
        SetError::check_finite(Part::Factor, weights.len(), weights)?;
        workspace.scales.clear();
        workspace.scales.extend_from_slice(weights);
        let columns = self.materialize_along(direction);
        let result = self.replace_by_member(direction, range, None, workspace);
        if result.is_err() {
            self.dematerialize(columns);
        }
        result
    }

    /// `Ok` if this is a bounded strip of the set's space.
    fn check_strip(&self, direction: &[f64], range: Interval) -> Result<(), SetError> {
        SetError::check_size(Part::Direction, self.dim(), direction.len())?;
        SetError::check_finite(Part::Direction, direction.len(), direction)?;
        if range.is_empty() {
            return Err(SetError::EmptyInterval { part: Part::Range, row: 0 });
        }
        if range.is_bounded() { Ok(()) } else { Err(SetError::UnboundedInterval { part: Part::Range, row: 0, col: 0 }) }
    }

    /// Replaces the set by what the rule says for a bounded strip.
    fn cut(
        &mut self,
        direction: &[f64],
        range: Interval,
        rule: StripRule,
        workspace: &mut Workspace,
    ) -> Result<StripCut, SetError> {
        let columns = self.materialize_along(direction);
        let choice = match rule {
            StripRule::Determinant => self.least_determinant(direction, range.rad(), workspace),
            StripRule::Volume => self.least_volume(direction, range.rad(), workspace),
            StripRule::Segments => self.least_segments(direction, range.rad(), workspace),
        };
        let result = match choice {
            Choice::Unchanged => Ok(StripCut::Unchanged),
            Choice::Weights { replaced } => {
                self.replace_by_member(direction, range, replaced, workspace).map(|()| StripCut::Cut)
            }
        };
        if result != Ok(StripCut::Cut) {
            self.dematerialize(columns);
        }
        result
    }

    /// Turns the components of the remainder of model size that `direction` sees into generators; returns the number of columns before.
    fn materialize_along(&mut self, direction: &[f64]) -> usize {
        let columns = self.num_generators();
        for (k, _) in direction.iter().enumerate().filter(|(_, a)| **a != 0.0) {
            let r = self.remainder[k];
            if r > 0.0 {
                let extent = (0..columns).map(|j| self.generators.col(j)[k].abs()).sum();
                if is_model_size(r, extent, self.center[k]) {
                    self.generators.push_axis(k, r);
                    self.remainder[k] = 0.0;
                }
            }
        }
        columns
    }

    /// Turns the generators from `columns` on, each along an axis, back into the remainder.
    fn dematerialize(&mut self, columns: usize) {
        for j in columns..self.num_generators() {
            for (r, g) in self.remainder.iter_mut().zip(self.generators.col(j)) {
                *r += g;
            }
        }
        self.generators.truncate_cols(columns);
    }
}
