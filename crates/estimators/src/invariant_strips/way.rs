//! The way of one vector of the world: what is known of it, and what its noise can add to a row.
//!
//! With `e^{i theta_hat} M = S+ - S` the known way, `E = e^{i alpha} - 1`, the forms of [`PlanarIncrement`] move `q = x - S z` by
//!
//! ```text
//! additive, exponential   q+ = q - E S+ z + e^{i theta_hat} z m
//! chord                   q+ = q - E (S + S+) / 2 z - (S+ - S) r z + e^{i (theta_hat + alpha/2)} z m,   |r| <= alpha^2 / 8
//! ```
//!
//! The second because `e^{i alpha/2} = 1 + E/2 - r` with `r = (e^{i alpha/2} - 1)^2 / 2`, so that
//! `(S+ - S) e^{i alpha/2} + S - S+ e^{i alpha} = -E (S + S+) / 2 - (S+ - S) r`. So the lever of the turns is the end of the path for the one, its
//! middle for the other.

use scalars::Interval;
use scalars::rounding::{add_up, mul_up};

use super::increment::{BodyShift, Form, PlanarIncrement};
use super::plane::{Region, Vector, difference, inner, largest_modulus, middle, point, product, radius, sum, unit};
use super::sweep::Sweep;

/// The motion of one vector in body coordinates.
pub(super) struct Way {
    form: Form,
    /// `M`.
    pub(super) moved: Region,
    /// Radius of a disc of what is left out of it.
    pub(super) lost: f64,
    /// Two corners of the noise, the others opposite to them.
    corners: [Vector; 2],
    /// Upper bound of the noise.
    pub(super) extent: f64,
    /// `e^{i phase}` turns the corners, apart from the heading.
    phase: Interval,
}

/// What a motion adds to the rows by the noise of one vector.
#[derive(Debug, Clone, Copy)]
pub(super) struct Drift {
    /// The place on the path that the turns move.
    pub(super) lever: Vector,
    pub(super) noise: Sweep,
    /// Radius of a disc that is added, rounding included.
    pub(super) disc: f64,
}

impl Drift {
    /// For a path from `from` to `to`, which is off by `missed`, headings at its start, and turns by noise of up to `most`.
    pub(super) fn new(way: &Way, [from, to]: [Vector; 2], missed: f64, headings: Interval, most: f64) -> Self {
        let (lever, bow) = match way.form {
            Form::Additive | Form::Exponential => (to, 0.0),
            Form::Chord => {
                let length = largest_modulus(&difference(&point(to), &point(from)));
                let mean = [0, 1].map(|k| 0.5 * from[k] + 0.5 * to[k]);
                (mean, mul_up(length, mul_up(0.125, mul_up(most, most))))
            }
        };
        let noise = Sweep::new(headings + way.phase, &way.corners);
        Self { lever, noise, disc: add_up(add_up(way.lost, missed), bow) }
    }
}

impl PlanarIncrement {
    /// How vector `j` is moved; `slip` is the turn without its noise less that of the reference.
    pub(super) fn way(&self, j: usize, slip: Interval) -> Way {
        let BodyShift { shift, noise } = self.of_vector(j);
        // The middle of the noise is a part of the shift.
        let center = point(middle(noise));
        let radii = [noise[0].rad(), noise[1].rad()];
        let corners = [radii, [radii[0], -radii[1]]];
        let extent = largest_modulus(&point(radii));
        let way = Way { form: self.form, moved: *shift, lost: 0.0, corners, extent, phase: Interval::ZERO };
        match self.form {
            Form::Additive => Way { moved: sum(shift, &center), ..way },
            // Of V(i alpha) - 1 at most |alpha| / 2 is left.
            Form::Exponential => Way {
                moved: sum(shift, &product(&unit(self.turn), &center)),
                lost: mul_up(0.5 * self.turn_noise.mag(), largest_modulus(&center)),
                phase: self.turn + self.turn_noise.scale(0.5),
                ..way
            },
            // The turn relative to the reference is that by the noise and the slip.
            Form::Chord => {
                let axis = direction(shift);
                let corners = corners.map(|corner| product(&axis, &point(corner)));
                Way {
                    moved: product(&unit(slip.scale(-0.5)), &sum(shift, &product(&axis, &center))),
                    lost: corners.iter().map(radius).fold(0.0, f64::max),
                    corners: corners.map(|corner| middle(&corner)),
                    phase: self.turn_noise.scale(0.5),
                    ..way
                }
            }
        }
    }

    /// How far the noise turns the known way, if it turns by up to `most` in all.
    pub(super) fn chord_turn(&self, most: f64) -> f64 {
        if self.form == Form::Chord { 0.5 * most } else { 0.0 }
    }
}

/// Encloses `u / |u|`, 1 for `u = 0`.
fn direction(u: &Region) -> Region {
    if *u == [Interval::ZERO; 2] {
        return [Interval::ONE, Interval::ZERO];
    }
    let unit = Interval::new(-1.0, 1.0).unwrap_or(Interval::ENTIRE);
    let length = inner(u, u).sqrt();
    if length.lo() > 0.0 { u.map(|side| (side / length).intersection(unit)) } else { [unit; 2] }
}

#[cfg(test)]
mod tests {
    use super::super::embedding::Embedding;
    use super::super::plane::dot;
    use super::super::transport::Account;
    use super::*;

    fn turned(angle: f64, a: Vector) -> Vector {
        let (s, c) = angle.sin_cos();
        [c * a[0] - s * a[1], s * a[0] + c * a[1]]
    }

    fn plus(a: Vector, b: Vector) -> Vector {
        [a[0] + b[0], a[1] + b[1]]
    }

    /// `U + n` of one form, turned as it is, for one noise.
    fn moved(form: Form, u: Vector, turn: f64, alpha: f64, n: Vector) -> Vector {
        match form {
            Form::Additive => plus(u, n),
            // e^{i turn} V(i alpha) n
            Form::Exponential => {
                plus(u, turned(turn + 0.5 * alpha, n.map(|side| side * (0.5 * alpha).sin() / (0.5 * alpha))))
            }
            Form::Chord => turned(0.5 * alpha, plus(u, turned(u[1].atan2(u[0]), n))),
        }
    }

    /// What a motion adds to a row, over noises, headings and scales, is never above the growth and comes near it: with the other lever, or without
    /// the half turn of a chord, it would be.
    #[test]
    fn growth_is_the_supremum() {
        let symmetric = |radius: f64| Interval::new(-radius, radius).unwrap();
        let (reference, turn, most, radii) = (1.0, 0.4, 0.005, [0.002, 0.003]);
        let (from, u, scales) = ([2.0, 1.0], [3.0, 0.5], [0.999, 1.001]);
        let arc = Interval::new(0.399, 0.401).unwrap();
        let arm = [1.0, 0.5];
        for form in [Form::Additive, Form::Exponential, Form::Chord] {
            let motion = PlanarIncrement {
                form,
                ..PlanarIncrement::odometry(Interval::point(turn), point(u), symmetric(most), radii.map(symmetric))
            };
            let next = reference + turn;
            let slip = Interval::point(turn) - (Interval::point(next) - Interval::point(reference));
            let way = motion.way(0, slip);
            let reached = sum(&point(from), &product(&unit(Interval::point(reference)), &way.moved));
            let to = middle(&reached);
            let headings = Interval::point(reference) + arc;
            let axis = middle(&unit(Interval::point(0.4)));
            let account = Account {
                drifts: &[Drift::new(&way, [from, to], radius(&reached), headings, most)],
                turned: &[product(&unit(arc - Interval::point(0.4)), &point(arm)).map(|side| side.inflate(1e-12))],
                axis,
                scale: Interval::new(scales[0], scales[1]).unwrap(),
                embedding: Embedding::new(1, 1),
                swing: Sweep::new(arc.inflate(0.5 * most), &[[0.0, 1.0]]),
                most,
            };
            for k in 0..24 {
                let angle = f64::from(k) * 0.27;
                let (a, d, g) =
                    (turned(1.7 * angle, [1.5, 0.0]), turned(angle, [1.0, 0.0]), turned(-0.6 * angle, [1.0, 0.0]));
                let growth = account.growth(&[a[0], a[1], d[0], d[1], g[0], g[1]]);
                let mut most_seen = f64::NEG_INFINITY;
                for phi in [arc.lo(), 0.4, arc.hi()] {
                    for scale in scales {
                        for alpha in [-1.0, -0.99, -0.5, 0.001, 0.5, 0.99, 1.0].map(|part| part * most) {
                            for n in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
                                let n = [n[0] * radii[0], n[1] * radii[1]];
                                let (z, xi) = (turned(phi, [scale, 0.0]), turned(phi, arm));
                                let x =
                                    turned(reference + phi, moved(form, u, turn, alpha, n).map(|side| side * scale));
                                // q+ - q = (x+ - S+ z+) - (x - S z)
                                let after = turned(alpha, z);
                                let [s, s_next] = [from, to].map(|s| [[s[0], -s[1]], [s[1], s[0]]]);
                                let q = [0, 1].map(|j| x[j] - dot(s_next[j], after) + dot(s[j], z));
                                let moved_z = [after[0] - z[0], after[1] - z[1]];
                                let after = turned(alpha, xi);
                                let moved_xi = [after[0] - xi[0], after[1] - xi[1]];
                                most_seen = most_seen.max(dot(a, moved_z) + dot(d, q) + dot(g, moved_xi));
                            }
                        }
                    }
                }
                assert!(most_seen <= growth + 1e-13, "{form:?} {k}: {most_seen} above {growth}");
                // Headings and scales are chosen for each term apart, and the turn's second order is bounded.
                assert!(most_seen > 0.95 * growth, "{form:?} {k}: {most_seen} far below {growth}");
            }
        }
    }

    /// With the lever in the middle of a chord, what the turns leave is a bow of second order, known to 1 %.
    #[test]
    fn the_bow_of_a_chord_is_of_second_order() {
        let (most, u) = (0.1, [3.0, 0.5]);
        let zero = Interval::ZERO;
        let motion = PlanarIncrement::chord(zero, point(u), Interval::new(-most, most).unwrap(), [zero; 2]);
        let drift = Drift::new(&motion.way(0, zero), [[0.0; 2], u], 0.0, zero, most);
        assert!((drift.lever[0] - 1.5).abs() < 1e-15 && (drift.lever[1] - 0.25).abs() < 1e-15);
        // e^{i alpha/2} u = u + E u / 2 - r u
        let left = |alpha: f64| {
            let [half, whole] = [turned(0.5 * alpha, u), turned(alpha, u)];
            let r = [0, 1].map(|k| half[k] - 0.5 * (u[k] + whole[k]));
            r[0].hypot(r[1])
        };
        let largest = [-most, most].map(left).into_iter().fold(0.0, f64::max);
        assert!(drift.disc >= largest && drift.disc < 1.01 * largest, "{} for {largest}", drift.disc);
    }

    /// `u / |u|` is enclosed, for points to rounding.
    #[test]
    fn directions_are_enclosed() {
        for (a, b) in [(3.0, 4.0), (-1e-150, 1e-150), (0.0, -2.0), (1e-300, 0.0)] {
            let [x, y] = direction(&point([a, b]));
            let angle = f64::atan2(b, a);
            assert!(
                x.inflate(1e-15).contains(angle.cos()) && y.inflate(1e-15).contains(angle.sin()),
                "{a} {b}: {x} {y}"
            );
        }
        let [x, y] = direction(&point([3.0, 4.0]));
        assert!(x.width() < 1e-15 && y.width() < 1e-15);
        let around = Interval::new(-1.0, 2.0).unwrap();
        assert_eq!(direction(&[around, around]).map(|side| (side.lo(), side.hi())), [(-1.0, 1.0); 2]);
        assert_eq!(direction(&[Interval::ZERO; 2]), [Interval::ONE, Interval::ZERO]);
    }
}
