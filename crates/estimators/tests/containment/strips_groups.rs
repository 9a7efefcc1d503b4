//! The filter of strips on other planar groups, with other sensors, and on bad input.

use estimators::{
    Estimator, EstimatorError, InvariantStrips, PlanarBox, PlanarIncrement, PlanarMeasurement, StripsOptions,
};
use scalars::Interval;

use crate::support::Random;

fn symmetric(radius: f64) -> Interval {
    Interval::new(-radius, radius).unwrap()
}

/// An enclosure of a vehicle with further vectors: odometry of 0.5 m and 0.05 rad a step, noises below 2e-3 and asymmetric.
struct Truth {
    state: PlanarBox,
    random: Random,
    /// Turn of a step, rad.
    turn: f64,
}

/// Ranges of the noises: the middle is not zero.
fn ranges() -> [Interval; 3] {
    [(-1e-3, 3e-3), (0.0, 2e-3), (-2e-3, 1e-3)].map(|(lo, hi)| Interval::new(lo, hi).unwrap())
}

/// A member of a range, 1e-9 of its width off its ends.
fn member(range: Interval, random: &mut Random) -> f64 {
    range.mid() + 0.5 * range.width() * (1.0 - 2e-9) * random.unit()
}

fn turned(heading: Interval, v: [Interval; 2]) -> [Interval; 2] {
    let (sin, cos) = heading.sin_cos();
    [cos * v[0] - sin * v[1], sin * v[0] + cos * v[1]]
}

fn turned_back(heading: Interval, v: [Interval; 2]) -> [Interval; 2] {
    turned(-heading, v)
}

impl Truth {
    fn new(fixed: usize, body: usize, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let mut vectors = |count: usize| -> Vec<[Interval; 2]> {
            (0..count).map(|_| [0; 2].map(|_| Interval::point(2.0 * random.unit()))).collect()
        };
        let (fixed, body) = (vectors(fixed), vectors(body));
        let heading_rad = Interval::point(3.0 * random.unit());
        Self { state: PlanarBox { heading_rad, scale: Interval::ONE, fixed, body }, random, turn: 0.05 }
    }

    /// Moves the first vector by the odometry and the others by a constant body vector, with noise.
    fn advance(&mut self) -> PlanarIncrement {
        let [turning, forward, left] = ranges();
        let heading = self.state.heading_rad;
        let shift = |j: usize| [Interval::point(0.5 - 0.2 * j as f64), Interval::point(0.1 * j as f64)];
        for (j, x) in self.state.fixed.iter_mut().enumerate() {
            let noise = [forward, left].map(|range| Interval::point(member(range, &mut self.random)));
            let known = shift(j);
            let step = turned(heading, [known[0] + noise[0], known[1] + noise[1]]);
            *x = [x[0] + step[0], x[1] + step[1]];
        }
        self.state.heading_rad += Interval::point(self.turn) + Interval::point(member(turning, &mut self.random));
        let increment = PlanarIncrement::odometry(Interval::point(self.turn), shift(0), turning, [forward, left]);
        (1..self.state.fixed.len()).fold(increment, |step, j| step.with_vector(shift(j), [forward, left]))
    }

    /// The place of a sensor at `arm`.
    fn place(&self, vector: usize, arm: [Interval; 2]) -> [Interval; 2] {
        let [x, y] = self.state.fixed[vector];
        let lever = turned(self.state.heading_rad, arm);
        [x + lever[0], y + lever[1]]
    }

    /// A number off a value by a noise in the range.
    fn read(&mut self, value: Interval, noise: Interval) -> f64 {
        value.mid() + member(noise, &mut self.random)
    }

    fn read_place(&mut self, place: [Interval; 2], noise: Interval) -> PlanarMeasurement {
        let y = place.map(|side| self.read(side, noise));
        PlanarMeasurement::position(y, [noise; 2])
    }
}

/// A prior around the truth: heading unknown, vectors within 3 of zero.
fn prior(truth: &Truth) -> PlanarBox {
    let wide = |vectors: &[[Interval; 2]]| vectors.iter().map(|_| [symmetric(3.0); 2]).collect();
    let (fixed, body) = (wide(&truth.state.fixed), wide(&truth.state.body));
    PlanarBox { heading_rad: Interval::ENTIRE, scale: Interval::ONE, fixed, body }
}

/// Runs a filter on what `sense` measures; every set holds the truth. Returns the last one.
fn run(
    mut truth: Truth,
    steps: usize,
    options: StripsOptions,
    mut sense: impl FnMut(&mut Truth) -> Vec<PlanarMeasurement>,
) -> InvariantStrips {
    let mut filter = InvariantStrips::new(&prior(&truth), options).unwrap();
    for k in 0..steps {
        let measurements = sense(&mut truth);
        filter.update(&measurements).unwrap_or_else(|error| panic!("step {k}: {error}"));
        assert!(!filter.excludes(&truth.state).unwrap(), "step {k}");
        filter.predict(&truth.advance()).unwrap();
        assert!(!filter.excludes(&truth.state).unwrap(), "step {k}, predicted");
    }
    filter
}

/// SE_2(2): both vectors measured, the second one less well.
#[test]
fn several_vectors_share_a_heading() {
    let noise = Interval::new(-0.2, 0.3).unwrap();
    let filter = run(Truth::new(2, 0, 1), 80, StripsOptions::pose(), |truth| {
        let (first, second) = (truth.state.fixed[0], truth.state.fixed[1]);
        vec![truth.read_place(first, noise), truth.read_place(second, symmetric(1.0)).of_vector(1)]
    });
    let set = filter.enclosure();
    assert!(set.heading_width_rad() < 0.1, "{set:?}");
    assert!(set.fixed[1].iter().all(|side| side.width() < 1.2), "{set:?}");
}

/// Two receivers at known places on the body tell the heading at rest as well.
#[test]
fn known_arms_tell_the_heading_at_once() {
    let arms = [[2.0, 0.0], [-2.0, 0.5]];
    let filter = run(Truth::new(1, 0, 2), 1, StripsOptions::pose(), |truth| {
        let sense = |truth: &mut Truth, arm: [f64; 2]| {
            let place = truth.place(0, arm.map(Interval::point));
            truth.read_place(place, symmetric(0.05)).with_arm(arm)
        };
        arms.map(|arm| sense(truth, arm)).to_vec()
    });
    assert!(filter.enclosure().heading_width_rad() < 0.2, "{:?}", filter.enclosure());
    // Each place is known to 0.05 m on an axis, and so is the body between them.
    assert!(filter.enclosure().position_area() < 0.03, "{:?}", filter.enclosure());
}

/// Problem 2 of paper 002: the arm of the only receiver is found by turning to and fro (on one circle it cannot be seen).
#[test]
fn an_unknown_arm_is_found() {
    let (noise, mut instant) = (symmetric(0.05), 0);
    let filter = run(Truth::new(1, 1, 3), 120, StripsOptions::calibration(), |truth| {
        instant += 1;
        truth.turn = if instant % 20 < 10 { 0.2 } else { -0.2 };
        let place = truth.place(0, truth.state.body[0]);
        vec![truth.read_place(place, noise).with_unknown_arm(0)]
    });
    let set = filter.enclosure();
    assert!(set.heading_width_rad() < 0.15 && set.body[0].iter().all(|side| side.width() < 0.7), "{set:?}");
}

/// Known places seen from the body, as vectors or as range and bearing, and no position at all.
#[test]
fn landmarks_tell_the_pose() {
    let landmarks = [[4.0, 1.0], [-3.0, 6.0]].map(|p| p.map(Interval::point));
    let noise = Interval::new(-0.02, 0.03).unwrap();
    for polar in [false, true] {
        let filter = run(Truth::new(1, 0, 4), 30, StripsOptions::pose(), |truth| {
            let see = |truth: &mut Truth, p: [Interval; 2]| {
                let arm = [0.3, -0.2];
                let [x, y] = truth.place(0, arm.map(Interval::point));
                let seen = turned_back(truth.state.heading_rad, [p[0] - x, p[1] - y]);
                if polar {
                    let range = (seen[0].sqr() + seen[1].sqr()).sqrt() + symmetric(0.03);
                    let bearing = seen[1].atan2(seen[0]) + symmetric(0.01);
                    PlanarMeasurement::range_bearing(p, range, bearing).with_arm(arm)
                } else {
                    let y = seen.map(|side| truth.read(side, noise));
                    PlanarMeasurement::landmark(p, y, [noise; 2]).with_arm(arm)
                }
            };
            landmarks.map(|p| see(truth, p)).to_vec()
        });
        let set = filter.enclosure();
        assert!(set.heading_width_rad() < 0.05 && set.position_area() < 0.05, "{polar} {set:?}");
    }
}

/// The polygon and the polytope hold the truth, the distance reaches it, and boxes inside are proven to be.
#[test]
fn outputs_enclose() {
    let mut truth = Truth::new(1, 1, 5);
    let mut filter = InvariantStrips::new(&prior(&truth), StripsOptions::calibration()).unwrap();
    for _ in 0..40 {
        let place = truth.place(0, truth.state.body[0]);
        let y = truth.read_place(place, symmetric(0.1)).with_unknown_arm(0);
        filter.update(&[y]).unwrap();
        filter.predict(&truth.advance()).unwrap();
    }
    let position = truth.state.fixed[0];
    let polygon = filter.polygon(0, 12).unwrap();
    assert_eq!(polygon.membership(&position).unwrap(), setrep::Membership::ProvenInside);
    let away = filter.max_distance_from([position[0].mid() + 30.0, position[1].mid()]).unwrap();
    assert!(away > 30.0 && away < 35.0, "{away}");
    let phi = truth.state.heading_rad - Interval::point(filter.reference_heading_rad());
    let (sin, cos) = phi.sin_cos();
    let xi = turned(phi, truth.state.body[0]);
    let embedded = [cos, sin, position[0], position[1], xi[0], xi[1]];
    let polytope = filter.polytope().unwrap();
    assert_ne!(polytope.membership(&embedded).unwrap(), setrep::Membership::ProvenOutside);
    assert!(filter.includes(&truth.state).unwrap() && !filter.excludes(&truth.state).unwrap());
    let mut elsewhere = truth.state.clone();
    elsewhere.heading_rad += Interval::point(1.0);
    assert!(filter.excludes(&elsewhere).unwrap());
    elsewhere.heading_rad = truth.state.heading_rad + Interval::PI.scale(4.0);
    assert!(filter.includes(&elsewhere).unwrap(), "headings count modulo a turn");
}

/// Refused input says what is wrong, and changes nothing.
#[test]
fn bad_input_is_refused() {
    let side = symmetric(5.0);
    let new = |prior: &PlanarBox| InvariantStrips::new(prior, StripsOptions::pose());
    assert!(matches!(
        new(&PlanarBox::se2(Interval::EMPTY, [side; 2])),
        Err(EstimatorError::EmptyRange { what: "heading", index: 0 })
    ));
    assert!(matches!(
        new(&PlanarBox::se2(side, [side, Interval::ENTIRE])),
        Err(EstimatorError::NotFinite { what: "vectors of the world", index: 1, .. })
    ));
    assert!(matches!(
        new(&PlanarBox::scale_and_lever_arm(side, side, [side; 2], [side; 2])),
        Err(EstimatorError::NotPositive { what: "scale", .. })
    ));
    assert!(matches!(new(&PlanarBox::se_k2(side, &[])), Err(EstimatorError::Size { expected: 1, found: 0, .. })));
    let none = StripsOptions { memory: 0, ..StripsOptions::pose() };
    assert!(InvariantStrips::new(&PlanarBox::se2(side, [side; 2]), none).is_err());

    let scale = Interval::new(0.8, 1.2).unwrap();
    let mut filter = new(&PlanarBox::scale_and_lever_arm(side, scale, [side; 2], [side; 2])).unwrap();
    let before = format!("{:?}", (filter.enclosure(), filter.num_rows(), filter.step_count()));
    let good = PlanarMeasurement::position([0.0, 0.0], [side; 2]);
    assert!(matches!(filter.update(&[good, good.with_arm([1.0, 0.0])]), Err(EstimatorError::ScaleUnknown { .. })));
    assert!(matches!(filter.update(&[good.of_vector(1)]), Err(EstimatorError::Size { expected: 1, found: 2, .. })));
    assert!(matches!(
        filter.update(&[good.with_unknown_arm(3)]),
        Err(EstimatorError::Size { expected: 1, found: 4, .. })
    ));
    assert!(matches!(
        filter.update(&[PlanarMeasurement::position([f64::NAN, 0.0], [side; 2])]),
        Err(EstimatorError::EmptyRange { .. } | EstimatorError::NotFinite { .. })
    ));
    let point = Interval::ZERO;
    let huge = Interval::point(1e308);
    for step in [
        PlanarIncrement::exponential([Interval::ENTIRE, point, point], [point; 3]),
        PlanarIncrement::exponential([point; 3], [Interval::EMPTY, point, point]),
        PlanarIncrement::odometry(point, [point; 2], point, [point; 2]).with_vector([point; 2], [point; 2]),
    ] {
        assert!(filter.predict(&step).is_err());
    }
    let _ = filter.predict(&PlanarIncrement::odometry(huge, [point; 2], huge, [point; 2])).unwrap_err();
    let _ = filter.predict(&PlanarIncrement::odometry(point, [huge, huge], point, [huge; 2])).unwrap_err();
    assert_eq!(before, format!("{:?}", (filter.enclosure(), filter.num_rows(), filter.step_count())));
    assert!(filter.polygon(1, 8).is_err() && filter.polygon(0, 2).is_err());
    assert!(filter.max_distance_from([f64::INFINITY, 0.0]).is_err());
    assert!(filter.excludes(&PlanarBox::se2(side, [side; 2])).is_err());
    filter.update(&[]).unwrap();
    filter.update(&[good]).unwrap();
}
