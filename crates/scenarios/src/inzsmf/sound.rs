//! The library's filters on the vehicle: valid order reductions, exact error propagation, boxes in the world frame.
//!
//! Still first order: both filters drop the terms of second order in the error.

use estimators::{Estimator, Gain, InZsmf, Left, Model, Outputs, Zsmf};
use lie_groups::{Enclose, SE2};
use nalgebra::{Matrix2x3, Matrix3, Vector2, Vector3};
use scalars::Interval;
use setrep::{Reduction, Zonotope};

use crate::inzsmf::cases::POLES;
use crate::inzsmf::containment::Watchable;
use crate::inzsmf::errors::{Error, euclidean_errors, invariant_errors};
use crate::inzsmf::study::Contender;
use crate::inzsmf::tracking::Tracker;
use crate::vehicle::{OUTPUT_BOUNDS, PERIOD_S, PROCESS_BOUNDS, Pose, SPEED, TURN_RATE, TruePose};
use crate::{Mode, ScenarioError};

/// A setting of both filters.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// What stands after the `/` in the method's name; empty for the paper's setting.
    pub name: String,
    /// Order reduction, if any.
    pub reduction: Option<(Reduction, usize)>,
    /// Gain.
    pub gain: Gain<3, 2>,
}

impl Variant {
    /// The paper's setting: Combastel's reduction (Remark 1) to 30 generators, F-radius gain.
    #[must_use]
    pub fn of_the_paper() -> Self {
        Self { name: String::new(), reduction: Some((Reduction::Combastel, 30)), gain: Gain::FRadius }
    }

    /// The paper's setting with placed poles.
    #[must_use]
    pub fn pole() -> Self {
        Self { name: "pole".to_owned(), gain: Gain::real_poles(POLES), ..Self::of_the_paper() }
    }

    /// Another reduction or order.
    #[must_use]
    pub fn reduced(method: Reduction, order: usize) -> Self {
        let name = match method {
            Reduction::Combastel => "combastel",
            Reduction::Girard => "girard",
            Reduction::Pca => "pca",
            Reduction::Method4 => "method4",
            _ => "other",
        };
        Self { name: format!("{name}-{order}"), reduction: Some((method, order)), gain: Gain::FRadius }
    }

    /// All generators kept: five more at every step.
    #[must_use]
    pub fn not_reduced() -> Self {
        Self { name: "no-reduction".to_owned(), reduction: None, gain: Gain::FRadius }
    }

    /// Both filters with this setting and `H_0 = I`.
    #[must_use]
    pub fn contenders(&self) -> [Contender; 2] {
        let method =
            |filter: &str| if self.name.is_empty() { filter.to_owned() } else { format!("{filter}/{}", self.name) };
        let (of_zsmf, of_inzsmf) = (self.clone(), self.clone());
        [
            Contender::new(method("zsmf"), Mode::Sound, move |initial| {
                Ok(Box::new(SoundZsmf::new(&of_zsmf, initial, [1.0; 3])?))
            }),
            Contender::new(method("inzsmf"), Mode::Sound, move |initial| {
                Ok(Box::new(SoundInZsmf::new(&of_inzsmf, initial, [1.0; 3])?))
            }),
        ]
    }
}

/// Euler's discretisation (14) with its derivatives (16); state `(theta, x1, x2)`.
#[derive(Clone, Copy, Debug)]
struct EuclideanVehicle;

impl Model<3, 2, 3> for EuclideanVehicle {
    type Input = ();

    fn transition(&self, x: &Vector3<f64>, (): &()) -> Vector3<f64> {
        let (sin, cos) = x[0].sin_cos();
        x + PERIOD_S * Vector3::new(TURN_RATE, cos * SPEED, sin * SPEED)
    }

    fn transition_jacobian(&self, x: &Vector3<f64>, (): &()) -> Matrix3<f64> {
        let (sin, cos) = x[0].sin_cos();
        let advance = SPEED * PERIOD_S;
        Matrix3::new(1.0, 0.0, 0.0, -sin * advance, 1.0, 0.0, cos * advance, 0.0, 1.0)
    }

    fn noise_jacobian(&self, x: &Vector3<f64>, (): &()) -> Matrix3<f64> {
        let (sin, cos) = x[0].sin_cos();
        PERIOD_S * Matrix3::new(1.0, 0.0, 0.0, 0.0, cos, -sin, 0.0, sin, cos)
    }

    fn output(&self, x: &Vector3<f64>) -> Vector2<f64> {
        Vector2::new(x[1], x[2])
    }

    fn output_jacobian(&self, _: &Vector3<f64>) -> Matrix2x3<f64> {
        Matrix2x3::new(0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
    }
}

/// ZSMF on `(theta, x1, x2)`.
#[derive(Clone, Debug)]
pub struct SoundZsmf {
    filter: Zsmf<EuclideanVehicle, 3, 2, 3>,
}

impl SoundZsmf {
    /// The filter at an initial estimate, with `H_0 = diag(radii)`.
    ///
    /// # Errors
    /// [`ScenarioError::Set`] or [`ScenarioError::Estimator`] for a bad setting.
    pub fn new(variant: &Variant, initial: Pose, radii: [f64; 3]) -> Result<Self, ScenarioError> {
        let center = [initial.heading_rad, initial.position[0], initial.position[1]];
        let start = Zonotope::from_box(&center, &radii)?;
        let process = Zonotope::from_box(&[0.0; 3], &PROCESS_BOUNDS)?;
        let noise = Zonotope::from_box(&[0.0; 2], &OUTPUT_BOUNDS)?;
        let filter = Zsmf::new(EuclideanVehicle, &start, &process, &noise)?.with_gain(variant.gain.clone());
        Ok(Self {
            filter: match variant.reduction {
                Some((method, order)) => filter.with_reduction(method, order)?,
                None => filter,
            },
        })
    }
}

impl Tracker for SoundZsmf {
    fn step(&mut self, output: [f64; 2]) -> Result<(), ScenarioError> {
        Ok(self.filter.step(&(), &output)?)
    }

    fn center(&self) -> Pose {
        let x = self.filter.estimate();
        Pose { heading_rad: x[0], position: [x[1], x[2]] }
    }

    fn widths(&self) -> [f64; 3] {
        let mut hull = [Interval::ZERO; 3];
        // The dimensions agree by construction; a hull that failed would count as unbounded.
        let failed = self.filter.enclosure().interval_hull_into(&mut hull).is_err();
        if failed { [f64::INFINITY; 3] } else { hull.map(|side| side.width()) }
    }
}

impl Watchable for SoundZsmf {
    fn error_set(&self) -> Result<Zonotope, ScenarioError> {
        let mut set = self.filter.enclosure().clone();
        set.translate((-self.filter.estimate()).as_slice())?;
        Ok(set)
    }

    fn errors(&self, truth: &TruePose, reach_rad: f64) -> Result<Vec<Error>, ScenarioError> {
        Ok(euclidean_errors(truth, &self.center(), reach_rad))
    }
}

/// Left InZSMF on SE(2).
#[derive(Clone, Debug)]
pub struct SoundInZsmf {
    filter: InZsmf<SE2<f64>, 3, 2, Left, 2>,
}

impl SoundInZsmf {
    /// The filter at an initial estimate, with `H_0 = diag(radii)` in the body frame.
    ///
    /// # Errors
    /// [`ScenarioError::Set`] or [`ScenarioError::Estimator`] for a bad setting.
    pub fn new(variant: &Variant, initial: Pose, radii: [f64; 3]) -> Result<Self, ScenarioError> {
        let estimate = SE2::from_pose(initial.heading_rad, initial.position[0], initial.position[1]);
        let start = Zonotope::from_box(&[0.0; 3], &radii)?;
        // Bounds per step, rounded up.
        let process = Zonotope::from_box(&[0.0; 3], &PROCESS_BOUNDS.map(|bound| (PERIOD_S * bound).next_up()))?;
        let noise = Zonotope::from_box(&[0.0; 2], &OUTPUT_BOUNDS)?;
        let filter =
            InZsmf::new(estimate, &start, Outputs::position(), &process, &noise)?.with_gain(variant.gain.clone());
        Ok(Self {
            filter: match variant.reduction {
                Some((method, order)) => filter.with_reduction(method, order)?,
                None => filter,
            },
        })
    }
}

impl Tracker for SoundInZsmf {
    fn step(&mut self, output: [f64; 2]) -> Result<(), ScenarioError> {
        let advance = Vector3::new(TURN_RATE * PERIOD_S, SPEED * PERIOD_S, 0.0);
        Ok(self.filter.step(&advance, &output)?)
    }

    fn center(&self) -> Pose {
        let unit = self.filter.estimate().rotation().unit();
        let position = self.filter.estimate().translation();
        Pose { heading_rad: unit.im.atan2(unit.re), position: position.into() }
    }

    /// Widths of the heading interval of the tangent set, and of the position box in the world frame to first order (the
    /// exponential replaced by its linear part, as in the paper).
    fn widths(&self) -> [f64; 3] {
        let mut hull = [Interval::ZERO; 3];
        let failed = self.filter.tangent_set().interval_hull_into(&mut hull).is_err();
        let [x1, x2] = self.filter.world_hull_approx(&Vector2::zeros());
        if failed { [f64::INFINITY; 3] } else { [hull[0].width(), x1.width(), x2.width()] }
    }
}

impl Watchable for SoundInZsmf {
    fn error_set(&self) -> Result<Zonotope, ScenarioError> {
        Ok(self.filter.tangent_set().clone())
    }

    fn errors(&self, truth: &TruePose, reach_rad: f64) -> Result<Vec<Error>, ScenarioError> {
        invariant_errors(truth, &self.filter.estimate().enclose(), reach_rad)
    }
}
