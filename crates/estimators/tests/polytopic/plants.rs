//! The two examples of paper 004, and simulated runs of them.

use estimators::{CombMember, DCz, DCzOptions, DZb, DZbOptions, EstimatorError, Relation, System, Vh, VhOptions};
use nonlin_bounds::Function;
use scalars::{Interval, Scalar};
use setrep::{ConstrainedZonotope, Matrix, VPolytope, Zonotope};

use crate::support::Random;

/// Example I, equation (13): variables `(x, w)`, each variable nearly once.
pub(crate) struct Planar;

impl Function for Planar {
    const VARIABLES: Option<usize> = Some(4);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let share = x[1] / x[0].add_f64(4.0);
        y[0] = x[0].scale(3.0) - x[0].sqr() * S::ratio(1, 7) - x[1].scale(4.0) + share.scale(16.0) + x[2];
        y[1] = x[1] - share.scale(12.0) + x[3];
    }
}

/// Its outputs: variables `(x, v)`.
pub(crate) struct PlanarOutput;

impl Function for PlanarOutput {
    const VARIABLES: Option<usize> = Some(4);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0] + x[2];
        y[1] = x[1] - x[0] + x[3];
    }
}

/// Example II, equation (14): variables `(x, w)`, the noises about zero.
pub(crate) struct Unicycle;

impl Function for Unicycle {
    const VARIABLES: Option<usize> = Some(6);
    fn outputs(&self) -> usize {
        3
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let (sin, cos) = x[2].sin_cos();
        y[0] = x[0] + S::decimal("0.3") * cos + x[3];
        y[1] = x[1] + S::decimal("0.3") * sin + x[4];
        y[2] = x[2] + S::decimal("0.15") + x[5];
    }
}

/// Its outputs, distances and bearings of two landmarks: variables `(x, v)`.
pub(crate) struct UnicycleOutput;

impl Function for UnicycleOutput {
    const VARIABLES: Option<usize> = Some(7);
    fn outputs(&self) -> usize {
        4
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        for (i, east) in [5.0, 15.0].into_iter().enumerate() {
            let (dx, dy) = (S::from_f64(east) - x[0], S::from_f64(15.0) - x[1]);
            y[2 * i] = (dx.sqr() + dy.sqr()).sqrt() + x[3 + 2 * i];
            y[2 * i + 1] = x[2] - (dy / dx).atan() + x[4 + 2 * i];
        }
    }
}

/// A system with its first set, a first state, and bounds of the noises.
pub(crate) struct Example {
    pub(crate) system: System,
    pub(crate) start: Zonotope,
    pub(crate) state: Vec<f64>,
    pub(crate) process: Vec<f64>,
    pub(crate) output: Vec<f64>,
    dynamics: fn(&[Interval], &mut [Interval]),
    measurement: fn(&[Interval], &mut [Interval]),
}

fn around_zero(radii: &[f64]) -> Zonotope {
    Zonotope::from_box(&vec![0.0; radii.len()], radii).unwrap()
}

/// Example I with the generators of `X_0` scaled.
pub(crate) fn planar(scale: f64) -> Example {
    let (process, output) = (vec![0.1; 2], vec![0.4; 2]);
    let generators = Matrix::from_rows(&[&[0.1, 0.2, -0.1], &[0.1, 0.1, 0.0]]).unwrap();
    let scaled: Vec<f64> = generators.as_slice().iter().map(|g| g * scale).collect();
    Example {
        system: System::new(
            Relation::new(Planar),
            around_zero(&process),
            Relation::new(PlanarOutput),
            around_zero(&output),
        )
        .unwrap(),
        start: Zonotope::new(&[0.5, 0.5], &Matrix::from_column_slice(2, 3, &scaled).unwrap()).unwrap(),
        state: vec![0.8, 0.65],
        process,
        output,
        dynamics: |x, y| Planar.eval(x, &[], y),
        measurement: |x, y| PlanarOutput.eval(x, &[], y),
    }
}

/// Example II with half-widths of `X_0` scaled; `process` scales the process noise.
pub(crate) fn unicycle(scale: f64, process: f64) -> Example {
    let (process, output) = (vec![0.05 * process, 0.03 * process, 0.06 * process], vec![0.01, 0.015, 0.015, 0.025]);
    Example {
        system: System::new(
            Relation::new(Unicycle),
            around_zero(&process),
            Relation::new(UnicycleOutput),
            around_zero(&output),
        )
        .unwrap(),
        start: Zonotope::from_box(&[0.1, 0.2, 1.0], &[0.01 * scale, 0.02 * scale, 0.2 * scale]).unwrap(),
        state: vec![0.1, 0.2, 1.0],
        process,
        output,
        dynamics: |x, y| Unicycle.eval(x, &[], y),
        measurement: |x, y| UnicycleOutput.eval(x, &[], y),
    }
}

/// How a noise is drawn within its bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Draw {
    Uniform,
    Vertex,
}

impl Draw {
    /// Floats near `values + noise`, and a proof that they differ from the values by no more than the bounds.
    fn noisy(self, values: &[Interval], bounds: &[f64], random: &mut Random) -> Vec<f64> {
        let draw = |(value, &bound): (&Interval, &f64)| {
            let noise = (bound - 1e-13) * if self == Self::Uniform { random.unit() } else { random.sign() };
            let drawn = value.mid() + noise;
            assert!((Interval::point(drawn) - *value).mag() <= bound);
            drawn
        };
        values.iter().zip(bounds).map(draw).collect()
    }
}

impl Example {
    /// Enclosures of the states of one exact trajectory, and measurements, `k = 0 ..= steps`. With process noise the states are floats: the noise
    /// that leads from one to the next is proven to keep its bounds.
    pub(crate) fn run(&self, draw: Draw, steps: usize, random: &mut Random) -> Vec<(Vec<Interval>, Vec<f64>)> {
        let without_noise = |f: fn(&[Interval], &mut [Interval]), x: &[Interval], outputs: usize| {
            let mut y = vec![Interval::ZERO; outputs];
            f(&[x, &vec![Interval::ZERO; outputs]].concat(), &mut y);
            y
        };
        let mut x: Vec<Interval> = self.state.iter().map(|&x| Interval::point(x)).collect();
        let mut run = Vec::new();
        for _ in 0..=steps {
            let y = draw.noisy(&without_noise(self.measurement, &x, self.output.len()), &self.output, random);
            let mut next = without_noise(self.dynamics, &x, x.len());
            if self.process.iter().any(|&bound| bound > 0.0) {
                next = draw.noisy(&next, &self.process, random).into_iter().map(Interval::point).collect();
            }
            run.push((core::mem::replace(&mut x, next), y));
        }
        run
    }

    pub(crate) fn vertices(&self) -> VPolytope {
        self.start.to_v_polytope().unwrap().thinned(1e-12)
    }

    pub(crate) fn vh(&self, options: VhOptions) -> Vh {
        Vh::new(self.system.clone(), self.vertices(), options).unwrap()
    }

    pub(crate) fn d_cz(&self) -> DCz {
        let set: ConstrainedZonotope = self.start.clone().into();
        DCz::new(self.system.clone(), set, DCzOptions::new(self.state.len())).unwrap()
    }

    pub(crate) fn d_zb(&self) -> DZb {
        DZb::new(self.system.clone(), self.start.clone().into(), DZbOptions::new(self.state.len())).unwrap()
    }

    /// All filters of the polytopic module, by name.
    pub(crate) fn filters(&self) -> Vec<(&'static str, Box<dyn CombMember>)> {
        vec![
            ("vh", Box::new(self.vh(VhOptions::paper()))),
            ("vh/tight", Box::new(self.vh(VhOptions::tight()))),
            ("d-cz", Box::new(self.d_cz())),
            ("d-zb", Box::new(self.d_zb())),
        ]
    }
}

/// Whether the error is a proven contradiction that verifies.
pub(crate) fn is_proof(error: &EstimatorError) -> bool {
    matches!(error, EstimatorError::Inconsistent(found) if found.verify() && found.margin() > 0.0)
}
