//! The two examples of paper 003, section 5, and simulated runs of them.

use estimators::{Relation, System};
use nonlin_bounds::Function;
use scalars::{Interval, Scalar};
use setrep::{ConstrainedZonotope, Matrix, Zonotope};

use crate::support::Random;

/// Example 5.1, equation (15) with additive noise: variables `(x, w)`. With `x_1 x_2 / (x_1 + 4) = x_2 - 4 x_2 / (x_1 + 4)` every variable
/// occurs once in an entry of the Jacobian, which is then as narrow as it can be; the mean value extension needs that.
pub(crate) struct PlanarStep;

impl Function for PlanarStep {
    const VARIABLES: Option<usize> = Some(4);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let quotient = x[1] * x[0].add_f64(4.0).recip();
        y[0] = x[0].scale(3.0) - x[0].sqr() * S::ratio(1, 7) - x[1].scale(4.0) + quotient.scale(16.0) + x[2];
        y[1] = x[1] - quotient.scale(12.0) + x[3];
    }
}

/// Its measurement (17): variables `(x, v)`.
pub(crate) struct PlanarOutput;

impl Function for PlanarOutput {
    const VARIABLES: Option<usize> = Some(4);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0] - x[1].scale(0.5).sin() + x[2];
        y[1] = x[1] - x[0] * x[1] + x[3];
    }
}

/// Example 5.2, equation (19): variables `(x, w)`, parameters the measured rates. Stumpff functions of the squared half angle.
pub(crate) struct AttitudeStep;

impl Function for AttitudeStep {
    const VARIABLES: Option<usize> = Some(7);
    fn parameters(&self) -> usize {
        3
    }
    fn outputs(&self) -> usize {
        4
    }
    fn eval<S: Scalar>(&self, x: &[S], u: &[S], y: &mut [S]) {
        let [a, b, c] = [0, 1, 2].map(|i| (u[i] - x[4 + i]) * S::ratio(1, 10));
        let s = a.sqr() + b.sqr() + c.sqr();
        let (cos, sinc) = (s.stumpff(0), s.stumpff(1));
        y[0] = cos * x[0] - sinc * (c * x[1] - b * x[2] + a * x[3]);
        y[1] = cos * x[1] - sinc * (a * x[2] - c * x[0] + b * x[3]);
        y[2] = cos * x[2] - sinc * (b * x[0] - a * x[1] + c * x[3]);
        y[3] = cos * x[3] + sinc * (a * x[0] + b * x[1] + c * x[2]);
    }
}

/// Its six measurements: variables `(x, v)`.
pub(crate) struct AttitudeOutput;

impl Function for AttitudeOutput {
    const VARIABLES: Option<usize> = Some(10);
    fn outputs(&self) -> usize {
        6
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| x[i].sqr());
        y[0] = a - b - c + d;
        y[1] = (x[0] * x[1] - x[2] * x[3]).scale(2.0);
        y[2] = (x[0] * x[2] + x[1] * x[3]).scale(2.0);
        y[3] = (x[0] * x[1] + x[2] * x[3]).scale(2.0);
        y[4] = b - a - c + d;
        y[5] = (x[1] * x[2] - x[0] * x[3]).scale(2.0);
        for i in 0..6 {
            y[i] += x[4 + i];
        }
    }
}

/// Its invariant `|x|^2`.
pub(crate) struct SquaredNorm;

impl Function for SquaredNorm {
    const VARIABLES: Option<usize> = Some(4);
    fn outputs(&self) -> usize {
        1
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x.iter().fold(S::zero(), |sum, x| sum + x.sqr());
    }
}

pub(crate) fn cube(n: usize, radius: f64) -> Zonotope {
    Zonotope::from_box(&vec![0.0; n], &vec![radius; n]).unwrap()
}

pub(crate) fn planar() -> System {
    System::new(Relation::new(PlanarStep), cube(2, 0.4), Relation::new(PlanarOutput), cube(2, 0.4)).unwrap()
}

/// `X_0` of (18).
pub(crate) fn planar_start() -> ConstrainedZonotope {
    let generators = Matrix::from_rows(&[&[0.5, 1.0, -0.5], &[0.5, 0.5, 0.0]]).unwrap();
    Zonotope::new(&[5.0, 0.5], &generators).unwrap().into()
}

/// Example 5.2 with measurement noise up to `noise`.
pub(crate) fn attitude(noise: f64) -> System {
    let (step, output) = (Relation::new(AttitudeStep), Relation::new(AttitudeOutput));
    let system = System::new(step, cube(3, 3e-3), output, cube(6, noise)).unwrap();
    // The simulated quaternions are of length 1 up to rounding only.
    let one = Interval::ONE.inflate(1e-13);
    system.with_invariant(Relation::new(SquaredNorm), vec![one]).unwrap()
}

pub(crate) fn attitude_start() -> ConstrainedZonotope {
    let generators = Matrix::from_diagonal(&[0.18; 4]);
    Zonotope::new(&[0.0, 1.0, 0.0, 0.0], &generators).unwrap().into()
}

/// How a noise is drawn within its bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Draw {
    Uniform,
    /// At the bounds, with signs drawn at every step.
    Vertex,
    /// At the bounds, with the same signs at every step.
    Constant,
}

impl Draw {
    /// A number whose magnitude is proven to be at most `bound`, also after an addition has rounded to `1e-12` of it.
    pub(crate) fn noise(self, bound: f64, random: &mut Random) -> f64 {
        let bound = bound * (1.0 - 1e-12);
        match self {
            Self::Uniform => bound * random.unit(),
            Self::Vertex | Self::Constant => bound * random.sign(),
        }
    }

    /// Goes back to the first step's random numbers if the noise is constant.
    fn begin_step(self, random: &mut Random, first: &Random) {
        if self == Self::Constant {
            random.clone_from(first);
        }
    }
}

/// Evaluates a function in floating point.
pub(crate) fn value<F: Function>(function: &F, x: &[f64], p: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; function.outputs()];
    function.eval(x, p, &mut y);
    y
}

/// States and measurements of example 5.1, `k = 0..=steps`.
pub(crate) fn planar_run(draw: Draw, steps: usize, random: &mut Random) -> Vec<(Vec<f64>, Vec<f64>)> {
    let mut x = vec![5.2, 0.65];
    let mut run = Vec::new();
    let first = random.clone();
    for _ in 0..=steps {
        draw.begin_step(random, &first);
        let v = [draw.noise(0.4, random), draw.noise(0.4, random)];
        let y = value(&PlanarOutput, &[&x[..], &v].concat(), &[]);
        run.push((x.clone(), y));
        let w = [draw.noise(0.4, random), draw.noise(0.4, random)];
        x = value(&PlanarStep, &[&x[..], &w].concat(), &[]);
    }
    run
}

/// One step of an attitude run: state, measurement, the rates measured for the step that follows.
pub(crate) type AttitudeSample = (Vec<f64>, Vec<f64>, [f64; 3]);

/// States, measurements and inputs of example 5.2, `k = 0..=steps`.
pub(crate) fn attitude_run(noise: f64, draw: Draw, steps: usize, random: &mut Random) -> Vec<AttitudeSample> {
    let mut x = vec![0.0, 1.0, 0.0, 0.0];
    let mut run = Vec::new();
    let first = random.clone();
    for k in 0..=steps {
        draw.begin_step(random, &first);
        let v: Vec<f64> = (0..6).map(|_| draw.noise(noise, random)).collect();
        let y = value(&AttitudeOutput, &[&x[..], &v].concat(), &[]);
        let w: Vec<f64> = (0..3).map(|_| draw.noise(3e-3, random)).collect();
        let phase = core::f64::consts::TAU / 12.0 * 0.2 * (k + 1) as f64;
        let rates = [0.0, 6.0, 12.0].map(|shift| 0.3 * (phase - shift).sin());
        let u = [rates[0] + w[0], rates[1] + w[1], rates[2] + w[2]];
        run.push((x.clone(), y, u));
        x = value(&AttitudeStep, &[&x[..], &w].concat(), &u);
    }
    run
}

/// Half the longest side.
pub(crate) fn radius(hull: &[Interval]) -> f64 {
    hull.iter().map(Interval::rad).fold(0.0, f64::max)
}
