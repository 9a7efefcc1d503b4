//! Filter steps: paper 000's vehicle, counted in faer products of `3x3` by `3x33`; paper 002's robot, beside its extended Kalman filter.

use std::hint::black_box;

use estimators::kalman::Ekf;
use estimators::kalman::wheels::{PlainError, TwoFrameError, WheelError, WheelState, WheelStep, Wheels};
use estimators::{ErrorSide, Estimator, InZsmf, Left, Model, Outputs, Right, Zsmf};
use lie_groups::SE2;
use nalgebra::{Matrix2, Matrix2x3, Matrix3, Vector2, Vector3, Vector6};
use setrep::{Reduction, Zonotope};

use crate::sets::FaerProduct;
use crate::timing::Bench;

/// Sampling period in seconds.
const DT_S: f64 = 0.01;

/// The vehicle `(heading, x1, x2)` of paper 000, equation (14), as a user of the library writes it.
struct Vehicle;

impl Model<3, 2, 3> for Vehicle {
    type Input = Vector2<f64>;

    fn transition(&self, x: &Vector3<f64>, u: &Vector2<f64>) -> Vector3<f64> {
        let (sin, cos) = x[0].sin_cos();
        Vector3::new(x[0] + DT_S * u[0], x[1] + DT_S * u[1] * cos, x[2] + DT_S * u[1] * sin)
    }

    fn transition_jacobian(&self, x: &Vector3<f64>, u: &Vector2<f64>) -> Matrix3<f64> {
        let (sin, cos) = x[0].sin_cos();
        Matrix3::new(1.0, 0.0, 0.0, -sin * u[1] * DT_S, 1.0, 0.0, cos * u[1] * DT_S, 0.0, 1.0)
    }

    fn noise_jacobian(&self, x: &Vector3<f64>, _: &Vector2<f64>) -> Matrix3<f64> {
        let (sin, cos) = x[0].sin_cos();
        Matrix3::new(1.0, 0.0, 0.0, 0.0, cos, -sin, 0.0, sin, cos) * DT_S
    }

    fn output(&self, x: &Vector3<f64>) -> Vector2<f64> {
        Vector2::new(x[1], x[2])
    }

    fn output_jacobian(&self, _: &Vector3<f64>) -> Matrix2x3<f64> {
        Matrix2x3::new(0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
    }
}

/// The rows `step/*`: order 30, F-radius gain, Combastel's reduction; and one prediction and update with six states.
pub fn benches() -> Vec<Bench> {
    let wheels = Bench::new("step/tfg-iekf", "ekf", wheels::<TwoFrameError>(), wheels::<PlainError>());
    vec![euclidean(), invariant::<Left>("step/inzsmf"), invariant::<Right>("step/inzsmf-right"), wheels]
}

/// A prediction and an update of a Kalman filter of the robot with unknown wheels and antenna, which drives the circle of [`positions`].
fn wheels<C: WheelError>() -> impl FnMut() {
    let guess = WheelState::new(std::f64::consts::FRAC_PI_2, 1.0, Vector2::new(20.0, 0.0), Vector2::zeros());
    let (q, r) = (Matrix3::identity() * 1e-6, Matrix2::identity() * 0.01);
    let start = C::belief(guess, &Vector6::repeat(0.1)).expect("a finite state");
    let mut filter: Ekf<_, C, 6, 2, 3, 2> = Ekf::new(Wheels, start, &q, &r).expect("covariances");
    let (step, mut measured) = (WheelStep::new(0.004, Vector2::new(0.08, 0.0)), positions());
    move || {
        if let Some(y) = measured.next() {
            filter.predict(black_box(&step)).expect("finite increments");
            filter.update(&y).expect("a finite fix");
        }
    }
}

/// A step of the filter on the vector space.
fn euclidean() -> Bench {
    let mut filter = Zsmf::new(Vehicle, &ball(3, 1.0), &ball(3, 0.1), &ball(2, 1.0))
        .and_then(|filter| filter.with_reduction(Reduction::Combastel, 30))
        .expect("the sets have the sizes of the model");
    let mut product = FaerProduct::new(3, 33);
    let (input, mut measured) = (Vector2::new(0.4, 8.0), positions());
    let ours = move || {
        if let Some(y) = measured.next() {
            filter.step(black_box(&input), &y).expect("the filter converges");
        }
    };
    Bench::new("step/zsmf", "faer-product", ours, move || product.run())
}

/// A step of the invariant filter with either error.
fn invariant<Side: ErrorSide + 'static>(name: &'static str) -> Bench {
    let mut filter: InZsmf<SE2<f64>, 3, 2, Side> = InZsmf::new(
        SE2::from_pose(std::f64::consts::FRAC_PI_2, 20.0, 0.0),
        &ball(3, 1.0),
        Outputs::position(),
        &ball(3, 0.1 * DT_S),
        &ball(2, 1.0),
    )
    .and_then(|filter| filter.with_reduction(Reduction::Combastel, 30))
    .expect("the sets have the sizes of the group");
    let mut product = FaerProduct::new(3, 33);
    let (increment, mut measured) = (Vector3::new(0.4 * DT_S, 8.0 * DT_S, 0.0), positions());
    let ours = move || {
        if let Some(y) = measured.next() {
            filter.step(black_box(&increment), &y).expect("the filter converges");
        }
    };
    Bench::new(name, "faer-product", ours, move || product.run())
}

/// The box of one radius around 0.
fn ball(dim: usize, radius: f64) -> Zonotope {
    Zonotope::from_box(&vec![0.0; dim], &vec![radius; dim]).expect("a positive radius")
}

/// Measured positions on the circle of 20 m radius, one turn.
fn positions() -> impl Iterator<Item = [f64; 2]> + 'static {
    let turn: Vec<[f64; 2]> = (1..=1571)
        .map(|k| {
            let (sin, cos) = (0.004 * f64::from(k)).sin_cos();
            [20.0 * cos, 20.0 * sin]
        })
        .collect();
    (0..).map(move |k| turn[k % turn.len()])
}
