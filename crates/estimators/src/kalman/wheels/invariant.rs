//! [`InvariantWheels`]: the three problems on their groups, with the left- or the right-invariant error.

use lie_groups::{FrameGroup, LieGroup, SE2, SO2, TwoFrame};
use nalgebra::{Matrix2, Matrix2x3, Matrix3, SMatrix, SVector, Vector2, Vector3};

use super::state::{WheelStep, quarter};
use crate::kalman::{Motion, OnGroup, Sensor, SmoothMotion, SmoothSensor};
use crate::{ErrorSide, EstimatorError};

/// A group whose elements are states of a wheeled robot.
pub trait Drivable<const N: usize>: LieGroup<f64, N, 2> + 'static {
    /// The state after a step.
    #[must_use]
    fn driven(&self, step: &WheelStep) -> Self;

    /// Where the antenna is, `x + g * X`, m.
    fn antenna(&self) -> Vector2<f64>;

    /// `(A, G)` of a step for the left-invariant error: `A e + G (n_theta, n_U)` after it, `A` exactly so for any `e`.
    fn left_jacobians(&self, step: &WheelStep) -> (SMatrix<f64, N, N>, SMatrix<f64, N, 3>);

    /// Derivative of the antenna's place by the left-invariant error: `g * [0, I, I]`.
    fn left_output(&self) -> SMatrix<f64, 2, N>;
}

/// A wheeled robot on a group ([`Drivable`]): a step of gyro and wheels, fixes of the antenna; noises as those of [`Wheels`](super::Wheels).
///
/// The motion is group-affine, a lever arm being a constant vector of the body, as rotations of the plane commute: `A` does not depend on the estimate, and is exact for errors of any size, with the left- and with the
/// right-invariant error, `A_right = Ad A_left Ad^-1` at the estimates after and before the step.
///
/// **Source:** paper 002, Propositions 1 and 2.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct InvariantWheels;

impl<G: Drivable<N>, Side: ErrorSide + PartialEq, const N: usize> Motion<OnGroup<G, Side, 2>, N, 3>
    for InvariantWheels
{
    type Input = WheelStep;

    fn transition(&self, x: &G, u: &WheelStep, w: &Vector3<f64>) -> G {
        x.driven(&WheelStep::new(u.turn_rad + w[0], u.shift + w.fixed_rows::<2>(1)))
    }

    fn check_input(&self, u: &WheelStep) -> Result<(), EstimatorError> {
        u.check()
    }
}

impl<G: Drivable<N>, Side: ErrorSide + PartialEq, const N: usize> SmoothMotion<OnGroup<G, Side, 2>, N, 3>
    for InvariantWheels
{
    fn motion_jacobians(&self, x: &G, u: &WheelStep) -> (SMatrix<f64, N, N>, SMatrix<f64, N, 3>) {
        let (a, g) = x.left_jacobians(u);
        if Side::IS_LEFT {
            return (a, g);
        }
        let after = x.driven(u).adjoint();
        (after * a * x.inverse().adjoint(), after * g)
    }
}

impl<G: Drivable<N>, Side: ErrorSide + PartialEq, const N: usize> Sensor<OnGroup<G, Side, 2>, N, 2, 2>
    for InvariantWheels
{
    fn output(&self, x: &G, v: &Vector2<f64>) -> Vector2<f64> {
        x.antenna() + v
    }
}

impl<G: Drivable<N>, Side: ErrorSide + PartialEq, const N: usize> SmoothSensor<OnGroup<G, Side, 2>, N, 2, 2>
    for InvariantWheels
{
    fn output_jacobians(&self, x: &G) -> (SMatrix<f64, 2, N>, Matrix2<f64>) {
        let h = x.left_output();
        (if Side::IS_LEFT { h } else { h * x.inverse().adjoint() }, Matrix2::identity())
    }
}

/// Problem 1: the antenna is on the axle, the wheels are known.
impl Drivable<3> for SE2<f64> {
    fn driven(&self, step: &WheelStep) -> Self {
        Self::new(self.rotation().compose(&SO2::from_angle(step.turn_rad)), &self.act(&step.shift))
    }

    fn left_jacobians(&self, step: &WheelStep) -> (Matrix3<f64>, Matrix3<f64>) {
        let back = step.turn().inverse().act_linear();
        let mut a = Matrix3::identity();
        a.fixed_view_mut::<2, 2>(1, 1).copy_from(&back);
        let mut g = a;
        a.fixed_view_mut::<2, 1>(1, 0).copy_from(&(back * quarter(&step.shift)));
        g[(0, 0)] = 1.0;
        (a, g)
    }

    fn antenna(&self) -> Vector2<f64> {
        self.translation()
    }

    fn left_output(&self) -> Matrix2x3<f64> {
        self.act_linear() * Self::act_jacobian(&Vector2::zeros())
    }
}

/// One position and at most one lever arm: Problem 2 (`TfgLever2`), Problem 3 in `X' = X / s` (`TfgScaleLever2`), and the wheels unknown with
/// the antenna on the axle (`Sim2`).
impl<F, const NB: usize, const DG: usize, const N: usize> Drivable<N> for TwoFrame<F, f64, 2, 1, NB, DG, N>
where
    F: FrameGroup<f64, 2, DG> + 'static,
{
    fn driven(&self, step: &WheelStep) -> Self {
        // The rotation comes first among the coordinates of a frame.
        let turn = F::exp(&SVector::from_fn(|i, _| if i == 0 { step.turn_rad } else { 0.0 }));
        Self::new(self.frame().compose(&turn), [self.act(&step.shift)], *self.body())
    }

    fn left_jacobians(&self, step: &WheelStep) -> (SMatrix<f64, N, N>, SMatrix<f64, N, 3>) {
        let back = step.turn().inverse().act_linear();
        let mut a = SMatrix::<f64, N, N>::identity();
        a.view_mut((DG, 0), (2, DG)).copy_from(&(back * F::act_jacobian(&step.shift)));
        a.view_mut((DG, DG), (2, 2)).copy_from(&back);
        let mut g = SMatrix::<f64, N, 3>::zeros();
        g[(0, 0)] = 1.0;
        g.view_mut((DG, 1), (2, 2)).copy_from(&back);
        for (j, lever) in self.body().iter().enumerate() {
            g.view_mut((DG + 2 + 2 * j, 0), (2, 1)).copy_from(&quarter(lever));
        }
        (a, g)
    }

    fn antenna(&self) -> Vector2<f64> {
        self.act(self.body().first().unwrap_or(&Vector2::zeros()))
    }

    fn left_output(&self) -> SMatrix<f64, 2, N> {
        let mut h = SMatrix::<f64, 2, N>::zeros();
        for k in 0..=NB.min(1) {
            h.view_mut((0, DG + 2 * k), (2, 2)).copy_from(&self.act_linear());
        }
        h
    }
}
