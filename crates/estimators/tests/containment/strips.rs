//! The filter of strips holds an enclosure of an exact trajectory whose noises keep their bounds, down to the vertices of these.

use estimators::{
    Estimator, InvariantStrips, PlanarBox, PlanarIncrement, PlanarMeasurement, StripsOptions,
};
use scalars::Interval;

use crate::support::Random;

/// Bound of each odometry noise, per step; of each measurement noise.
const ODOMETRY: f64 = 1e-3;
const RECEIVER: f64 = 1.0;

/// How the noises are drawn, the measurement noises moved inward by `1e-12`.
#[derive(Clone, Copy, Debug)]
enum Noise {
    Uniform,
    Vertices,
    /// One of the 32 vertices of both boxes, bit by bit.
    Constant(usize),
    /// A vertex for some 33 steps, then another.
    Dwelling,
}

/// An interval enclosure of an exact trajectory of paper 000's vehicle, (18).
struct Truth {
    heading: Interval,
    position: [Interval; 2],
    noise: Noise,
    /// By how much the bounds are broken.
    factor: f64,
    random: Random,
    held: [f64; 5],
}

fn complex(a: [Interval; 2], b: [Interval; 2]) -> [Interval; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

fn unit(angle: Interval) -> [Interval; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos, sin]
}

/// `V(i a) = C_1(a^2) + i a C_2(a^2)`.
fn mean_turn(a: Interval) -> [Interval; 2] {
    [a.sqr().stumpff(1), a * a.sqr().stumpff(2)]
}

impl Truth {
    fn new(noise: Noise, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let held = [0; 5].map(|_| random.sign());
        let zero = Interval::ZERO;
        Self { heading: Interval::FRAC_PI_2, position: [zero, zero], noise, factor: 1.0, random, held }
    }

    /// Turn, forward, left, and the two of the receiver, in units of their bounds.
    fn draw(&mut self) -> [f64; 5] {
        let random = &mut self.random;
        match self.noise {
            Noise::Uniform => [0; 5].map(|_| random.unit()),
            Noise::Vertices => [0; 5].map(|_| random.sign()),
            Noise::Constant(vertex) => core::array::from_fn(|k| if vertex >> k & 1 == 0 { 1.0 } else { -1.0 }),
            Noise::Dwelling => {
                if random.below(33) == 0 {
                    self.held = [0; 5].map(|_| random.sign());
                }
                self.held
            }
        }
    }

    /// The step, and the measurement after it.
    fn advance(&mut self) -> [f64; 2] {
        let drawn = self.draw().map(|w| w * self.factor);
        let [alpha, forward, left] = [drawn[0], drawn[1], drawn[2]].map(|w| Interval::point(w * ODOMETRY));
        let turn = Interval::point(0.004);
        let straight = complex(mean_turn(turn), [Interval::point(0.08), Interval::ZERO]);
        let slip = complex(unit(turn), complex(mean_turn(alpha), [forward, left]));
        let moved = complex(unit(self.heading), [straight[0] + slip[0], straight[1] + slip[1]]);
        self.heading += turn + alpha;
        self.position = [self.position[0] + moved[0], self.position[1] + moved[1]];
        [0, 1].map(|k| {
            let y = self.position[k].mid() + drawn[3 + k] * (RECEIVER - self.position[k].rad() - 1e-14);
            let noise = Interval::point(y) - self.position[k];
            assert!(self.factor > 1.0 || noise.mag() <= RECEIVER, "the measurement keeps its bound");
            y
        })
    }

    fn state(&self) -> PlanarBox {
        PlanarBox::se2(self.heading, self.position)
    }
}

fn symmetric(radius: f64) -> Interval {
    Interval::new(-radius, radius).unwrap()
}

fn odometry() -> PlanarIncrement {
    PlanarIncrement::exponential([0.004, 0.08, 0.0].map(Interval::point), [symmetric(ODOMETRY); 3])
}

fn receiver(y: [f64; 2]) -> PlanarMeasurement {
    PlanarMeasurement::position(y, [symmetric(RECEIVER); 2])
}

fn unknown_heading(options: StripsOptions) -> InvariantStrips {
    InvariantStrips::new(&PlanarBox::se2(Interval::ENTIRE, [symmetric(5.3); 2]), options).unwrap()
}

/// Means over a run.
#[derive(Debug, Default)]
struct Means {
    heading: f64,
    area: f64,
    late_heading: f64,
    late_area: f64,
    rows: usize,
    programs: f64,
}

/// A run of the filter against the truth contract.
fn run(filter: &mut InvariantStrips, truth: &mut Truth, steps: usize) -> Means {
    let step = odometry();
    let mut means = Means::default();
    for k in 1..=steps {
        let y = truth.advance();
        filter.predict(&step).unwrap();
        assert!(!filter.excludes(&truth.state()).unwrap(), "step {k}, predicted");
        filter.update(&[receiver(y)]).unwrap_or_else(|error| panic!("step {k}: {error}"));
        assert!(!filter.excludes(&truth.state()).unwrap(), "step {k}");
        let set = filter.enclosure();
        let (heading, area) = (set.heading_width_rad(), set.position_area());
        means.heading += heading / steps as f64;
        means.area += area / steps as f64;
        if k > 200 {
            means.late_heading += heading / (steps - 200) as f64;
            means.late_area += area / (steps - 200) as f64;
        }
        means.rows = means.rows.max(filter.num_rows());
        means.programs += filter.programs() as f64 / steps as f64;
    }
    means
}

#[test]
fn explore() {
    for seed in 1..4 {
        let means = run(&mut unknown_heading(StripsOptions::pose()), &mut Truth::new(Noise::Uniform, seed), 1571);
        println!("uniform {seed} {means:.3?}");
        let means = run(&mut unknown_heading(StripsOptions::pose()), &mut Truth::new(Noise::Vertices, seed), 1571);
        println!("vertices {seed} {means:.3?}");
        let means = run(&mut unknown_heading(StripsOptions::pose()), &mut Truth::new(Noise::Constant(seed as usize * 7), seed), 1571);
        println!("constant {seed} {means:.3?}");
        let means = run(&mut unknown_heading(StripsOptions::pose()), &mut Truth::new(Noise::Dwelling, seed), 1571);
        println!("dwelling {seed} {means:.3?}");
    }
    let mut truth = Truth::new(Noise::Uniform, 1);
    let ys: Vec<_> = (0..1571).map(|_| truth.advance()).collect();
    for options in [StripsOptions::pose(), StripsOptions::fast_pose()] {
        let mut filter = unknown_heading(options);
        let step = odometry();
        let mut times = [std::time::Duration::ZERO; 2];
        for y in ys.iter() {
            let time = std::time::Instant::now();
            filter.predict(&step).unwrap();
            times[0] += time.elapsed();
            let time = std::time::Instant::now();
            filter.update(&[receiver(*y)]).unwrap();
            times[1] += time.elapsed();
        }
        println!("{:?} a step", times.map(|t| t / 1571));
    }
}
