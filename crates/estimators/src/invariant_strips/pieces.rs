//! A wide arc cut into pieces: what holds on every piece that is not proven impossible.
//!
//! The true heading lies in one of the pieces. On a narrow piece `s1 <= |z| <= s2` and the box of the arms are nearly linear in the embedding, on a
//! wide arc they say next to nothing. So an upper bound of any functional over the set is the largest of its bounds over the
//! pieces, and a piece whose rows contradict each other is impossible.

use scalars::Interval;
use scalars::rounding::{add_up, div_up, sub_down, sub_up};

use super::InvariantStrips;
use super::arc::{Arc, hull_of_pieces};
use super::plane::{Region, middle, unit};
use crate::{Case, EstimatorError, Evidence};

/// Widest arc that is not cut, and the widest piece.
const UNCUT: f64 = 0.15;
const PIECE: f64 = 0.03;

/// Most pieces of a round.
const MOST: f64 = 16.0;

/// Most rounds of one update, and the share of the width that a round must take off for another one.
const ROUNDS: usize = 3;
const WORTHWHILE: f64 = 0.05;

/// Beyond its share, so that pieces overlap and rounding leaves no gap.
const OVERLAP: f64 = 1e-9;

/// Union of what the pieces allow.
#[derive(Debug, Clone, Default)]
pub(super) struct Union {
    /// The pieces that are left, in their order around the circle.
    pub(super) left: Vec<Arc>,
    scale: Option<Interval>,
    body: Vec<Region>,
    fixed: Vec<Region>,
    /// Rows that take part in the proofs of the others.
    blamed: Vec<usize>,
    /// Two bounds of one quantity that cross on the last piece.
    crossed: Option<[Interval; 2]>,
    /// Functionals, one after another, and their bounds.
    pub(super) asked: Vec<f64>,
    pub(super) bounds: Vec<f64>,
}

impl InvariantStrips {
    /// Whether the arc is to be cut: with a known scale and no arm the caps say as much.
    pub(super) fn is_worth_cutting(&self) -> bool {
        self.arc.width() > UNCUT && !(self.enclosure.body.is_empty() && self.enclosure.scale == Interval::ONE)
    }

    /// Contracts arc, scale, arms and positions piece by piece, again while it shrinks the arc a good deal.
    pub(super) fn contract_by_pieces(&mut self) -> Result<(), EstimatorError> {
        self.union.blamed.clear();
        for _ in 0..ROUNDS {
            if !self.is_worth_cutting() {
                break;
            }
            let before = self.arc.width();
            self.cut()?;
            if self.arc.width() > (1.0 - WORTHWHILE) * before {
                break;
            }
        }
        Ok(())
    }

    /// One round.
    fn cut(&mut self) -> Result<(), EstimatorError> {
        self.drop_derived();
        let rows = self.rows.len();
        let pieces = Pieces::of(self.arc);
        self.union.clear();
        for k in 0..pieces.count {
            self.arc = pieces.piece(k);
            self.push_derived()?;
            self.suspects.clear();
            if !self.contract_piece()? {
                self.union.blamed.extend(self.suspects.iter().filter(|&&i| i < rows));
            }
            self.keep(rows);
        }
        let Some(left) = hull_of_pieces(&self.union.left) else { return Err(self.refute(&pieces)?) };
        self.arc = left;
        let union = core::mem::take(&mut self.union);
        let met = self.meet_union(&union);
        self.union = union;
        met?;
        self.push_derived()
    }

    /// The contradiction where no piece is possible: of the rows with the whole arc, if there is one, or piece by piece. What a round
    /// does is done again, so that rounds that end well keep no proofs.
    fn refute(&mut self, pieces: &Pieces) -> Result<EstimatorError, EstimatorError> {
        let rows = self.rows.len();
        self.arc = pieces.whole;
        self.push_derived()?;
        if self.heading_bound(unit(Interval::point(self.arc.middle())))? == f64::NEG_INFINITY {
            return Ok(self.empty());
        }
        self.keep(rows);
        let mut cases = Vec::with_capacity(pieces.count);
        for k in 0..pieces.count {
            self.arc = pieces.piece(k);
            let part = self.arc.angles();
            self.push_derived()?;
            let possible = self.contract_piece()?;
            if !possible {
                cases.push(Case { part, evidence: self.evidence_of_piece() });
            }
            self.keep(rows);
        }
        Ok(self.no_piece(Evidence::Cases { cover: pieces.whole.angles(), cases }))
    }

    /// Why the last piece is impossible.
    fn evidence_of_piece(&self) -> Evidence {
        match (self.rows.contradiction().filter(|_| self.emptied), self.union.crossed) {
            (Some(proof), _) => Evidence::HalfSpaces { proof: Box::new(proof.clone()) },
            (None, Some([predicted, required])) => Evidence::Disjoint { predicted, required },
            (None, None) => self.unproven(),
        }
    }

    /// Contracts the arc in place, a piece, and adds what it allows to the union; false if that is nothing.
    fn contract_piece(&mut self) -> Result<bool, EstimatorError> {
        self.union.crossed = None;
        let Some(scale) = self.scale_on_piece()? else { return Ok(false) };
        let Some(arc) = self.ends_of_piece()? else { return Ok(false) };
        let toward = middle(&unit(Interval::point(self.arc.middle())));
        for l in 0..self.enclosure.body.len() {
            let Some(turned) = self.turned_box(self.embedding.body(l), toward)? else { return Ok(false) };
            let arm = self.arm_of(turned);
            join(&mut self.union.body, l, arm);
        }
        for j in 0..self.enclosure.fixed.len() {
            let Some(place) = self.place_box(j)? else { return Ok(false) };
            join(&mut self.union.fixed, j, place);
        }
        self.union.scale = Some(self.union.scale.map_or(scale, |s| s.hull(scale)));
        self.union.left.push(arc);
        Ok(true)
    }

    /// `s cos t = <z, e^{ic}>` with `|t| <= w`.
    fn scale_on_piece(&mut self) -> Result<Option<Interval>, EstimatorError> {
        let scale = self.enclosure.scale;
        let toward = unit(Interval::point(self.arc.middle()));
        let cosine = Interval::point(self.half_width()).sin_cos().1.lo();
        let most = self.heading_bound(toward)?;
        let least = -self.heading_bound(toward.map(|t| -t))?;
        Ok(self.between(scale.lo().max(least), scale.hi().min(div_up(most, cosine))))
    }

    /// The piece with its ends moved inward.
    fn ends_of_piece(&mut self) -> Result<Option<Arc>, EstimatorError> {
        let Arc { lo, hi } = self.arc;
        let first = unit(Interval::point(lo));
        let last = unit(Interval::point(hi));
        let v = self.heading_bound([-last[1], last[0]])?;
        let hi = sub_up(hi, self.inward(v));
        let v = self.heading_bound([first[1], -first[0]])?;
        let lo = sub_down(lo, -self.inward(v));
        Ok(self.between(lo, hi).map(|_| Arc { lo, hi }))
    }

    /// What lies between two bounds; if they cross, that is noted.
    fn between(&mut self, lo: f64, hi: f64) -> Option<Interval> {
        let found = Interval::new(lo, hi).ok();
        if let (None, Ok(above), Ok(below)) =
            (found, Interval::new(lo, f64::INFINITY), Interval::new(f64::NEG_INFINITY, hi))
        {
            self.union.crossed = Some([above, below]);
        }
        found
    }

    /// Intersects what was known with what the pieces allow.
    fn meet_union(&mut self, union: &Union) -> Result<(), EstimatorError> {
        if let Some(scale) = union.scale {
            let known = self.enclosure.scale;
            self.enclosure.scale = known.intersection(scale);
            if self.enclosure.scale.is_empty() {
                return Err(self.disjoint(known, scale));
            }
        }
        for l in 0..self.enclosure.body.len() {
            self.enclosure.body[l] = self.meet(self.enclosure.body[l], union.body[l])?;
        }
        for j in 0..self.enclosure.fixed.len() {
            self.enclosure.fixed[j] = self.meet(self.enclosure.fixed[j], union.fixed[j])?;
        }
        Ok(())
    }

    /// Each piece is impossible.
    fn no_piece(&self, evidence: Evidence) -> EstimatorError {
        let culprits = self.union.blamed.iter().map(|&i| self.culprit(i)).collect();
        self.inconsistent_with_arc(culprits, if evidence.verify() { evidence } else { self.unproven() })
    }

    /// Bounds of all functionals on the list, over the pieces if the arc was cut; the derived rows are gone then.
    pub(super) fn bound_asked(&mut self) -> Result<(), EstimatorError> {
        self.suspects.clear();
        let n = self.normal.len();
        let cut = !self.union.left.is_empty();
        if cut {
            self.drop_derived();
        }
        let (whole, rows) = (self.arc, self.rows.len());
        let count = self.union.asked.len() / n;
        self.union.bounds.clear();
        self.union.bounds.resize(count, f64::NEG_INFINITY);
        for piece in 0..self.union.left.len().max(1) {
            if cut {
                self.arc = self.union.left[piece];
                self.push_derived()?;
            }
            for k in 0..count {
                self.normal.copy_from_slice(&self.union.asked[k * n..(k + 1) * n]);
                let bound = self.bound()?;
                self.union.bounds[k] = self.union.bounds[k].max(bound);
            }
            self.keep(rows);
        }
        self.arc = whole;
        if self.union.bounds.contains(&f64::NEG_INFINITY) { Err(self.no_piece(self.unproven())) } else { Ok(()) }
    }
}

/// How an arc is cut.
#[derive(Debug, Clone, Copy)]
struct Pieces {
    whole: Arc,
    count: usize,
    share: f64,
    /// Half the width of a piece.
    half: f64,
}

impl Pieces {
    fn of(whole: Arc) -> Self {
        let count = (whole.width() / PIECE).ceil().clamp(1.0, MOST);
        let share = whole.width() / count;
        // Middles are off by some roundings of the largest angle.
        let half = (0.5 + OVERLAP) * share + 8.0 * f64::EPSILON * whole.lo.abs().max(whole.hi.abs());
        Self { whole, count: count as usize, share, half }
    }

    fn piece(&self, k: usize) -> Arc {
        let center = self.whole.lo + (k as f64 + 0.5) * self.share;
        Arc { lo: sub_down(center, self.half), hi: add_up(center, self.half) }
    }
}

impl Union {
    fn clear(&mut self) {
        self.left.clear();
        self.scale = None;
        self.body.clear();
        self.fixed.clear();
    }
}

/// The hull of entry `k` and a box; the first box is the entry.
fn join(hulls: &mut Vec<Region>, k: usize, seen: Region) {
    match hulls.get_mut(k) {
        Some(hull) => *hull = [hull[0].hull(seen[0]), hull[1].hull(seen[1])],
        None => hulls.push(seen),
    }
}
