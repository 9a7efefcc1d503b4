//! The filter of strips in space holds an enclosure of an exact trajectory whose noises keep their bounds, down to the vertices of these.

use estimators::{
    Culprit, Estimator, EstimatorError, Evidence, SpatialBox, SpatialIncrement, SpatialMeasurement, SpatialStrips,
    StripsOptions,
};
use lie_groups::{Enclose, LieGroup, SO3};
use nalgebra::Vector3;
use scalars::Interval;

use crate::support::{Random, cases};

type Region = [Interval; 3];

/// How the noises are drawn, those of measurements moved inward by rounding.
#[derive(Clone, Copy, Debug)]
enum Noise {
    Uniform,
    Vertices,
    /// One vertex for the whole run.
    Constant,
}

fn ball(radius: f64) -> Region {
    [Interval::new(-radius, radius).unwrap(); 3]
}

fn point(v: [f64; 3]) -> Region {
    v.map(Interval::point)
}

fn vector(v: &Region) -> nalgebra::SVector<Interval, 3> {
    nalgebra::SVector::from(*v)
}

fn sum(a: Region, b: Region) -> Region {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// An interval enclosure of an exact trajectory.
struct Truth {
    /// About where the attitude is, and its enclosure.
    near: SO3<f64>,
    attitude: SO3<Interval>,
    vectors: Vec<Region>,
    noise: Noise,
    random: Random,
    held: Vec<f64>,
    draws: usize,
    /// By how much the bounds are broken.
    factor: f64,
}

impl Truth {
    fn new(attitude: [f64; 3], vectors: &[[f64; 3]], noise: Noise, seed: u64) -> Self {
        let near = SO3::exp(&Vector3::from(attitude));
        let mut random = Random::new(seed);
        let held = (0..64).map(|_| random.sign()).collect();
        let vectors = vectors.iter().map(|v| point(*v)).collect();
        Self { near, attitude: near.enclose(), vectors, noise, random, held, draws: 0, factor: 1.0 }
    }

    /// A noise within `bounds`.
    fn draw(&mut self, bound: f64) -> [f64; 3] {
        core::array::from_fn(|_| {
            self.draws += 1;
            bound
                * self.factor
                * match self.noise {
                    Noise::Uniform => self.random.unit(),
                    Noise::Vertices => self.random.sign(),
                    Noise::Constant => self.held[self.draws % self.held.len()],
                }
        })
    }

    fn turned(&self, v: Region) -> Region {
        self.attitude.act(&vector(&v)).into()
    }

    fn turn(&mut self, turns: &[Region]) {
        for v in turns {
            self.attitude = self.attitude.compose(&SO3::exp(&vector(v)));
            self.near = self.near.compose(&SO3::exp(&vector(v).map(|x| x.mid())));
        }
    }

    /// A step of odometry: vector 0 moves. Returns what the filter is told.
    fn drive(&mut self, turn: [f64; 3], shift: [f64; 3], bounds: [f64; 2]) -> SpatialIncrement {
        self.draws = 0;
        let (alpha, slip) = (self.draw(bounds[0]), self.draw(bounds[1]));
        self.vectors[0] = sum(self.vectors[0], self.turned(sum(point(shift), point(slip))));
        self.turn(&[point(turn), point(alpha)]);
        SpatialIncrement::odometry(turn, point(shift), ball(bounds[0]), ball(bounds[1]))
    }

    /// A step of an inertial unit, vectors position and velocity.
    fn fly(&mut self, rate: [f64; 3], force: [f64; 3], bounds: [f64; 2], dt: f64) -> SpatialIncrement {
        self.draws = 0;
        let (off, slip) = (self.draw(bounds[0]), self.draw(bounds[1]));
        let h = Interval::point(dt);
        let acceleration = sum(point(GRAVITY), self.turned(sum(point(force), point(slip))));
        let [position, velocity] = [self.vectors[0], self.vectors[1]];
        let half = (h * h).scale(0.5);
        self.vectors[0] = sum(sum(position, velocity.map(|v| v * h)), acceleration.map(|a| a * half));
        self.vectors[1] = sum(velocity, acceleration.map(|a| a * h));
        self.turn(&[sum(point(rate), point(off)).map(|r| r * h)]);
        SpatialIncrement::inertial(rate, force, ball(bounds[0]), ball(bounds[1]), point(GRAVITY), dt).unwrap()
    }

    /// Numbers off a value by noises in a ball.
    fn read(&mut self, value: &Region, bound: f64) -> [f64; 3] {
        let noise = self.draw(bound);
        core::array::from_fn(|k| {
            let (middle, off) = (value[k].mid(), value[k].rad() + 1e-15 * (1.0 + value[k].mag() + bound));
            let y = middle + noise[k] * (1.0 - off / bound).max(0.0);
            assert!(
                self.factor > 1.0 || (Interval::point(y) - value[k]).mag() <= bound,
                "the measurement keeps its bound"
            );
            y
        })
    }

    fn place(&mut self, j: usize, arm: [f64; 3], bound: f64) -> SpatialMeasurement {
        let place = sum(self.vectors[j], self.turned(point(arm)));
        SpatialMeasurement::vector(self.read(&place, bound), ball(bound)).of_vector(j).with_arm(arm)
    }

    fn direction(&mut self, world: [f64; 3], bound: f64) -> SpatialMeasurement {
        let seen: Region = self.attitude.inverse().act(&vector(&point(world))).into();
        SpatialMeasurement::direction(point(world), self.read(&seen, bound), ball(bound))
    }

    fn landmark(&mut self, place: [f64; 3], arm: [f64; 3], bound: f64) -> SpatialMeasurement {
        let from = sum(self.vectors[0], self.turned(point(arm))).map(|x| -x);
        let seen: Region = self.attitude.inverse().act(&vector(&sum(point(place), from))).into();
        SpatialMeasurement::landmark(point(place), self.read(&seen, bound), ball(bound)).with_arm(arm)
    }

    fn state(&self) -> SpatialBox {
        let off = self.attitude.compose(&self.near.enclose().inverse()).log().unwrap();
        SpatialBox::new(self.near, off.into(), &self.vectors)
    }

    /// A check that the truth is in the set; the largest radius of its attitudes and of its first vector.
    fn radii(&self, filter: &SpatialStrips) -> [f64; 2] {
        assert!(!filter.excludes(&self.state()).unwrap(), "step {}", filter.step_count());
        let set = filter.enclosure();
        [set.turn_rad, set.vectors[0]].map(|sides| sides.iter().map(Interval::rad).fold(0.0, f64::max))
    }
}

/// Means of the radii over the second half of a run.
type Means = [f64; 2];

fn add_late(means: &mut Means, radii: [f64; 2], k: usize, steps: usize) {
    if k >= steps / 2 {
        for (mean, radius) in means.iter_mut().zip(radii) {
            *mean += radius / (steps - steps / 2) as f64;
        }
    }
}

const ARMS: [[f64; 3]; 2] = [[1.0, 0.0, 0.2], [-0.5, 0.8, 0.0]];

/// Odometry of `SE(3)`, two antennas to 0.1 m and, if `vertical`, gravity to 0.5 m/s^2; the prior's radii of the attitude are `turn`.
fn antennas(
    truth: &mut Truth,
    turn: [f64; 3],
    vertical: bool,
    steps: usize,
) -> Result<(Means, SpatialStrips), EstimatorError> {
    let turns = turn.map(|radius| Interval::new(-radius, radius).unwrap());
    let center = truth.near.compose(&SO3::exp(&Vector3::from(turn.map(|r| 0.4 * r.min(1.0)))));
    let prior = SpatialBox::new(center, turns, &[ball(5.0)]);
    let mut filter = SpatialStrips::new(&prior, StripsOptions::pose()).unwrap();
    let mut means = [0.0; 2];
    for k in 0..steps {
        let mut measurements = ARMS.map(|arm| truth.place(0, arm, 0.1)).to_vec();
        if vertical {
            measurements.push(truth.direction(GRAVITY, 0.5));
        }
        let before = (filter.enclosure().clone(), filter.num_rows(), filter.cells());
        if let Err(error) = filter.update(&measurements) {
            assert_eq!(before, (filter.enclosure().clone(), filter.num_rows(), filter.cells()));
            return Err(error);
        }
        if truth.factor <= 1.0 {
            add_late(&mut means, truth.radii(&filter), k, steps);
        }
        let turn = [0.02, 0.03 * (0.1 * k as f64).sin(), 0.05];
        filter.predict(&truth.drive(turn, [0.5, 0.0, 0.0], [1e-3, 0.01])).unwrap();
        if truth.factor <= 1.0 {
            truth.radii(&filter);
        }
    }
    Ok((means, filter))
}

fn start(noise: Noise, seed: u64) -> Truth {
    Truth::new([0.3, -0.2, 0.7], &[[1.0, -2.0, 0.5]], noise, seed)
}

/// Two antennas, uniform noise, noise at vertices and one vertex held; attitude known to 0.2 and 0.5 rad, or to 1 rad and the vertical seen.
#[test]
fn antennas_tell_pose_and_attitude() {
    for (noise, limits) in [
        (Noise::Uniform, [[0.14, 0.11], [0.05, 0.08]]),
        (Noise::Vertices, [[0.03, 0.03], [0.005, 0.015]]),
        (Noise::Constant, [[0.15, 0.16], [0.1, 0.14]]),
    ] {
        for (vertical, turn, limit) in [(false, [0.2, 0.2, 0.5], limits[0]), (true, [1.0; 3], limits[1])] {
            let (means, filter) = antennas(&mut start(noise, 1), turn, vertical, 50).unwrap();
            println!("{noise:?} {vertical} {means:?} rows {}", filter.num_rows());
            assert!(
                means[0] < limit[0] && means[1] < limit[1] && filter.cells() == 1,
                "{noise:?} {vertical}: {means:?}"
            );
            assert!(filter.num_rows() < 320);
        }
    }
}

/// Nothing is known of the attitude, or of the heading alone.
#[test]
fn an_unknown_attitude_is_found() {
    let pi = core::f64::consts::PI;
    for turn in [[0.2, 0.2, pi], [4.0; 3]] {
        let (means, filter) = antennas(&mut start(Noise::Uniform, 5), turn, true, 12).unwrap();
        println!("{turn:?} {means:?}");
        assert!(means[0] < 0.06 && filter.cells() == 1, "{turn:?}: {means:?} {}", filter.cells());
    }
    // Fewer cells than it takes to cover all attitudes: nothing is found, and nothing is wrong.
    let options = StripsOptions { caps: 10, ..StripsOptions::pose() };
    let mut truth = start(Noise::Uniform, 5);
    let prior = SpatialBox::new(SO3::identity(), [Interval::ENTIRE; 3], &[ball(5.0)]);
    let mut filter = SpatialStrips::new(&prior, options).unwrap();
    filter.update(&ARMS.map(|arm| truth.place(0, arm, 0.1))).unwrap();
    assert!(truth.radii(&filter)[0] > pi && filter.cells() == 1);
}

/// Noises 1.3 times their bounds are proven to be, in each run, and named.
#[test]
fn broken_bounds_are_proven() {
    for seed in 1..4 {
        let mut truth = start(Noise::Vertices, seed);
        truth.factor = 1.3;
        let Err(EstimatorError::Inconsistent(found)) = antennas(&mut truth, [0.2, 0.2, 0.5], false, 40).map(|_| ())
        else {
            panic!("seed {seed}: nothing found");
        };
        println!("{found}");
        assert!(
            found.culprits.iter().any(|c| matches!(c, Culprit::Measurement(_) | Culprit::Earlier { .. })),
            "{found}"
        );
        assert!(found.verify() || matches!(found.evidence, Evidence::Propagation { .. }), "{found}");
    }
}

/// `SE_2(3)`: an inertial unit at 10 Hz for 8 s, position to 0.3 m, the magnetic field to a twentieth of its length.
#[test]
fn inertial_navigation_holds_the_truth() {
    for (noise, limits) in [(Noise::Uniform, [0.05, 0.2]), (Noise::Constant, [0.14, 0.301])] {
        let mut truth = Truth::new([0.1, -0.1, 2.0], &[[0.0; 3], [3.0, 0.0, 0.0]], noise, 2);
        let turn = [0.3, 0.3, 1.0].map(|radius| Interval::new(-radius, radius).unwrap());
        let prior = SpatialBox::new(truth.near, turn, &[ball(3.0), ball(6.0)]);
        let mut filter = SpatialStrips::new(&prior, StripsOptions::pose()).unwrap();
        let (mut means, steps) = ([0.0; 2], 80);
        for k in 0..steps {
            let field = truth.direction([0.6, 0.0, -0.8], 0.05);
            filter.update(&[truth.place(0, [0.0; 3], 0.3), field]).unwrap();
            add_late(&mut means, truth.radii(&filter), k, steps);
            let t = 0.1 * k as f64;
            let force = [t.sin(), 0.5 * (0.7 * t).cos(), 9.81 + 0.3 * (1.3 * t).sin()];
            filter.predict(&truth.fly([0.05, -0.04, 0.3], force, [2e-3, 0.02], 0.1)).unwrap();
            truth.radii(&filter);
        }
        let velocity = filter.enclosure().vectors[1].map(|side| side.rad());
        println!("{noise:?} {means:?} {velocity:?} rows {}", filter.num_rows());
        assert!(means[0] < limits[0] && means[1] < limits[1], "{noise:?}: {means:?}");
        assert!(velocity.iter().all(|&radius| radius < 1.0), "{noise:?}: {velocity:?}");
    }
}

/// Known places seen from a sensor on the body, and no position at all.
#[test]
fn landmarks_tell_the_pose() {
    let mut truth = start(Noise::Uniform, 7);
    let prior = SpatialBox::new(truth.near, [Interval::new(-0.6, 0.5).unwrap(); 3], &[ball(5.0)]);
    let mut filter = SpatialStrips::new(&prior, StripsOptions::pose()).unwrap();
    for _ in 0..15 {
        let places = [[4.0, 1.0, 0.0], [-3.0, 6.0, 2.0], [1.0, -5.0, 3.0]];
        let seen = places.map(|place| truth.landmark(place, [0.3, -0.2, 0.1], 0.03));
        filter.update(&seen).unwrap();
        truth.radii(&filter);
        filter.predict(&truth.drive([0.0, 0.05, 0.05], [0.2, 0.1, 0.0], [1e-3, 1e-3])).unwrap();
    }
    let radii = truth.radii(&filter);
    assert!(radii[0] < 0.02 && radii[1] < 0.05, "{radii:?}");
}

/// Straight ahead with all noises at one vertex: each bound of the noise terms is attained to first order, so a smaller one loses the truth.
#[test]
fn noise_terms_are_attained() {
    let mut truth = Truth::new([0.0; 3], &[[0.0; 3]], Noise::Constant, 1);
    truth.held.fill(1.0);
    let prior = SpatialBox::new(truth.near, [Interval::ZERO; 3], &[[Interval::ZERO; 3]]);
    let mut filter = SpatialStrips::new(&prior, StripsOptions::pose()).unwrap();
    let steps = 40;
    for _ in 0..steps {
        filter.predict(&truth.drive([0.0; 3], [0.5, 0.0, 0.0], [1e-5, 1e-4])).unwrap();
        truth.radii(&filter);
    }
    // No news, but the bounds by linear programs.
    filter.update(&[SpatialMeasurement::vector([20.0, 0.0, 0.0], ball(10.0))]).unwrap();
    truth.radii(&filter);
    let (reached, bound) = (truth.vectors[0][1].mid(), filter.enclosure().vectors[0][1].hi());
    // The noise of 40 shifts, and the turns since each of them.
    let expected = 40.0 * 1e-4 + 1e-5 * 0.5 * (39.0 * 40.0 / 2.0);
    assert!((reached - expected).abs() < 1e-5 * expected + 1e-6, "{reached} {expected}");
    assert!(bound >= reached && bound < 1.003 * reached, "{bound} {reached}");
}

/// A vector that is coupled and drifts, priors and noises without width, to one side and large, turns of any size, lengths of any size.
#[test]
fn hard_steps_hold_the_truth() {
    for seed in 0..cases(24) as u64 {
        let mut random = Random::new(seed);
        let unit = [1.0, 1e-9, 1e9, 1.0][random.below(4)];
        let size = [0.0, 1e-6, 0.01, 0.3][random.below(4)];
        let initial: [f64; 3] = core::array::from_fn(|_| 2.0 * random.unit());
        let places: [[f64; 3]; 2] = core::array::from_fn(|_| core::array::from_fn(|_| unit * random.unit()));
        let mut truth = Truth::new(initial, &places, Noise::Uniform, seed);
        let wide = [0.0, 0.1, 1.0, 4.0][random.below(4)];
        let turn: Region = core::array::from_fn(|_| Interval::point(0.0).hull(Interval::point(wide * random.sign())));
        let around = [0.0, unit][random.below(2)];
        let vectors: Vec<Region> = truth.vectors.iter().map(|v| v.map(|x| x.inflate(around))).collect();
        let options = StripsOptions { caps: 8, memory: 1 + random.below(20), ..StripsOptions::pose() };
        let mut filter = SpatialStrips::new(&SpatialBox::new(truth.near, turn, &vectors), options).unwrap();
        for step in 0..12 {
            let range = |random: &mut Random| {
                let (a, b) = (size * random.unit(), size * random.unit());
                Interval::point(a).hull(Interval::point([a, b, -a][random.below(3)]))
            };
            let turn: [f64; 3] = core::array::from_fn(|_| [0.0, 0.1, 4.0][random.below(3)] * random.unit());
            let alpha: Region = core::array::from_fn(|_| range(&mut random));
            let mut told = SpatialIncrement::odometry(turn, [Interval::ZERO; 3], alpha, [Interval::ZERO; 3]);
            let mut moved = Vec::new();
            for j in 0..2 {
                let [shift, noise, drift]: [Region; 3] = core::array::from_fn(|k| {
                    core::array::from_fn(|_| {
                        let x = range(&mut random) * Interval::point(unit);
                        if k == 0 { x + Interval::point(unit * random.unit()) } else { x }
                    })
                });
                let ends = [shift, noise, drift]
                    .map(|region| region.map(|x| Interval::point(if step % 2 == 0 { x.lo() } else { x.hi() })));
                moved.push(ends);
                if j == 0 {
                    told = SpatialIncrement::odometry(turn, shift, alpha, noise);
                } else {
                    told = told.with_vector(shift, noise);
                }
                told = told.with_drift(j, drift).unwrap();
            }
            let c = 0.3 * random.unit();
            told = told.with_coupling(0, 1, c).unwrap();
            let [first, second] = [truth.vectors[0], truth.vectors[1]];
            let steps = [0, 1].map(|j| sum(moved[j][2], truth.turned(sum(moved[j][0], moved[j][1]))));
            truth.vectors[0] = sum(sum(first, second.map(|x| x.scale(c))), steps[0]);
            truth.vectors[1] = sum(second, steps[1]);
            truth.turn(&[point(turn), alpha.map(|x| Interval::point(if step % 2 == 0 { x.hi() } else { x.lo() }))]);
            filter.predict(&told).unwrap();
            truth.radii(&filter);
            let bound = unit * [1e-6, 0.1, 10.0][random.below(3)];
            let arm = core::array::from_fn(|_| unit * random.unit());
            let measurement = match random.below(3) {
                0 => truth.place(random.below(2), arm, bound),
                1 => truth.landmark(core::array::from_fn(|_| unit * random.unit()), arm, bound),
                _ => truth.direction(core::array::from_fn(|_| unit * random.unit()), bound),
            };
            filter.update(&[measurement]).unwrap_or_else(|error| panic!("seed {seed} step {step}: {error}"));
            truth.radii(&filter);
        }
    }
}

/// Refused input says what is wrong, and changes nothing.
#[test]
fn bad_input_is_refused() {
    let one = SO3::identity();
    let new = |turn: Region, vectors: &[Region]| {
        SpatialStrips::new(&SpatialBox::new(one, turn, vectors), StripsOptions::pose())
    };
    assert!(matches!(new(ball(1.0), &[]), Err(EstimatorError::Size { expected: 1, found: 0, .. })));
    assert!(matches!(
        new([Interval::EMPTY; 3], &[ball(1.0)]),
        Err(EstimatorError::EmptyRange { what: "attitude", index: 0 })
    ));
    assert!(matches!(new(ball(1.0), &[[Interval::ENTIRE; 3]]), Err(EstimatorError::NotFinite { .. })));
    let mut filter = new(ball(0.1), &[ball(1.0)]).unwrap();
    let before = format!("{:?}", (filter.enclosure(), filter.num_rows(), filter.step_count()));
    let zero = [Interval::ZERO; 3];
    let good = SpatialMeasurement::vector([0.0; 3], ball(1.0));
    assert!(matches!(
        filter.update(&[good, good.of_vector(1)]),
        Err(EstimatorError::Size { expected: 1, found: 2, .. })
    ));
    assert!(matches!(
        filter.update(&[good.with_arm([f64::NAN, 0.0, 0.0])]),
        Err(EstimatorError::NotFinite { what: "arm", .. })
    ));
    assert!(filter.update(&[SpatialMeasurement::vector([f64::NAN; 3], ball(1.0))]).is_err());
    assert!(filter.update(&[SpatialMeasurement::direction(zero, [0.0; 3], [Interval::EMPTY; 3])]).is_err());
    let step = |turn: [f64; 3], noise: Region| SpatialIncrement::odometry(turn, zero, noise, zero);
    assert!(filter.predict(&step([f64::INFINITY; 3], zero)).is_err());
    assert!(filter.predict(&step([0.0; 3], [Interval::ENTIRE; 3])).is_err());
    assert!(filter.predict(&step([0.0; 3], [Interval::EMPTY; 3])).is_err());
    assert!(filter.predict(&step([0.0; 3], zero).with_vector(zero, zero)).is_err());
    let huge = [Interval::point(1e308); 3];
    assert!(filter.predict(&SpatialIncrement::odometry([0.0; 3], huge, zero, huge)).is_err());
    assert!(
        step([0.0; 3], zero).with_coupling(0, 0, 1.0).is_err() && step([0.0; 3], zero).with_drift(1, zero).is_err()
    );
    assert!(SpatialIncrement::inertial([f64::NAN; 3], [0.0; 3], zero, zero, zero, 0.1).is_err());
    assert!(filter.excludes(&SpatialBox::new(one, zero, &[zero, zero])).is_err());
    assert_eq!(before, format!("{:?}", (filter.enclosure(), filter.num_rows(), filter.step_count())));
    filter.update(&[]).unwrap();
    filter.update(&[good]).unwrap();
    assert!(filter.includes(&SpatialBox::new(one, zero, &[zero])).unwrap());
}
