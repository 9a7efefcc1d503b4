//! [`InvariantWheels`]: the three problems on their groups, with the left- or the right-invariant error.

use lie_groups::{LieGroup, SE2, SO2};
use nalgebra::{Matrix2, Matrix2x3, Matrix3, SMatrix, Vector2, Vector3};

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
/// The motion is group-affine: `A` does not depend on the estimate, and is exact for errors of any size, with the left- and with the
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
