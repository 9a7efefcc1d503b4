//! Bounds on the motion over several steps: errors that do not add up.
//!
//! A row `<a, z> + <d, q> + <k, xi> <= h_j` of step `j` reads `<= h_j + r` at step `k`, where `r` is the supremum of section "transport" for
//! the motion from `j` to `k` as one: its coordinates and normals are the same all the way, so only the noise of that motion counts.
//! With bounds of its own, which may be far below the sum of those of the steps, this can be less than what the steps
//! have added up to. Both hold, so the smaller one does.

use std::collections::VecDeque;

use scalars::Interval;
use scalars::rounding::add_up;

use super::InvariantStrips;
use super::arc::Arc;
use super::increment::PlanarIncrement;
use super::plane::{Region, Vector, difference, largest_modulus, point, product, sum, unit};
use super::sweep::Sweep;
use super::transport::Account;
use super::way::Drift;
use crate::EstimatorError;

/// The set before a step, as far as the rows that were there are concerned.
#[derive(Debug, Clone)]
struct Past {
    reference: f64,
    arc: Arc,
    path: Vec<Vector>,
    axis: Vector,
    turned: Vec<Region>,
    /// Of the rows of that time that are still kept: they are the first ones, in their order.
    offsets: Vec<f64>,
}

/// The sets before the last steps, the latest last.
#[derive(Debug, Clone, Default)]
pub(super) struct Spans {
    past: VecDeque<Past>,
    /// How many of them, from the latest on, are in the coordinates of today.
    known: usize,
    drifts: Vec<Drift>,
}

impl Spans {
    /// Forgets the rows that are not kept.
    pub(super) fn retain(&mut self, keep: &[bool]) {
        for past in &mut self.past {
            let mut i = 0;
            past.offsets.retain(|_| {
                i += 1;
                keep[i - 1]
            });
        }
    }

    /// Forgets all steps: the coordinates have changed.
    pub(super) fn clear(&mut self) {
        self.known = 0;
        self.past.iter_mut().for_each(|past| past.offsets.clear());
    }
}

impl InvariantStrips {
    /// Takes note of the set before a step.
    pub(super) fn remember(&mut self) {
        let most = self.options.spans;
        if most == 0 {
            return;
        }
        let past = &mut self.spans.past;
        let mut entry = if past.len() < most { None } else { past.pop_front() }.unwrap_or_else(|| Past {
            reference: 0.0,
            arc: self.arc,
            path: Vec::new(),
            axis: self.axis,
            turned: Vec::new(),
            offsets: Vec::new(),
        });
        entry.reference = self.reference;
        entry.arc = self.arc;
        entry.axis = self.axis;
        entry.path.clone_from(&self.path);
        entry.turned.clone_from(&self.turned);
        entry.offsets.clear();
        entry.offsets.extend_from_slice(self.rows.offsets());
        past.push_back(entry);
        self.spans.known = (self.spans.known + 1).min(most);
    }

    /// Takes a bound on the motion of the last `steps` predictions as one: `motion` is what they amount to, with the range of its own noise.
    ///
    /// Odometry errs less over five seconds than five times over one, so such bounds can be much sharper than the sum of those of the
    /// steps. Rows and headings of that time are moved by this motion too, and the smaller set is kept. Call it after
    /// [`predict`](crate::Estimator::predict) and before [`update`](crate::Estimator::update), for as many spans as have bounds.
    ///
    /// Returns whether the filter still knew the set of that time: it remembers [`StripsOptions::spans`](crate::StripsOptions::spans) steps, and none from before its
    /// coordinates started anew (every hundred steps or so, and by [`polytope`](Self::polytope)).
    ///
    /// **Guarantee:** the state stays in the set if the noise of `motion` is in its range.
    ///
    /// # Errors
    /// As for `predict`; the set is unchanged then.
    pub fn bound_span(&mut self, steps: usize, motion: &PlanarIncrement) -> Result<bool, EstimatorError> {
        motion.check(self.enclosure.fixed.len())?;
        if steps == 0 || steps > self.spans.known {
            return Ok(false);
        }
        let Self { spans: Spans { past, drifts, .. }, .. } = self;
        let start = &past[past.len() - steps];

        let turn = motion.turn + motion.turn_noise;
        let alpha = turn - (Interval::point(self.reference) - Interval::point(start.reference));
        let most = alpha.mag();
        let slip = motion.turn - (Interval::point(self.reference) - Interval::point(start.reference));
        let heading = unit(Interval::point(start.reference));
        let headings = Interval::point(start.reference) + start.arc.angles();
        drifts.clear();
        for (j, (from, to)) in start.path.iter().zip(&self.path).enumerate() {
            let way = motion.way(j, slip);
            let missed = difference(&sum(&point(*from), &product(&heading, &way.moved)), &point(*to));
            drifts.push(Drift::new(&way, [*from, *to], largest_modulus(&missed), headings, most));
        }
        let account = Account {
            drifts,
            turned: &start.turned,
            axis: start.axis,
            scale: self.enclosure.scale,
            embedding: self.embedding,
            swing: Sweep::new(start.arc.angles().inflate(0.5 * most), &[[0.0, 1.0]]),
            most,
        };
        for (i, &before) in start.offsets.iter().enumerate() {
            let offset = add_up(before, account.growth(self.rows.normal(i)));
            if offset < self.rows.offsets()[i] {
                self.rows.set_offset(i, offset)?;
            }
        }
        if let Some(arc) = start.arc.widened(most).common(&self.arc) {
            self.arc = arc;
            self.enclosure.heading_rad = self.heading();
        }
        Ok(true)
    }
}
