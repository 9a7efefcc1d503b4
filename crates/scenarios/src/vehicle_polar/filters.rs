//! The filters of the experiment and their settings.

use estimators::kalman::{ByFunction, Ekf, Flat, Gaussian, Ukf};
use nalgebra::{Matrix2, Matrix4, SMatrix, SVector, Vector4};

use super::plant::{Bearing, Drive, NOISE_SIGMA, PROCESS_SIGMA, Polar};
use crate::contest::Contestant;
use crate::{Mode, ScenarioError};

/// Initial estimate. The paper prints three entries for four states; this is the only completion that fits its Table 2.
pub const ESTIMATE: [f64; 4] = [3.0; 4];
/// Factor of the variances of the noises that the filters suppose.
pub const TUNING: f64 = 1.5;

/// A filter ready to be started at an estimate.
#[derive(Clone, Copy, Debug)]
pub struct Contender {
    /// Name in the rows.
    pub method: &'static str,
    /// What is rigorous, for sets.
    pub mode: Option<Mode>,
    start: fn(Bearing, [f64; 4]) -> Result<Box<dyn Contestant<4>>, ScenarioError>,
}

impl Contender {
    /// The filter at an initial estimate.
    ///
    /// # Errors
    /// Those of the constructor.
    pub fn start(&self, bearing: Bearing, estimate: [f64; 4]) -> Result<Box<dyn Contestant<4>>, ScenarioError> {
        (self.start)(bearing, estimate)
    }
}

/// The filters of the paper, and the extended Kalman filter.
pub const PUBLISHED: [Contender; 2] = [
    Contender { method: "ukf", mode: None, start: ukf },
    Contender { method: "ekf", mode: None, start: ekf },
];

/// Motion and sensor.
pub type Model = (ByFunction<Drive>, ByFunction<Polar>);

/// The model of the Kalman filters.
#[must_use]
pub fn model(bearing: Bearing) -> Model {
    (ByFunction::new(Drive), ByFunction::new(Polar(bearing)))
}

/// Covariances of the noises that the filters suppose.
#[must_use]
pub fn noises() -> (Matrix4<f64>, Matrix2<f64>) {
    fn scaled<const N: usize>(sigma: [f64; N]) -> SMatrix<f64, N, N> {
        SMatrix::from_diagonal(&SVector::from(sigma.map(|sigma| TUNING * sigma * sigma)))
    }
    (scaled(PROCESS_SIGMA), scaled(NOISE_SIGMA))
}

fn belief(estimate: [f64; 4]) -> Result<Gaussian<Flat, 4>, ScenarioError> {
    Ok(Gaussian::new(Vector4::from(estimate), &Matrix4::identity())?)
}

fn ukf(bearing: Bearing, estimate: [f64; 4]) -> Result<Box<dyn Contestant<4>>, ScenarioError> {
    let (q, r) = noises();
    Ok(Box::new(Ukf::<Model, Flat, 4, 2, 4, 2>::new(model(bearing), belief(estimate)?, &q, &r)?))
}

fn ekf(bearing: Bearing, estimate: [f64; 4]) -> Result<Box<dyn Contestant<4>>, ScenarioError> {
    let (q, r) = noises();
    Ok(Box::new(Ekf::<Model, Flat, 4, 2, 4, 2>::new(model(bearing), belief(estimate)?, &q, &r)?))
}
