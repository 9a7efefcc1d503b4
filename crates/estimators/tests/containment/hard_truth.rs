//! States, motions and sensors where bounds are hardest to keep: ranges without width or to one side, lengths of any size, whole turns in a step.

use estimators::{PlanarBox, PlanarIncrement, PlanarMeasurement};
use scalars::Interval;

use crate::support::Random;

pub(crate) type Region = [Interval; 2];

fn turned(heading: Interval, v: Region) -> Region {
    let (sin, cos) = heading.sin_cos();
    [cos * v[0] - sin * v[1], sin * v[0] + cos * v[1]]
}

fn sum(a: Region, b: Region) -> Region {
    [a[0] + b[0], a[1] + b[1]]
}

pub(crate) fn difference(a: Region, b: Region) -> Region {
    [a[0] - b[0], a[1] - b[1]]
}

fn pick(random: &mut Random, values: &[f64]) -> f64 {
    values[random.below(values.len())]
}

/// A range: a point or none, symmetric, to one side, far from 0.
fn range(random: &mut Random, size: f64) -> Interval {
    let (a, b) = match random.below(6) {
        0 => (0.0, 0.0),
        1 => (-1.0, 1.0),
        2 => (0.0, random.unit()),
        3 => (2.0, 2.0 + 0.1 * random.unit()),
        4 => (random.unit(), random.unit()),
        _ => (0.3, 0.3),
    };
    Interval::point(a * size).hull(Interval::point(b * size))
}

/// A member: the end that is held, or mostly an end.
fn member(random: &mut Random, held: Option<usize>, range: Interval) -> Interval {
    Interval::point(match held.unwrap_or_else(|| random.below(5)) {
        0 | 1 => range.lo(),
        2 | 3 => range.hi(),
        _ => (range.mid() + range.rad() * random.unit()).clamp(range.lo(), range.hi()),
    })
}

/// A state, enclosed, and the unit of its lengths.
pub(crate) struct Truth {
    pub(crate) state: PlanarBox,
    pub(crate) unit: f64,
    pub(crate) random: Random,
    /// All noises at their lower (0) or upper (2) ends.
    pub(crate) held: Option<usize>,
    /// The part of the radii of the odometry's noises that the filter is told.
    pub(crate) declared: f64,
}

impl Truth {
    pub(crate) fn vector(&mut self, size: f64) -> Region {
        [0; 2].map(|_| Interval::point(size * self.unit * self.random.unit()))
    }

    pub(crate) fn new(seed: u64) -> Self {
        let mut random = Random::new(seed);
        let unit = pick(&mut random, &[1.0, 1.0, 1.0, 1e-150, 1e-9, 1e9, 1e150]);
        let heading_rad = Interval::point(pick(&mut random, &[0.0, 1.0, 3.0, 100.0, 1e6]) * random.unit());
        let scale = Interval::point(pick(&mut random, &[1.0, 1.0, 0.9, 1e-3, 700.0]));
        let (fixed, body) = (1 + random.below(3), random.below(3));
        let held = [None, None, Some(0), Some(2)][random.below(4)];
        let state = PlanarBox { heading_rad, scale, fixed: vec![], body: vec![] };
        let mut truth = Self { state, unit, random, held, declared: 1.0 };
        truth.state.fixed = (0..fixed).map(|_| truth.vector(2.0)).collect();
        truth.state.body = (0..body).map(|_| truth.vector(2.0)).collect();
        truth
    }

    pub(crate) fn prior(&mut self) -> PlanarBox {
        let mut prior = self.state.clone();
        let pi = core::f64::consts::PI;
        let width = pick(&mut self.random, &[0.0, 1e-12, 0.5, 0.5 * pi, pi.next_down(), pi, 4.0, f64::INFINITY]);
        let around = |random: &mut Random, x: Interval, width: f64| {
            let share = pick(random, &[0.0, 0.5, 1.0]);
            x.hull(Interval::point(x.lo() - share * width)).hull(Interval::point(x.hi() + (1.0 - share) * width))
        };
        prior.heading_rad = around(&mut self.random, prior.heading_rad, 2.0 * width);
        if width.is_infinite() {
            prior.heading_rad = Interval::ENTIRE;
        }
        if prior.scale != Interval::ONE && self.random.below(3) > 0 {
            prior.scale *= Interval::new(0.9, 1.3).unwrap();
        }
        for side in prior.fixed.iter_mut().chain(&mut prior.body).flatten() {
            let width = self.unit * pick(&mut self.random, &[0.0, 1e-12, 1.0, 10.0]);
            *side = around(&mut self.random, *side, width);
        }
        prior
    }

    pub(crate) fn advance(&mut self) -> PlanarIncrement {
        let turn = pick(&mut self.random, &[0.0, 0.05, 0.05, 3.5, 7.0, 1e3]) * self.random.unit();
        let known = |random: &mut Random, x: f64| {
            if random.below(4) == 0 { Interval::point(x).inflate(1e-3 * x.abs()) } else { Interval::point(x) }
        };
        let size = pick(&mut self.random, &[0.0, 1e-12, 1e-3, 0.1, 1.0]);
        let turn = known(&mut self.random, turn);
        let turn_noise = {
            let share = pick(&mut self.random, &[1.0, 1e-3, 8.0]);
            range(&mut self.random, size * share)
        };
        let exponential = self.random.below(2) == 0 && self.state.fixed.len() == 1;
        let (true_turn, alpha) =
            (member(&mut self.random, self.held, turn), member(&mut self.random, self.held, turn_noise));
        let mut shifts = Vec::new();
        for j in 0..self.state.fixed.len() {
            let shift = [0; 2].map(|_| {
                let x = self.unit * pick(&mut self.random, &[0.0, 0.5, 20.0]) * self.random.unit();
                known(&mut self.random, x)
            });
            let noise = [0; 2].map(|_| range(&mut self.random, size * self.unit));
            let moved = shift.map(|s| member(&mut self.random, self.held, s));
            let slip = noise.map(|n| member(&mut self.random, self.held, n));
            let step = if exponential {
                let mean = |a: Interval| [a.sqr().stumpff(1), a * a.sqr().stumpff(2)];
                let product = |a: Region, b: Region| [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
                sum(product(mean(true_turn), moved), turned(true_turn, product(mean(alpha), slip)))
            } else {
                sum(moved, slip)
            };
            let scale = self.state.scale;
            let x = self.state.fixed[j];
            self.state.fixed[j] = sum(x, turned(self.state.heading_rad, step).map(|v| scale * v));
            shifts.push((shift, noise.map(|n| self.told(n))));
        }
        let turn_noise = self.told(turn_noise);
        self.state.heading_rad += true_turn + alpha;
        let ([a, b], [n, m]) = shifts[0];
        if exponential {
            return PlanarIncrement::exponential([turn, a, b], [turn_noise, n, m]);
        }
        let first = PlanarIncrement::odometry(turn, [a, b], turn_noise, [n, m]);
        shifts[1..].iter().fold(first, |step, &(shift, noise)| step.with_vector(shift, noise))
    }

    fn told(&self, noise: Interval) -> Interval {
        if self.declared < 1.0 { Interval::point(noise.mid()).inflate(self.declared * noise.rad()) } else { noise }
    }

    /// A number and the range of its noise, whose end it may be at.
    fn read(&mut self, value: Interval, size: f64) -> (f64, Interval) {
        let range = range(&mut self.random, size);
        let y = value.mid() + member(&mut self.random, self.held, range).mid();
        // What the rounding of `y` adds.
        (y, range.hull(Interval::point(y) - value))
    }

    pub(crate) fn measure(&mut self) -> PlanarMeasurement {
        let (vector, size) = (self.random.below(self.state.fixed.len()), self.unit);
        let noise = size * pick(&mut self.random, &[0.0, 1e-6, 0.1, 1.0]);
        let (mut place, heading) = (self.state.fixed[vector], self.state.heading_rad);
        let one = self.state.scale == Interval::ONE;
        let mut known = None;
        let mut unknown = None;
        match self.random.below(3) {
            0 if one => {
                let arm = self.vector(3.0);
                place = sum(place, turned(heading, arm));
                known = Some(arm.map(|x| x.mid()));
            }
            1 if !self.state.body.is_empty() => {
                let l = self.random.below(self.state.body.len());
                place = sum(place, turned(heading, self.state.body[l]));
                unknown = Some(l);
            }
            _ => {}
        }
        let kind = if one { self.random.below(3) } else { 0 };
        let measurement = if kind == 0 {
            let [(x, u), (y, v)] = place.map(|p| self.read(p, noise));
            PlanarMeasurement::position([x, y], [u, v])
        } else {
            let landmark = self.vector(30.0);
            let seen = turned(-heading, difference(landmark, place));
            if kind == 1 {
                let [(x, u), (y, v)] = seen.map(|p| self.read(p, noise));
                PlanarMeasurement::landmark(landmark, [x, y], [u, v])
            } else {
                let flip = self.random.below(3) == 0;
                let away = (seen[0].sqr() + seen[1].sqr()).sqrt();
                let (y, x) = if flip { (-seen[1], -seen[0]) } else { (seen[1], seen[0]) };
                let turns = pick(&mut self.random, &[0.0, 0.0, 1.0, -3.0, 1e5]);
                let bearing = y.atan2(x) + Interval::PI.scale(2.0 * turns);
                let spread = pick(&mut self.random, &[0.0, 1e-6, 0.1, 3.0, 7.0]);
                let bearing = bearing.hull(bearing + Interval::point(spread * self.random.unit()));
                let away = away.hull(away + Interval::point(noise * self.random.unit()));
                PlanarMeasurement::range_bearing(landmark, if flip { -away } else { away }, bearing)
            }
        };
        let measurement = known.map_or(measurement, |arm| measurement.with_arm(arm));
        unknown.map_or(measurement, |l| measurement.with_unknown_arm(l)).of_vector(vector)
    }
}
