//! Bounds on the motion over several steps, for errors that do not add up.

use estimators::{
    Estimator, EstimatorError, InvariantStrips, PlanarBox, PlanarIncrement, PlanarMeasurement, StripsOptions,
};
use scalars::Interval;

use crate::support::Random;

/// Way of a step by the odometry.
const WAY: [f64; 2] = [1.0, 0.0];
/// Bounds of the noises of a step: rad, m, m.
const NOISE: [f64; 3] = [0.004, 0.05, 0.05];
const SCALE: f64 = 1.05;
const ARM: [f64; 2] = [0.5, 0.3];
const FIX: f64 = 0.05;
const STEPS: usize = 80;

fn symmetric(radius: f64) -> Interval {
    Interval::new(-radius, radius).unwrap()
}

fn point(a: [f64; 2]) -> [Interval; 2] {
    a.map(Interval::point)
}

fn turned(angle: Interval, [x, y]: [Interval; 2]) -> [Interval; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}

/// Enclosures of an exact trajectory whose errors change sign from step to step, so that they hardly add up.
fn drive(seed: u64) -> Vec<(Interval, [Interval; 2])> {
    let mut random = Random::new(seed);
    let mut states = vec![(Interval::point(0.4), [Interval::ZERO; 2])];
    for k in 0..STEPS {
        let (heading, [x, y]) = states[k];
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        let mut noise = |bound: f64| Interval::point(sign * bound * (0.6 + 0.4 * random.unit().abs()));
        let body = [WAY[0], WAY[1]].map(|u| Interval::point(SCALE) * (Interval::point(u) + noise(NOISE[1])));
        let [a, b] = turned(heading, body);
        states.push((heading + Interval::point(turn(k)) + noise(NOISE[0]), [x + a, y + b]));
    }
    states
}

/// Turn of a step by the odometry: a circle, then straight on, which tells scale and arm apart.
fn turn(k: usize) -> f64 {
    if k < STEPS / 2 { 0.2 } else { 0.0 }
}

/// Dead reckoning from step `from` over `steps` steps.
fn reckoned(from: usize, steps: usize) -> (f64, [f64; 2]) {
    (from..from + steps).fold((0.0, [0.0; 2]), |(heading, [x, y]), k| {
        let (sin, cos) = f64::sin_cos(heading);
        (heading + turn(k), [x + cos * WAY[0] - sin * WAY[1], y + sin * WAY[0] + cos * WAY[1]])
    })
}

/// All motions over so many steps, as chords or with additive noise, and bounds that the trajectory just keeps.
struct Span {
    steps: usize,
    chord: bool,
    bounds: [f64; 3],
}

impl Span {
    fn new(states: &[(Interval, [Interval; 2])], steps: usize, chord: bool) -> Self {
        let mut bounds = [0.0_f64; 3];
        for (k, pair) in states.windows(steps + 1).enumerate() {
            let ((from, [x0, y0]), (to, [x1, y1])) = (pair[0], pair[steps]);
            let (turn, u) = reckoned(k, steps);
            let alpha = to - from - Interval::point(turn);
            let back = if chord { from + alpha.scale(0.5) } else { from };
            let moved = turned(-back, [x1 - x0, y1 - y0]);
            let missed = [0, 1].map(|k| moved[k] / Interval::point(SCALE) - Interval::point(u[k]));
            let [a, b] = point(u);
            let length = (a * a + b * b).sqrt();
            let aligned = [(a * missed[0] + b * missed[1]) / length, (a * missed[1] - b * missed[0]) / length];
            let noise = if chord { aligned } else { missed };
            bounds = [bounds[0].max(alpha.mag()), bounds[1].max(noise[0].mag()), bounds[2].max(noise[1].mag())];
        }
        Self { steps, chord, bounds }
    }

    /// The motion that ends at state `k`; that of the first steps for earlier ones.
    fn motion_to(&self, k: usize) -> PlanarIncrement {
        let (turn, u) = reckoned(k.saturating_sub(self.steps), self.steps);
        let [alpha, along, across] = self.bounds.map(symmetric);
        let form = if self.chord { PlanarIncrement::chord } else { PlanarIncrement::odometry };
        form(Interval::point(turn), point(u), alpha, [along, across])
    }
}

fn filter(spans: usize) -> InvariantStrips {
    let scale = Interval::new(0.8, 1.25).unwrap();
    let prior = PlanarBox::scale_and_lever_arm(Interval::ENTIRE, scale, [symmetric(3.0); 2], [symmetric(2.0); 2]);
    InvariantStrips::new(&prior, StripsOptions { spans, ..StripsOptions::calibration() }).unwrap()
}

fn step(k: usize) -> PlanarIncrement {
    let [a, b, c] = NOISE.map(symmetric);
    PlanarIncrement::odometry(Interval::point(turn(k)), point(WAY), a, [b, c])
}

/// Runs the filter with spans of the given lengths; widths of heading and scale at the end.
fn run(seed: u64, lengths: &[usize], chord: bool) -> [f64; 2] {
    let states = drive(seed);
    let spans: Vec<Span> = lengths.iter().map(|&steps| Span::new(&states, steps, chord)).collect();
    let mut filter = filter(lengths.iter().copied().max().unwrap_or(0));
    let mut random = Random::new(seed + 100);
    for (k, &(heading, position)) in states.iter().enumerate().skip(1) {
        filter.predict(&step(k - 1)).unwrap();
        for span in &spans {
            let known = filter.bound_span(span.steps, &span.motion_to(k)).unwrap();
            assert_eq!(known, span.steps <= k, "step {k}, span {}", span.steps);
        }
        let truth = PlanarBox::scale_and_lever_arm(heading, Interval::point(SCALE), position, point(ARM));
        assert!(!filter.excludes(&truth).unwrap(), "seed {seed}, step {k}, predicted");
        let [a, b] = turned(heading, point(ARM));
        let fix =
            [position[0] + a, position[1] + b].map(|side| side.mid() + random.sign() * (FIX - side.rad() - 1e-13));
        let y = PlanarMeasurement::position(fix, [symmetric(FIX); 2]).with_unknown_arm(0);
        filter.update(&[y]).unwrap_or_else(|error| panic!("seed {seed}, step {k}: {error}"));
        assert!(!filter.excludes(&truth).unwrap(), "seed {seed}, step {k}");
    }
    [filter.enclosure().heading_width_rad(), filter.enclosure().scale.width()]
}

/// The truth stays inside though the bounds of the spans are attained, and errors that cancel leave much smaller sets.
#[test]
fn errors_that_do_not_add_up_leave_smaller_sets() {
    for seed in 1..3 {
        let [heading, scale] = run(seed, &[], true);
        for chord in [true, false].into_iter().take(3 - seed as usize) {
            let [finer, sharper] = run(seed, &[2, 4, 6, 8, 12, 16, 24], chord);
            println!("{seed} {chord}: {finer} of {heading}, {sharper} of {scale}");
            assert!(
                finer < 0.6 * heading && sharper < 0.6 * scale,
                "{chord}: {finer} of {heading}, {sharper} of {scale}"
            );
        }
    }
}

/// A span that is not remembered says nothing; one that is no motion is refused and changes nothing.
#[test]
fn spans_beyond_memory_and_bad_spans_change_nothing() {
    let mut filter = filter(3);
    for _ in 0..6 {
        filter.predict(&step(0)).unwrap();
    }
    let before = filter.clone();
    let same = |filter: &InvariantStrips| {
        filter.enclosure() == before.enclosure()
            && filter.clone().polytope().unwrap() == before.clone().polytope().unwrap()
    };
    assert!(!filter.bound_span(0, &step(0)).unwrap());
    assert!(!filter.bound_span(4, &step(0)).unwrap());
    let wild = PlanarIncrement::odometry(Interval::ENTIRE, point(WAY), Interval::ZERO, [Interval::ZERO; 2]);
    assert!(matches!(filter.bound_span(3, &wild), Err(EstimatorError::NotFinite { .. })));
    let two = step(0).with_vector(point(WAY), [Interval::ZERO; 2]);
    assert!(matches!(filter.bound_span(3, &two), Err(EstimatorError::Size { .. })));
    assert!(same(&filter));
    // A motion that has nothing to do with the one taken, and one too large for numbers: nothing is gained, nothing is lost.
    let far =
        PlanarIncrement::chord(Interval::point(0.2), point([1e9, 1e300]), symmetric(1e300), [symmetric(1e308); 2]);
    assert!(filter.bound_span(3, &far).unwrap());
    assert!(same(&filter));
}
