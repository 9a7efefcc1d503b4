//! The robot in space, and its three errors: the left-invariant errors of three groups with the same states.

use estimators::Left;
use estimators::kalman::{Chart, Motion, OnGroup, Sensor, SmoothMotion, SmoothSensor};
use lie_groups::{LieGroup, Prod, RPlus, Rn, SE3, SO3, ScaledSO3, TfgScaleLever3};
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use crate::ScenarioError;

/// Number of coordinates.
pub const N: usize = 10;

/// Rotation, scale, position and lever arm (m) in the robot's own variables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parts {
    /// Rotation from body to world.
    pub rotation: SO3<f64>,
    /// Way of the robot over way of its wheels.
    pub scale: f64,
    /// Position, m.
    pub position: Vector3<f64>,
    /// Lever arm in the body, m.
    pub lever: Vector3<f64>,
}

/// A turn (rotation vector, rad) and a displacement in the frame of the robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Turn, rad.
    pub turn: Vector3<f64>,
    /// Displacement by the wheels.
    pub shift: Vector3<f64>,
}

impl Parts {
    /// The state after a step: `(R Omega, s, x + s R U, X)`.
    #[must_use]
    pub fn moved(&self, step: &Step) -> Self {
        Self {
            rotation: self.rotation.compose(&SO3::exp(&step.turn)),
            position: self.position + self.rotation.act(&step.shift) * self.scale,
            ..*self
        }
    }

    /// Where the antenna is: `x + R X`, m.
    #[must_use]
    pub fn antenna(&self) -> Vector3<f64> {
        self.position + self.rotation.act(&self.lever)
    }
}

/// A group whose elements are states of the robot; the first three coordinates are those of the rotation.
pub trait Spatial: LieGroup<f64, N, 3> + 'static {
    /// Where scale, position and lever arm begin among the coordinates.
    const STARTS: [usize; 3];

    /// The element of a state.
    ///
    /// # Errors
    /// [`ScenarioError::Group`] for a state the group does not have.
    fn of(parts: &Parts) -> Result<Self, ScenarioError>;

    /// The state.
    fn parts(&self) -> Parts;

    /// The element of a state reached from this one by a step: the scale is as it was.
    #[must_use]
    fn with(&self, parts: &Parts) -> Self;
}

impl Spatial for TfgScaleLever3<f64> {
    const STARTS: [usize; 3] = [3, 4, 7];

    fn of(parts: &Parts) -> Result<Self, ScenarioError> {
        let frame = ScaledSO3::new(parts.rotation, RPlus::from_scale(parts.scale)?);
        Ok(Self::new(frame, [parts.position], [parts.lever / parts.scale]))
    }

    fn parts(&self) -> Parts {
        let (rotation, scale) = (self.frame().rotation(), self.frame().scaling().scale());
        Parts { rotation, scale, position: self.fixed()[0], lever: self.body()[0] * scale }
    }

    fn with(&self, parts: &Parts) -> Self {
        let frame = ScaledSO3::new(parts.rotation, self.frame().scaling());
        Self::new(frame, [parts.position], [parts.lever / self.frame().scaling().scale()])
    }
}

/// The imperfect filter: SE(3), and plain differences of scale and lever arm.
pub type Imperfect3 = Prod<SE3<f64>, Rn<f64, 4>, 6, 4, 4, N>;

fn imperfect(parts: &Parts) -> Imperfect3 {
    let pose = SE3::new(parts.rotation, [parts.position], []);
    Prod::new(pose, Rn::new(parts.lever.insert_row(0, parts.scale)))
}

impl Spatial for Imperfect3 {
    const STARTS: [usize; 3] = [6, 3, 7];

    fn of(parts: &Parts) -> Result<Self, ScenarioError> {
        Ok(imperfect(parts))
    }

    fn parts(&self) -> Parts {
        let rest = self.second().vector();
        let (rotation, position) = (self.first().frame(), self.first().fixed()[0]);
        Parts { rotation, scale: rest[0], position, lever: rest.fixed_rows::<3>(1).into() }
    }

    fn with(&self, parts: &Parts) -> Self {
        imperfect(parts)
    }
}

/// The extended Kalman filter: rotations, and plain differences of everything else.
pub type Plain3 = Prod<SO3<f64>, Rn<f64, 7>, 3, 7, 7, N>;

fn plain(parts: &Parts) -> Plain3 {
    let Parts { scale, position: x, lever: l, .. } = parts;
    let rest = SVector::<f64, 7>::from_column_slice(&[*scale, x[0], x[1], x[2], l[0], l[1], l[2]]);
    Prod::new(parts.rotation, Rn::new(rest))
}

impl Spatial for Plain3 {
    const STARTS: [usize; 3] = [3, 4, 7];

    fn of(parts: &Parts) -> Result<Self, ScenarioError> {
        Ok(plain(parts))
    }

    fn parts(&self) -> Parts {
        let rest = self.second().vector();
        let (position, lever) = (rest.fixed_rows::<3>(1).into(), rest.fixed_rows::<3>(4).into());
        Parts { rotation: *self.first(), scale: rest[0], position, lever }
    }

    fn with(&self, parts: &Parts) -> Self {
        plain(parts)
    }
}

/// Motion and sensor in space; noises of turn, displacement and fix. Derivatives are central differences: exact to 1e-9, and the same code
/// for all errors.
#[derive(Clone, Copy, Debug)]
pub struct Space;

/// Step of the differences.
const DIFFERENCE: f64 = 1e-5;

/// The derivative of `f` at 0 by central differences.
fn slopes<const R: usize, const C: usize>(f: impl Fn(&SVector<f64, C>) -> SVector<f64, R>) -> SMatrix<f64, R, C> {
    let mut slopes = SMatrix::<f64, R, C>::zeros();
    for k in 0..C {
        let step = SVector::<f64, C>::from_fn(|i, _| if i == k { DIFFERENCE } else { 0.0 });
        slopes.set_column(k, &((f(&step) - f(&-step)) / (2.0 * DIFFERENCE)));
    }
    slopes
}

type Error<G> = OnGroup<G, Left, 3>;

impl<G: Spatial> Motion<Error<G>, N, 6> for Space {
    type Input = Step;

    fn transition(&self, x: &G, u: &Step, w: &SVector<f64, 6>) -> G {
        let step = Step { turn: u.turn + w.fixed_rows::<3>(0), shift: u.shift + w.fixed_rows::<3>(3) };
        x.with(&x.parts().moved(&step))
    }
}

impl<G: Spatial> SmoothMotion<Error<G>, N, 6> for Space {
    fn motion_jacobians(&self, x: &G, u: &Step) -> (SMatrix<f64, N, N>, SMatrix<f64, N, 6>) {
        let still = SVector::zeros();
        let back = Motion::<Error<G>, N, 6>::transition(self, x, u, &still).inverse();
        // A difference is near the identity; where its logarithm fails, so does the check of the predicted belief.
        let error = |y: G| back.compose(&y).log().unwrap_or_else(|_| SVector::repeat(f64::NAN));
        let moved = |x: &G, w: &SVector<f64, 6>| Motion::<Error<G>, N, 6>::transition(self, x, u, w);
        (slopes(|e| error(moved(&Error::<G>::shift(x, e), &still))), slopes(|w| error(moved(x, w))))
    }
}

impl<G: Spatial> Sensor<Error<G>, N, 3, 3> for Space {
    fn output(&self, x: &G, v: &Vector3<f64>) -> Vector3<f64> {
        x.parts().antenna() + v
    }
}

impl<G: Spatial> SmoothSensor<Error<G>, N, 3, 3> for Space {
    fn output_jacobians(&self, x: &G) -> (SMatrix<f64, 3, N>, Matrix3<f64>) {
        (slopes(|e| Error::<G>::shift(x, e).parts().antenna()), Matrix3::identity())
    }
}
