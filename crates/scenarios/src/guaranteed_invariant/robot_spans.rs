//! Bounds on the motion of a robot over several windows at once: errors of odometry that do not add up.
//!
//! Over ten seconds the gyro of a log errs hardly more than over two, and the length of the way driven by much less than ten times what it errs in one.
//! A span compares dead reckoning over `L` windows with the reference: `alpha`, the error of the turn, and `n`, the error of the chord along and
//! across itself after half of `alpha` is taken off ([`PlanarIncrement::chord`]). Its bounds are [`SAFETY`](crate::wifibot::odometry::SAFETY) times the worst of all spans of that length of the
//! log, overlapping ones included: they hold by construction, as those of a window do.

use estimators::PlanarIncrement;
use scalars::Interval;

use crate::guaranteed_invariant::follow::within;
use crate::guaranteed_invariant::lever::{Increment, noise_between};
use crate::guaranteed_invariant::robot::Log;
use crate::vehicle::TruePose;

/// The motions over `windows` windows in turn, and bounds on their errors.
#[derive(Clone, Debug, PartialEq)]
pub struct Span {
    /// Number of windows.
    pub windows: usize,
    /// Bound on the turn, rad.
    pub turn_rad: f64,
    /// Bounds along and across the chord before scaling, m.
    pub chord_m: [f64; 2],
    /// The motions by dead reckoning, the first one from the first state.
    motions: Vec<Increment>,
}

impl Span {
    /// The spans of a log, with bounds `factor` times the worst.
    #[must_use]
    pub fn new(log: &Log, windows: usize, factor: f64) -> Self {
        let motions: Vec<Increment> = log.increments.windows(windows.max(1)).map(composed).collect();
        let mut worst = [0.0_f64; 3];
        for error in errors(log, windows, &motions) {
            worst = std::array::from_fn(|k| worst[k].max(error[k].mag()));
        }
        let [turn_rad, along, across] = worst.map(|worst| factor * worst);
        Self { windows, turn_rad, chord_m: [along, across], motions }
    }

    /// The motion that ends at a state, as the filter takes it; none if it would begin before the log.
    #[must_use]
    pub fn motion_to(&self, state: usize) -> Option<PlanarIncrement> {
        let Increment { turn_rad, shift_m } = self.motions.get(state.checked_sub(self.windows)?)?;
        Some(PlanarIncrement::chord(
            Interval::point(*turn_rad),
            shift_m.map(Interval::point),
            within(self.turn_rad),
            self.chord_m.map(within),
        ))
    }

    /// For each span its chord along and across itself as the reference has it (with scale 1), as dead reckoning has it, and the bounds.
    pub(super) fn chords<'a>(&'a self, log: &'a Log) -> impl Iterator<Item = [[f64; 3]; 2]> + 'a {
        errors(log, self.windows, &self.motions).zip(&self.motions).map(|(error, motion)| {
            let length = motion.shift_m[0].hypot(motion.shift_m[1]);
            let [along, across] = self.chord_m;
            [[(error[1].mid() + length) * log.scale, length, along], [error[2].mid() * log.scale, 0.0, across]]
        })
    }
}

/// `(alpha, n)` of each span. **Guarantee:** contains the exact errors.
fn errors<'a>(log: &'a Log, windows: usize, motions: &'a [Increment]) -> impl Iterator<Item = [Interval; 3]> + 'a {
    let pairs = log.states.iter().zip(log.states.iter().skip(windows));
    pairs.zip(motions).map(|((from, to), motion)| chord_error(from, to, motion, log.scale))
}

fn chord_error(from: &TruePose, to: &TruePose, motion: &Increment, scale: f64) -> [Interval; 3] {
    let [alpha, n1, n2] = noise_between(from, to, motion, scale);
    let u = motion.shift_m.map(Interval::point);
    let moved = [n1 + u[0], n2 + u[1]];
    let (sin, cos) = alpha.scale(0.5).sin_cos();
    let left = [cos * moved[0] + sin * moved[1] - u[0], cos * moved[1] - sin * moved[0] - u[1]];
    let length = (u[0].sqr() + u[1].sqr()).sqrt();
    let axis = if length.lo() > 0.0 { u.map(|side| side / length) } else { [Interval::ONE, Interval::ZERO] };
    [alpha, axis[0] * left[0] + axis[1] * left[1], axis[0] * left[1] - axis[1] * left[0]]
}

/// Increments in turn as one.
fn composed(increments: &[Increment]) -> Increment {
    increments.iter().fold(Increment { turn_rad: 0.0, shift_m: [0.0; 2] }, |sum, next| {
        let (sin, cos) = sum.turn_rad.sin_cos();
        let [along, across] = next.shift_m;
        let [x, y] = sum.shift_m;
        Increment {
            turn_rad: sum.turn_rad + next.turn_rad,
            shift_m: [x + cos * along - sin * across, y + sin * along + cos * across],
        }
    })
}

#[cfg(test)]
mod tests {
    use crate::vehicle::Pose;

    use super::*;

    /// A gyro that errs evenly on an arc: the chord is turned by half of it, and nothing is left of that.
    #[test]
    fn half_of_the_turn_is_no_error_of_the_chord() {
        let (radius_m, turn_rad, slip) = (3.0, 0.2_f64, 0.04);
        let state = |heading_rad: f64| {
            let position = [radius_m * heading_rad.sin(), radius_m * (1.0 - heading_rad.cos())];
            TruePose::new(Pose { heading_rad, position })
        };
        // The chord has the right length, and the direction of too small a turn.
        let length = 2.0 * radius_m * (0.5 * (turn_rad + slip)).sin();
        let (sin, cos) = (0.5 * turn_rad).sin_cos();
        let motion = Increment { turn_rad, shift_m: [length * cos, length * sin] };
        let [alpha, along, across] = chord_error(&state(0.0), &state(turn_rad + slip), &motion, 1.0);
        assert!((alpha.mid() - slip).abs() < 1e-15);
        assert!(along.mag() < 1e-14 && across.mag() < 1e-14, "{along} {across}");
        // A chord longer by a centimetre is off by that, along itself.
        let longer = Increment { shift_m: motion.shift_m.map(|u| u * (1.0 + 0.01 / length)), ..motion };
        let [_, along, across] = chord_error(&state(0.0), &state(turn_rad + slip), &longer, 1.0);
        assert!((along.mid() + 0.01).abs() < 1e-14 && across.mag() < 1e-14, "{along} {across}");
    }

    /// Dead reckoning over a span is that of its windows one after another, and every span ends where it should.
    #[test]
    fn motions_are_composed() {
        let quarter = Increment { turn_rad: std::f64::consts::FRAC_PI_2, shift_m: [1.0, 0.0] };
        let Increment { turn_rad, shift_m: [x, y] } = composed(&[quarter; 3]);
        assert!((turn_rad - 1.5 * std::f64::consts::PI).abs() < 1e-15 && x.abs() < 1e-15 && (y - 1.0).abs() < 1e-15);
    }
}
