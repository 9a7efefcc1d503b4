//! Prediction: how a step of the odometry moves the coordinates of the embedding and each row.
//!
//! With `theta_hat` the sum of the turns, `z = s e^{i phi}`, `phi = theta - theta_hat`, `xi = e^{i phi} X`, and the alpha of the step
//! including whatever rounding did to `theta_hat`,
//!
//! ```text
//! z+ = e^{i alpha} z,   x+ = x + e^{i theta_hat} z (U + m),   xi+ = e^{i alpha} xi
//! ```
//!
//! The rows are kept in the coordinates `q = x - S z`, where `S`, a number, follows the path: `S+ = S + e^{i theta_hat} U`. So
//! `q+ = q + e^{i theta_hat} z m + S+ z (1 - e^{i alpha}) + eps z` with `eps = S + e^{i theta_hat} U - S+` of rounding size, and
//! `<a, z> + <d, q> + <k, xi> <= h` becomes the same row with
//!
//! ```text
//! h+ = h + sup { <a', z (e^{i alpha} - 1)> + <k, xi (e^{i alpha} - 1)> } + sup { <d, e^{i theta_hat} z m> } + |d| |eps| s2,   a' = a - conj(S+) d
//! ```
//!
//! because `<d, S z> = <conj(S) d, z>`. Nothing else changes: transport costs no error at all. The suprema:
//! `z (e^{i alpha} - 1) = s 2 sin(alpha/2) i e^{i (phi + alpha/2)}` with `2 |sin(alpha/2)| <= |alpha|`, and
//! `m = e^{i rho} e^{i alpha/2} sinc(alpha/2) n` with `0 <= sinc <= 1` (`rho` the turn; `m = n` for additive noise): both are [`Sweep`]s.

use scalars::Interval;
use scalars::rounding::{ETA, UNIT_ROUNDOFF, add_up, mul_up};

use super::InvariantStrips;
use super::arc::Arc;
use super::embedding::Embedding;
use super::increment::PlanarIncrement;
use super::planar_box::check_bounded;
use super::plane::{Region, Vector, largest_modulus, middle, modulus_up, norm1, point, product, radius, sum, unit};
use super::sweep::Sweep;
use super::way::{Drift, Way};
use crate::EstimatorError;
use crate::error::check_finite;

/// The rounding of a sum of some dozen products, relative.
const SLACK: f64 = 1.0 + 1e-13;

/// All that decides what the noise of a motion can take from a row.
pub(super) struct Account<'a> {
    pub(super) drifts: &'a [Drift],
    /// Boxes of `xi_l / axis` at its start.
    pub(super) turned: &'a [Region],
    pub(super) axis: Vector,
    pub(super) scale: Interval,
    pub(super) embedding: Embedding,
    /// `i e^{i (phi + alpha/2)}`, `phi` at the start.
    pub(super) swing: Sweep,
    /// Largest turn by the noise.
    pub(super) most: f64,
}

/// The constants of one step, reused by all rows.
#[derive(Debug, Clone, Default)]
pub(super) struct Motion {
    drifts: Vec<Drift>,
    path: Vec<Vector>,
    fixed: Vec<Region>,
    turned: Vec<Region>,
    /// Room for the coordinates to drift.
    drift: Vec<f64>,
    reach: Vec<Region>,
    /// `theta_hat` after the step, and the largest turn by its noise.
    reference: f64,
    most: f64,
}

impl Motion {
    pub(super) fn new(fixed: usize, body: usize) -> Self {
        let region = [Interval::ZERO; 2];
        Self {
            drifts: Vec::with_capacity(fixed),
            path: vec![[0.0; 2]; fixed],
            fixed: vec![region; fixed],
            turned: vec![region; body],
            drift: vec![0.0; fixed],
            reach: vec![region; fixed],
            reference: 0.0,
            most: 0.0,
        }
    }
}

impl InvariantStrips {
    /// Prepares a step; only the scratch changes.
    pub(super) fn plan(&mut self, input: &PlanarIncrement) -> Result<(), EstimatorError> {
        input.check(self.enclosure.fixed.len())?;
        let turn = input.turn + input.turn_noise;
        let reference = self.reference + turn.mid();
        check_finite("turn", &[reference])?;
        let alpha = turn - (Interval::point(reference) - Interval::point(self.reference));
        let most = alpha.mag();
        let scale = self.enclosure.scale;
        let farthest = scale.hi();

        let motion = &mut self.motion;
        motion.drifts.clear();
        let heading = unit(Interval::point(self.reference));
        let headings = Interval::point(self.reference) + self.arc.angles();
        let slip = input.turn - (Interval::point(reference) - Interval::point(self.reference));
        let facing = unit(headings.inflate(input.chord_turn(most)));
        for (j, path) in self.path.iter().enumerate() {
            let way = input.way(j, slip);
            let Way { moved, lost, extent, .. } = way;
            let next = sum(&point(*path), &product(&heading, &moved));
            let path_next = middle(&next);
            let drift = Drift::new(&way, [*path, path_next], radius(&next), headings, most);
            motion.drifts.push(drift);
            motion.path[j] = path_next;

            // The hull of the vector, in the world.
            let spread = |d: Vector| mul_up(farthest, add_up(drift.noise.sup_abs(d), lost) * SLACK);
            let step = product(&facing, &moved);
            motion.fixed[j] = [
                (self.enclosure.fixed[j][0] + scale * step[0]).inflate(spread([1.0, 0.0])),
                (self.enclosure.fixed[j][1] + scale * step[1]).inflate(spread([0.0, 1.0])),
            ];
            // The reach of q.
            let wander = add_up(drift.disc, add_up(extent, mul_up(modulus_up(drift.lever), most)));
            let growth = mul_up(farthest, wander);
            motion.reach[j] = self.reach[j].map(|side| side.inflate(growth));
            // Room for 128 steps like this one, the path growing to 64 of them on average.
            let turned_by_then = 64.0 * most * modulus_up(middle(&moved));
            motion.drift[j] = 128.0 * farthest * (extent + turned_by_then);
            check_finite("path", &path_next)?;
            check_bounded("position", &motion.fixed[j])?;
            check_bounded("position", &motion.reach[j])?;
            check_finite("drift", &[motion.drift[j]])?;
        }
        for (next, now) in motion.turned.iter_mut().zip(&self.turned) {
            let slip = mul_up(most, largest_modulus(now));
            *next = now.map(|side| side.inflate(slip));
        }

        motion.reference = reference;
        motion.most = most;
        Ok(())
    }

    /// Takes the step that has been prepared.
    pub(super) fn transport(&mut self) {
        self.remember();
        let (reference, most) = (self.motion.reference, self.motion.most);
        self.move_rows(most);
        core::mem::swap(&mut self.path, &mut self.motion.path);
        core::mem::swap(&mut self.enclosure.fixed, &mut self.motion.fixed);
        core::mem::swap(&mut self.turned, &mut self.motion.turned);
        core::mem::swap(&mut self.drift, &mut self.motion.drift);
        core::mem::swap(&mut self.reach, &mut self.motion.reach);
        self.reference = reference;
        self.arc = self.arc.widened(most);
        self.enclosure.heading_rad = self.heading();
        self.step += 1;
    }

    /// Adds to every row what the noise of the step can take from it.
    fn move_rows(&mut self, most: f64) {
        let account = Account {
            drifts: &self.motion.drifts,
            turned: &self.turned,
            axis: self.axis,
            scale: self.enclosure.scale,
            embedding: self.embedding,
            swing: Sweep::new(self.arc.angles().inflate(0.5 * most), &[[0.0, 1.0]]),
            most,
        };
        for i in 0..self.rows.len() {
            let growth = account.growth(self.rows.normal(i));
            self.rows.raise(i, growth);
        }
    }

    /// The heading in the world.
    pub(super) fn heading(&self) -> Interval {
        if self.arc.is_whole() {
            return Arc::whole().angles();
        }
        Interval::point(self.reference) + self.arc.angles()
    }
}

impl Account<'_> {
    /// What the noise can take from a row of this normal.
    pub(super) fn growth(&self, normal: &[f64]) -> f64 {
        let (most, half) = (self.most, 0.5 * self.most);
        let (nearest, farthest) = (self.scale.lo(), self.scale.hi());
        let mut lever: Vector = [normal[0], normal[1]];
        let mut size = norm1(lever);
        let mut drift = 0.0;
        for (j, moved) in self.drifts.iter().enumerate() {
            let path = moved.lever;
            let column = self.embedding.fixed(j);
            let d: Vector = [normal[column], normal[column + 1]];
            if d == [0.0, 0.0] {
                continue;
            }
            lever[0] -= path[0] * d[0] + path[1] * d[1];
            lever[1] -= path[0] * d[1] - path[1] * d[0];
            size += norm1(path) * norm1(d);
            drift += moved.noise.sup_abs(d) + moved.disc * norm1(d);
        }
        let mut low = -self.swing.sup([-lever[0], -lever[1]]);
        low *= if low < 0.0 { farthest } else { nearest };
        let mut high = self.swing.sup(lever);
        high *= if high > 0.0 { farthest } else { nearest };
        let mut pad = size * farthest;
        for (l, sides) in self.turned.iter().enumerate() {
            let column = self.embedding.body(l);
            let k: Vector = [normal[column], normal[column + 1]];
            if k == [0.0, 0.0] {
                continue;
            }
            // <k, i e^{i alpha/2} xi> with xi = axis (A_1 + i A_2), turned by at most half.
            let axis = self.axis;
            let g: Vector = [axis[0] * k[1] - axis[1] * k[0], -(axis[0] * k[0] + axis[1] * k[1])];
            let extent = sides[0].mag() + sides[1].mag();
            let center = g[0] * sides[0].mid() + g[1] * sides[1].mid();
            let spread = g[0].abs() * sides[0].rad() + g[1].abs() * sides[1].rad() + half * extent * norm1(k);
            low += center - spread;
            high += center + spread;
            pad += norm1(k) * extent;
        }
        let turning = most * (high.max(-low).max(0.0) + 64.0 * UNIT_ROUNDOFF * pad);
        (turning + farthest * drift) * SLACK + 1e3 * ETA
    }
}
