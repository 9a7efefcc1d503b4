//! The functions of the tightness tables, with boxes in which the sets are drawn.

use nonlin_bounds::{DynFunction, Function};
use rand::{Rng, RngExt};
use scalars::Scalar;

use super::models::Planar;

/// A function drawn from a family, and the box in which sets are placed.
pub struct Drawn {
    /// The function, without parameters.
    pub function: Box<dyn DynFunction + Send + Sync>,
    /// Middle of the box.
    pub center: Vec<f64>,
    /// Lengths by which the sets are scaled.
    pub scale: Vec<f64>,
}

/// A family of functions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// (15) of paper 003, `R^2 -> R^2`.
    Planar,
    /// Random quadratic functions `R^3 -> R^2`.
    Quadratic,
    /// A unicycle that drives one length, `R^3 -> R^3`.
    Unicycle,
    /// Range and bearing, `R^2 -> R^2`.
    RangeBearing,
    /// The measurement (17) of paper 003, `R^2 -> R^2`.
    PlanarOutput,
    /// The squared length of a vector of unit length, `R^3 -> R`.
    UnitNorm,
}

impl Family {
    /// Those whose images are enclosed.
    pub const IMAGES: [Self; 4] = [Self::Planar, Self::Quadratic, Self::Unicycle, Self::RangeBearing];
    /// Those whose solutions are enclosed.
    pub const SOLUTIONS: [Self; 3] = [Self::PlanarOutput, Self::RangeBearing, Self::UnitNorm];

    /// The name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Planar => "planar map",
            Self::Quadratic => "quadratic",
            Self::Unicycle => "unicycle",
            Self::RangeBearing => "range and bearing",
            Self::PlanarOutput => "planar output",
            Self::UnitNorm => "unit norm",
        }
    }

    /// A member of the family.
    pub fn draw(self, rng: &mut impl Rng) -> Drawn {
        let mut around = |middle: f64, spread: f64| middle + spread * (2.0 * rng.random::<f64>() - 1.0);
        let (center, scale) = match self {
            Self::Planar | Self::PlanarOutput => (vec![around(3.0, 2.0), around(0.5, 1.0)], vec![1.0, 1.0]),
            Self::Quadratic => (vec![around(0.0, 1.0), around(0.0, 1.0), around(0.0, 1.0)], vec![1.0; 3]),
            Self::Unicycle => (vec![0.0, 0.0, around(0.0, 3.0)], vec![0.3, 0.3, 1.0]),
            Self::RangeBearing => {
                let (sin, cos) = around(0.0, 1.2).sin_cos();
                (vec![2.0 * cos, 2.0 * sin], vec![1.0, 1.0])
            }
            Self::UnitNorm => {
                let direction = [around(0.0, 1.0), around(0.0, 1.0), around(0.0, 1.0)];
                let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt().max(0.1);
                (direction.iter().map(|x| x / length).collect(), vec![0.5; 3])
            }
        };
        let function: Box<dyn DynFunction + Send + Sync> = match self {
            Self::Planar => Box::new(Planar),
            Self::Quadratic => Box::new(Quadratic { coefficients: (0..20).map(|_| around(0.0, 1.0)).collect() }),
            Self::Unicycle => Box::new(Unicycle),
            Self::RangeBearing => Box::new(RangeBearing),
            Self::PlanarOutput => Box::new(PlanarOutput),
            Self::UnitNorm => Box::new(UnitNorm),
        };
        Drawn { function, center, scale }
    }
}

/// `R^3 -> R^2`, each output with ten coefficients.
struct Quadratic {
    coefficients: Vec<f64>,
}

impl Function for Quadratic {
    const VARIABLES: Option<usize> = Some(3);

    fn outputs(&self) -> usize {
        2
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        for (y, c) in y.iter_mut().zip(self.coefficients.chunks_exact(10)) {
            *y = S::from_f64(c[0]);
            for k in 0..3 {
                *y += x[k].scale(c[1 + k]) + x[k].sqr().scale(c[4 + k]) + (x[k] * x[(k + 1) % 3]).scale(c[7 + k]);
            }
        }
    }
}

struct Unicycle;

impl Function for Unicycle {
    const VARIABLES: Option<usize> = Some(3);

    fn outputs(&self) -> usize {
        3
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let (sin, cos) = x[2].sin_cos();
        y[0] = x[0] + cos;
        y[1] = x[1] + sin;
        y[2] = x[2].add_f64(0.25);
    }
}

struct RangeBearing;

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

struct PlanarOutput;

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

struct UnitNorm;

impl Function for UnitNorm {
    const VARIABLES: Option<usize> = Some(3);

    fn outputs(&self) -> usize {
        1
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0].sqr() + x[1].sqr() + x[2].sqr();
    }
}
