//! The filters of the experiment behind one face.

use estimators::Estimator;
use estimators::kalman::Ekf;
use estimators::kalman::wheels::{
    ImperfectError, PlainError, TwoFrameError, WheelError, WheelState, WheelStep, Wheels,
};
use nalgebra::{Matrix2, Matrix3, Vector3, Vector6};

use crate::ScenarioError;

/// A filter of a wheeled robot.
pub trait Follower {
    /// Moves the belief over a step.
    ///
    /// # Errors
    /// Those of the filter.
    fn predict(&mut self, step: &WheelStep) -> Result<(), ScenarioError>;

    /// Corrects it by a fix of the antenna, m.
    ///
    /// # Errors
    /// Those of the filter.
    fn update(&mut self, fix: [f64; 2]) -> Result<(), ScenarioError>;

    /// The estimate.
    fn state(&self) -> WheelState;

    /// Standard deviations of heading (rad), scale, position (m) and lever arm (m).
    fn deviations(&self) -> Vector6<f64>;

    /// Normalised estimation error squared, in the coordinates of the filter; 6 on average if its covariance is right.
    ///
    /// # Errors
    /// Those of the logarithm.
    fn nees(&self, truth: &WheelState) -> Result<f64, ScenarioError>;
}

impl<C: WheelError> Follower for Ekf<Wheels, C, 6, 2, 3, 2> {
    fn predict(&mut self, step: &WheelStep) -> Result<(), ScenarioError> {
        Ok(Estimator::predict(self, step)?)
    }

    fn update(&mut self, fix: [f64; 2]) -> Result<(), ScenarioError> {
        Ok(Estimator::update(self, &fix)?)
    }

    fn state(&self) -> WheelState {
        *self.belief().mean()
    }

    fn deviations(&self) -> Vector6<f64> {
        C::deviations(self.belief())
    }

    fn nees(&self, truth: &WheelState) -> Result<f64, ScenarioError> {
        Ok(self.belief().nees(truth)?)
    }
}

/// Which filter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The filter of paper 002.
    Tfg,
    /// The imperfect invariant filter.
    Imperfect,
    /// The extended Kalman filter.
    Ekf,
}

/// Noises that a filter supposes, as standard deviations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noises {
    /// Of a step: turn (rad), displacement along and across (m).
    pub step: [f64; 3],
    /// Of each coordinate of a fix, m.
    pub fix_m: f64,
}

impl Method {
    /// All, in the order of Table I.
    pub const ALL: [Self; 3] = [Self::Tfg, Self::Imperfect, Self::Ekf];

    /// The name in the rows.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Tfg => "tfg-iekf",
            Self::Imperfect => "iekf-imperfect",
            Self::Ekf => "ekf",
        }
    }

    /// The filter at a guess with standard deviations of heading (rad), scale, position and lever arm (m).
    ///
    /// # Errors
    /// Those of belief and filter.
    pub fn start(
        self,
        guess: WheelState,
        deviations: &Vector6<f64>,
        noises: &Noises,
    ) -> Result<Box<dyn Follower>, ScenarioError> {
        fn boxed<C: WheelError>(
            guess: WheelState,
            deviations: &Vector6<f64>,
            noises: &Noises,
        ) -> Result<Box<dyn Follower>, ScenarioError> {
            let q = Matrix3::from_diagonal(&Vector3::from(noises.step.map(|sd| sd * sd)));
            let r = Matrix2::identity() * (noises.fix_m * noises.fix_m);
            Ok(Box::new(Ekf::<Wheels, C, 6, 2, 3, 2>::new(Wheels, C::belief(guess, deviations)?, &q, &r)?))
        }
        match self {
            Self::Tfg => boxed::<TwoFrameError>(guess, deviations, noises),
            Self::Imperfect => boxed::<ImperfectError>(guess, deviations, noises),
            Self::Ekf => boxed::<PlainError>(guess, deviations, noises),
        }
    }
}
