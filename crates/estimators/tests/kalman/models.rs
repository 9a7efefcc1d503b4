//! The models of these tests.

use estimators::kalman::{ByFunction, LinearModel, Motion, OnGroup, Sensor, SmoothMotion, SmoothSensor};
use estimators::{ErrorSide, Left};
use lie_groups::{LieGroup, SE2};
use nalgebra::{Matrix2, Matrix2x3, Matrix3, SMatrix, Vector2, Vector3};
use nonlin_bounds::{Function, function};

/// A random stable linear model, observable for all practical purposes.
pub(crate) fn linear(random: &mut crate::support::Random) -> LinearModel<3, 2, 2> {
    LinearModel::new(random.matrix() * 0.6, random.matrix(), random.matrix()).unwrap()
}

/// The vehicle of paper 001 (48), (51) with `atan`, noises included.
pub(crate) fn tracking()
-> (ByFunction<impl Function + Copy + std::fmt::Debug>, ByFunction<impl Function + Copy + std::fmt::Debug>) {
    let motion = function!(|[x1, x2, x3, x4, w1, w2, w3, w4]: 8| -> 4 {
        let scale = S::from_f64(15.0) / (x3.sqr() + x4.sqr()).sqrt();
        [x1 + x3.scale(0.5) + w1, x2 + x4.scale(0.5) + w2, x3 * scale + w3, x4 * scale + w4]
    });
    let sensor = function!(|[x1, x2, _x3, _x4, v1, v2]: 6| -> 2 {
        [(x1.sqr() + x2.sqr()).sqrt() + v1, (x2 / x1).atan() + v2]
    });
    (ByFunction::new(motion), ByFunction::new(sensor))
}

/// A planar vehicle `X+ = X exp(u + w)`; its position is measured.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Planar;

impl<Side: ErrorSide + PartialEq> Motion<OnGroup<SE2<f64>, Side, 2>, 3, 3> for Planar {
    type Input = Vector3<f64>;
    fn transition(&self, x: &SE2<f64>, u: &Vector3<f64>, w: &Vector3<f64>) -> SE2<f64> {
        x.compose(&SE2::exp(&(u + w)))
    }
}

impl<Side: ErrorSide + PartialEq> SmoothMotion<OnGroup<SE2<f64>, Side, 2>, 3, 3> for Planar {
    fn motion_jacobians(&self, x: &SE2<f64>, u: &Vector3<f64>) -> (Matrix3<f64>, Matrix3<f64>) {
        let step = SE2::exp(u);
        // X exp(u + w) = X exp(u) exp(Jr(u) w).
        (Side::transition(&step), Side::noise_map(&x.compose(&step)) * SE2::jr(u))
    }
}

impl<Side: ErrorSide + PartialEq> Sensor<OnGroup<SE2<f64>, Side, 2>, 3, 2, 2> for Planar {
    fn output(&self, x: &SE2<f64>, v: &Vector2<f64>) -> Vector2<f64> {
        x.translation() + v
    }
}

impl<Side: ErrorSide + PartialEq> SmoothSensor<OnGroup<SE2<f64>, Side, 2>, 3, 2, 2> for Planar {
    fn output_jacobians(&self, x: &SE2<f64>) -> (Matrix2x3<f64>, Matrix2<f64>) {
        (Side::point_jacobian(x, &Vector2::zeros()), Matrix2::identity())
    }
}

/// The left-invariant chart of the plane.
pub(crate) type LeftPlane = OnGroup<SE2<f64>, Left, 2>;

/// `m m' + small I`: a covariance.
pub(crate) fn covariance<const N: usize>(m: &SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
    m * m.transpose() + SMatrix::identity() * 0.05
}
