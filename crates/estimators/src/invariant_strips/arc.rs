//! Arcs of angles on the circle, and what removing caps leaves of them.

use scalars::Interval;
use scalars::rounding::{add_down, add_up, sub_down, sub_up};

/// The nearest number below `2 pi`.
pub(super) const TURN: f64 = 2.0 * core::f64::consts::PI;

/// The angles `lo..=hi` modulo `2 pi`; at least [`TURN`] wide, it is the whole circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Arc {
    pub(super) lo: f64,
    pub(super) hi: f64,
}

/// A proven gap: no angle within `reach` of `center`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cap {
    pub(super) center: f64,
    pub(super) reach: f64,
}

impl Arc {
    /// The arc of an interval of angles.
    pub(super) fn new(angles: Interval) -> Self {
        if angles.width() >= TURN {
            return Self::whole();
        }
        Self { lo: angles.lo(), hi: angles.hi() }
    }

    /// The whole circle.
    pub(super) fn whole() -> Self {
        Self { lo: -Interval::PI.hi(), hi: Interval::PI.hi() }
    }

    pub(super) fn is_whole(&self) -> bool {
        self.hi - self.lo >= TURN
    }

    /// As an interval of angles.
    pub(super) fn angles(&self) -> Interval {
        Interval::new(self.lo, self.hi).unwrap_or(Interval::EMPTY)
    }

    pub(super) fn width(&self) -> f64 {
        self.hi - self.lo
    }

    pub(super) fn middle(&self) -> f64 {
        0.5 * (self.lo + self.hi)
    }

    /// The arc with both ends moved outward.
    pub(super) fn widened(&self, by: f64) -> Self {
        let wide = Self { lo: sub_down(self.lo, by), hi: add_up(self.hi, by) };
        if wide.is_whole() || !wide.width().is_finite() { Self::whole() } else { wide }
    }

    /// The angles in both, in the numbers of `other`, if that is one arc for certain; `None` otherwise.
    pub(super) fn common(&self, other: &Self) -> Option<Self> {
        if self.is_whole() {
            return None;
        }
        if other.is_whole() {
            return Some(*self);
        }
        let turns = ((other.middle() - self.middle()) / TURN).round();
        let mut found = None;
        for k in [-1.0, 0.0, 1.0] {
            // The copy of this arc, rounded outward.
            let copy = self.angles() + Interval::PI.scale(2.0 * (turns + k));
            let (lo, hi) = (copy.lo().max(other.lo), copy.hi().min(other.hi));
            if lo <= hi && found.replace(Self { lo, hi }).is_some() {
                return None;
            }
        }
        found
    }

    /// The hull of what the caps leave; `None` if they leave nothing. Of the whole circle the largest gap is taken out.
    ///
    /// The caps are in the order of their centers, which lie less than a turn apart. Ends move to the ends of caps rounded inward, so
    /// nothing is removed that no cap proves impossible.
    pub(super) fn without(&self, caps: &[Cap]) -> Option<Self> {
        if self.is_whole() { without_largest_gap(caps).map_or(Some(*self), |left| left) } else { self.trimmed(caps) }
    }

    /// Moves each end out of the caps that cover it, until none does.
    fn trimmed(&self, caps: &[Cap]) -> Option<Self> {
        let (mut lo, mut hi) = (self.lo, self.hi);
        // Each round ends, or passes a cap for good.
        for _ in 0..=2 * caps.len() {
            let before = (lo, hi);
            for cap in caps {
                for turns in [-1.0, 0.0, 1.0] {
                    // The copy of the cap nearest the end; its center is off by the rounding of a turn, which `inner` takes off.
                    let shift = (((lo - cap.center) / TURN).round() + turns) * TURN;
                    let (from, to) = inner(cap, shift);
                    if from < lo && lo < to {
                        lo = to;
                    }
                    let shift = (((hi - cap.center) / TURN).round() + turns) * TURN;
                    let (from, to) = inner(cap, shift);
                    if from < hi && hi < to {
                        hi = from;
                    }
                }
                if lo > hi {
                    return None;
                }
            }
            if before == (lo, hi) {
                break;
            }
        }
        Some(Self { lo, hi })
    }
}

/// The ends of a cap moved by `shift`, a multiple of `2 pi` but for rounding, rounded inward.
fn inner(cap: &Cap, shift: f64) -> (f64, f64) {
    let center = cap.center + shift;
    let slip = 4.0 * f64::EPSILON * (center.abs() + shift.abs());
    let reach = sub_down(cap.reach, slip);
    if reach <= 0.0 {
        return (f64::INFINITY, f64::NEG_INFINITY);
    }
    (add_up(center, -reach), sub_down(center, -reach).min(add_down(center, reach)))
}

/// The circle without the largest gap that overlapping caps make: `None` without caps, `Some(None)` if they cover all of it.
fn without_largest_gap(caps: &[Cap]) -> Option<Option<Arc>> {
    let mut best: Option<(f64, f64)> = None;
    for (start, cap) in caps.iter().enumerate() {
        let (from, mut to) = inner(cap, 0.0);
        if from >= to {
            continue;
        }
        // Caps reach less than a half turn to a side: those that follow, once around, and any that overlap the gap so far.
        let mut from = from;
        let mut turn = 0.0;
        for k in 1..2 * caps.len() {
            let index = (start + k) % caps.len();
            if index == 0 {
                turn += TURN;
            }
            let (next_from, next_to) = inner(&caps[index], turn);
            if next_from < to && next_to > from {
                from = from.min(next_from);
                to = to.max(next_to);
            }
            if sub_up(to, from) >= TURN + 1e-9 {
                return Some(None);
            }
        }
        if best.is_none_or(|(a, b)| to - from > b - a) {
            best = Some((from, to));
        }
    }
    // What is left runs from the end of the gap to its beginning, a turn on.
    best.map(|(from, to)| {
        let hi = (Interval::point(from) + Interval::PI.scale(2.0)).hi();
        let left = Arc { lo: to, hi };
        if left.lo > left.hi { None } else { Some(left) }
    })
}

/// The shortest arc around pieces that follow each other for at most a turn, overlapping or not: what is left without the largest gap.
pub(super) fn hull_of_pieces(pieces: &[Arc]) -> Option<Arc> {
    let (first, last) = (pieces.first()?, pieces.last()?);
    let mut hull = Arc { lo: first.lo, hi: last.hi };
    let mut widest = sub_down(add_down(first.lo, TURN), last.hi);
    for pair in pieces.windows(2) {
        let gap = sub_down(pair[1].lo, pair[0].hi);
        if gap > widest {
            widest = gap;
            // From the second of the pair on, and around to the first.
            let turn_on = (Interval::point(pair[0].hi) + Interval::PI.scale(2.0)).hi();
            hull = Arc { lo: pair[1].lo.min(add_down(first.lo, TURN)), hi: turn_on.max(last.hi) };
        }
    }
    Some(if widest <= 0.0 || hull.is_whole() { Arc::whole() } else { hull })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn caps_take_out_the_largest_gap() {
        let caps = [(-2.0, 0.3), (-1.5, 0.4), (0.0, 0.2), (2.9, 0.5)].map(|(center, reach)| Cap { center, reach });
        let left = Arc::whole().without(&caps).unwrap();
        // The gaps are [-2.3, -1.1] and [2.4, 3.4], across the cut.
        assert!((left.lo + 1.1).abs() < 1e-14 && (left.hi - (TURN - 2.3)).abs() < 1e-14, "{left:?}");
        assert!(left.lo <= -1.1 && left.hi >= TURN - 2.3);
        assert_eq!(Arc::whole().without(&[]), Some(Arc::whole()));
        let cover: Vec<_> = (0..8).map(|k| Cap { center: f64::from(k) * 0.785, reach: 0.5 }).collect();
        assert_eq!(Arc::whole().without(&cover), None);
    }

    #[test]
    fn caps_trim_the_ends_of_an_arc_only() {
        let arc = Arc { lo: 2.5, hi: 4.5 };
        let caps = [(-2.0, 0.3), (2.4, 0.3), (3.4, 0.1)].map(|(center, reach)| Cap { center, reach });
        // -2 is 4.28 on the other side of the cut.
        let left = arc.without(&caps).unwrap();
        assert!((left.lo - 2.7).abs() < 1e-14 && (left.hi - (TURN - 2.3)).abs() < 1e-14, "{left:?}");
        assert_eq!(Arc { lo: 0.1, hi: 0.2 }.without(&[Cap { center: 0.0, reach: 0.5 }]), None);
    }

    #[test]
    fn common_angles_are_one_arc_or_nothing_is_said() {
        let arc = |lo: f64, hi: f64| Arc { lo, hi };
        let close = |a: Arc, lo: f64, hi: f64| (a.lo - lo).abs() < 1e-14 && (a.hi - hi).abs() < 1e-14;
        assert!(close(arc(0.0, 2.0).common(&arc(1.0, 3.0)).unwrap(), 1.0, 2.0));
        // A turn apart.
        assert!(close(arc(0.0, 2.0).common(&arc(1.0 + TURN, 3.0 + TURN)).unwrap(), 1.0 + TURN, 2.0 + TURN));
        // Both ends of one are in the other: two arcs.
        assert_eq!(arc(-2.5, 2.5).common(&arc(2.0, 4.5)), None);
        assert_eq!(arc(0.0, 1.0).common(&arc(2.0, 3.0)), None);
        assert_eq!(Arc::whole().common(&arc(2.0, 3.0)), None);
        assert_eq!(arc(2.0, 3.0).common(&Arc::whole()), Some(arc(2.0, 3.0)));
    }

    #[test]
    fn pieces_are_joined_around_the_largest_gap() {
        let pieces = |ends: &[(f64, f64)]| ends.iter().map(|&(lo, hi)| Arc { lo, hi }).collect::<Vec<_>>();
        assert_eq!(hull_of_pieces(&[]), None);
        let inner = pieces(&[(-1.0, -0.8), (-0.8000001, -0.5), (0.3, 0.4)]);
        assert_eq!(hull_of_pieces(&inner), Some(Arc { lo: -1.0, hi: 0.4 }));
        // Across the cut: the gap between -2.5 and 2.8 is the largest.
        let left = hull_of_pieces(&pieces(&[(-3.15, -2.9), (-2.9, -2.5), (2.8, 3.0), (3.0, 3.15)])).unwrap();
        assert!(left.lo == 2.8 && left.hi >= TURN - 2.5 && left.hi < TURN - 2.5 + 1e-14, "{left:?}");
        let around = pieces(&[(-3.2, -1.0), (-1.0, 1.0), (0.9, 3.2)]);
        assert!(hull_of_pieces(&around).unwrap().is_whole());
    }
}
