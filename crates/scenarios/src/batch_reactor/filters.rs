//! The filters of the experiment and their settings.

use estimators::kalman::{ByFunction, Ekf, Flat, Gaussian, Ukf};
use nalgebra::{Matrix1, Matrix2, Vector2};

use super::plant::{NOISE_SIGMA, Pressure, Rates, Reaction};
use crate::contest::Contestant;
use crate::{Mode, ScenarioError};

/// Initial estimate, atm.
pub const ESTIMATE: [f64; 2] = [2.5, 1.5];
/// Variance of its error, atm^2.
const VARIANCE: f64 = 0.16;
/// Variance of the process noise that the Kalman filters suppose, atm^2.
const PROCESS_VARIANCE: f64 = 1e-10;

/// A filter ready to be started.
#[derive(Clone, Copy, Debug)]
pub struct Contender {
    /// Name in the rows.
    pub method: &'static str,
    /// What is rigorous, for sets.
    pub mode: Option<Mode>,
    start: fn(Rates) -> Result<Box<dyn Contestant<2>>, ScenarioError>,
}

impl Contender {
    /// The filter at its initial estimate.
    ///
    /// # Errors
    /// Those of the constructor.
    pub fn start(&self, rates: Rates) -> Result<Box<dyn Contestant<2>>, ScenarioError> {
        (self.start)(rates)
    }
}

/// The filters of the paper, and the extended Kalman filter.
pub const PUBLISHED: [Contender; 2] = [
    Contender { method: "ukf", mode: None, start: ukf },
    Contender { method: "ekf", mode: None, start: ekf },
];

type Model = (ByFunction<Reaction>, ByFunction<Pressure>);

fn model(rates: Rates) -> Model {
    (ByFunction::new(Reaction(rates)), ByFunction::new(Pressure))
}

fn belief() -> Result<Gaussian<Flat, 2>, ScenarioError> {
    Ok(Gaussian::new(Vector2::from(ESTIMATE), &(Matrix2::identity() * VARIANCE))?)
}

fn ukf(rates: Rates) -> Result<Box<dyn Contestant<2>>, ScenarioError> {
    let (q, r) = (Matrix2::identity() * PROCESS_VARIANCE, Matrix1::new(NOISE_SIGMA * NOISE_SIGMA));
    Ok(Box::new(Ukf::<Model, Flat, 2, 1, 2, 1>::new(model(rates), belief()?, &q, &r)?))
}

fn ekf(rates: Rates) -> Result<Box<dyn Contestant<2>>, ScenarioError> {
    let (q, r) = (Matrix2::identity() * PROCESS_VARIANCE, Matrix1::new(NOISE_SIGMA * NOISE_SIGMA));
    Ok(Box::new(Ekf::<Model, Flat, 2, 1, 2, 1>::new(model(rates), belief()?, &q, &r)?))
}
