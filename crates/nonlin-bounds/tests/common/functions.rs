//! Twelve functions with a box each on which they are smooth: models of the papers, every elementary function, many variables.

use nonlin_bounds::Function;
use scalars::Scalar;

/// A function's box `center +- radius`, and its parameters.
#[derive(Debug, Clone)]
pub(crate) struct Domain {
    pub(crate) name: &'static str,
    pub(crate) center: Vec<f64>,
    pub(crate) radius: Vec<f64>,
    pub(crate) parameters: Vec<f64>,
}

/// What is done with each of the twelve.
pub(crate) trait Visitor {
    fn visit<F: Function + 'static>(&mut self, function: F, domain: Domain);
}

/// Shows all twelve to a visitor.
pub(crate) fn each(visitor: &mut impl Visitor) {
    let domain = |name, center: &[f64], radius: &[f64], parameters: &[f64]| Domain {
        name,
        center: center.to_vec(),
        radius: radius.to_vec(),
        parameters: parameters.to_vec(),
    };
    visitor.visit(PlanarMap, domain("planar map", &[5.0, 0.5], &[2.0, 2.0], &[]));
    visitor.visit(PlanarOutput, domain("planar output", &[5.0, 0.5], &[3.0, 3.0], &[]));
    visitor.visit(
        Attitude,
        domain(
            "attitude",
            &[0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            &[0.5, 0.5, 0.5, 0.5, 0.1, 0.1, 0.1],
            &[0.3, -0.1, 0.05],
        ),
    );
    visitor.visit(AttitudeOutput, domain("attitude output", &[0.0, 1.0, 0.0, 0.0], &[1.0; 4], &[]));
    visitor.visit(UnitNorm { dim: 4 }, domain("unit norm", &[0.0, 1.0, 0.0, 0.0], &[1.0; 4], &[]));
    visitor.visit(
        Unicycle,
        domain("unicycle", &[0.1, 0.2, 1.0, -0.01, -0.01, -0.02], &[0.5, 0.5, 3.0, 0.05, 0.03, 0.06], &[0.3, 0.15]),
    );
    visitor.visit(Landmarks, domain("landmarks", &[0.1, 0.2, 1.0], &[3.0, 3.0, 2.0], &[5.0, 15.0, 15.0, 15.0]));
    visitor.visit(Reactor, domain("reactor", &[2.5, 1.5], &[1.2, 1.2], &[]));
    visitor.visit(Vehicle, domain("vehicle", &[5.0, 5.0, 10.0, 8.0], &[3.0, 3.0, 4.0, 4.0], &[0.5]));
    visitor.visit(RangeBearing, domain("range and bearing", &[-5.0, 4.0], &[4.0, 3.5], &[]));
    visitor.visit(Elementary, domain("elementary functions", &[0.5, 0.3], &[0.4, 0.6], &[]));
    visitor.visit(Coupled { dim: 12 }, domain("coupled", &[0.5; 12], &[1.0; 12], &[]));
}

/// The planar system (13) of paper 004, (15) of paper 003.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PlanarMap;

impl Function for PlanarMap {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let quotient = x[0] * x[1] / x[0].add_f64(4.0);
        y[0] = x[0].scale(3.0) - x[0].sqr() * S::ratio(1, 7) - quotient.scale(4.0);
        y[1] = quotient.scale(3.0) - x[1].scale(2.0);
    }
}

/// The measurement (17) of paper 003, without noise.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PlanarOutput;

impl Function for PlanarOutput {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0] - x[1].scale(0.5).sin();
        y[1] = x[1] - x[0] * x[1];
    }
}

/// The attitude model (19) of paper 003: variables `(x, w)`, quaternion and noise of the rates; parameters `u`, the measured rates.
///
/// `cos p` and `sin p / p` are Stumpff functions of `p^2`, smooth across a rate of zero.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Attitude;

impl Function for Attitude {
    const VARIABLES: Option<usize> = Some(7);
    fn parameters(&self) -> usize {
        3
    }
    fn outputs(&self) -> usize {
        4
    }
    fn eval<S: Scalar>(&self, z: &[S], u: &[S], y: &mut [S]) {
        let half_step = S::ratio(1, 10);
        let x = [z[0], z[1], z[2], z[3]];
        // Half the angle turned about each axis.
        let [a, b, c] = [0, 1, 2].map(|i| (u[i] - z[4 + i]) * half_step);
        let s = a.sqr() + b.sqr() + c.sqr();
        let (cos, sinc) = (s.stumpff(0), s.stumpff(1));
        y[0] = cos * x[0] - sinc * (c * x[1] - b * x[2] + a * x[3]);
        y[1] = cos * x[1] - sinc * (a * x[2] - c * x[0] + b * x[3]);
        y[2] = cos * x[2] - sinc * (b * x[0] - a * x[1] + c * x[3]);
        y[3] = cos * x[3] + sinc * (a * x[0] + b * x[1] + c * x[2]);
    }
}

/// The six outputs `(C(x) e1, C(x) e2)` of paper 003, section 5.2.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AttitudeOutput;

impl Function for AttitudeOutput {
    const VARIABLES: Option<usize> = Some(4);
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
    }
}

/// The invariant `|x|^2 - 1` of paper 003.
#[derive(Debug, Clone, Copy)]
pub(crate) struct UnitNorm {
    pub(crate) dim: usize,
}

impl Function for UnitNorm {
    fn variables(&self) -> usize {
        self.dim
    }
    fn outputs(&self) -> usize {
        1
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x.iter().fold(S::from_f64(-1.0), |sum, x| sum + x.sqr());
    }
}

/// The unicycle (14) of paper 004: variables `(s_x, s_y, theta, w)`, parameters the two speeds, step 1.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Unicycle;

impl Function for Unicycle {
    const VARIABLES: Option<usize> = Some(6);
    fn parameters(&self) -> usize {
        2
    }
    fn outputs(&self) -> usize {
        3
    }
    fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
        let (sin, cos) = x[2].sin_cos();
        y[0] = x[0] + p[0] * cos + x[3];
        y[1] = x[1] + p[0] * sin + x[4];
        y[2] = x[2] + p[1] + x[5];
    }
}

/// Distances and angles of two landmarks, the measurement of (14) of paper 004; parameters their coordinates.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Landmarks;

impl Function for Landmarks {
    const VARIABLES: Option<usize> = Some(3);
    fn parameters(&self) -> usize {
        4
    }
    fn outputs(&self) -> usize {
        4
    }
    fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
        for i in 0..2 {
            let (dx, dy) = (p[2 * i] - x[0], p[2 * i + 1] - x[1]);
            y[2 * i] = (dx.sqr() + dy.sqr()).sqrt();
            y[2 * i + 1] = x[2] - (dy / dx).atan();
        }
    }
}

/// The batch reactor (45) of paper 001, a vector field, in 1/min.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reactor;

impl Function for Reactor {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let rate = S::decimal("0.16") * x[0].sqr() - S::decimal("0.0064") * x[1];
        y[0] = rate.scale(-2.0);
        y[1] = rate;
    }
}

/// The vehicle (48) of paper 001 without noise; parameter the step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Vehicle;

impl Function for Vehicle {
    const VARIABLES: Option<usize> = Some(4);
    fn parameters(&self) -> usize {
        1
    }
    fn outputs(&self) -> usize {
        4
    }
    fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
        let normalization = (x[2].sqr() + x[3].sqr()).sqrt().recip().scale(15.0);
        y[0] = x[0] + p[0] * x[2];
        y[1] = x[1] + p[0] * x[3];
        y[2] = x[2] * normalization;
        y[3] = x[3] * normalization;
    }
}

/// Range and bearing, (51) of paper 001 with the angle in all four quadrants.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RangeBearing;

impl Function for RangeBearing {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = (x[0].sqr() + x[1].sqr()).sqrt();
        y[1] = x[1].atan2(x[0]);
    }
}

/// Every elementary function, of arguments that mix both variables; `0 < x < 1`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Elementary;

impl Function for Elementary {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        19
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        // In (0, 1) and around zero, with nonzero second derivatives.
        let unit = x[0] * (x[1].scale(0.25).add_f64(0.75)).sqr();
        let near = x[0] * x[1] - x[1].scale(0.5);
        let far = x[0].add_f64(2.0) * x[1].exp();
        y[0] = near.exp();
        y[1] = unit.ln();
        y[2] = near.sin();
        y[3] = near.cos();
        y[4] = near.tan();
        y[5] = unit.asin();
        y[6] = unit.acos();
        y[7] = near.atan();
        y[8] = near.sinh();
        y[9] = near.cosh();
        y[10] = near.tanh();
        y[11] = unit.sqrt();
        y[12] = far.recip();
        y[13] = far.powi(-3) + near.powi(5);
        y[14] = near.stumpff(2) + far.stumpff(0);
        y[15] = near.stumpff(3) * unit.stumpff(1);
        y[16] = near.atan2(far) + far.atan2(near);
        y[17] = near / far + S::pi() / far;
        y[18] = far.abs() * (-far).abs() + near.min(far) - unit.max(far);
    }
}

/// A chain of `dim` variables with products of neighbours and one coupling of all.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Coupled {
    pub(crate) dim: usize,
}

impl Function for Coupled {
    fn variables(&self) -> usize {
        self.dim
    }
    fn outputs(&self) -> usize {
        3
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let zero = S::zero();
        y[0] = x.windows(2).fold(zero, |sum, pair| sum + pair[0] * pair[1].sqr());
        y[1] = x.iter().enumerate().fold(zero, |sum, (i, &x)| sum + x.scale(i as f64)).sin();
        y[2] = x[0] * x[self.dim - 1] + x[self.dim / 2].powi(3);
    }
}
