//! The filters of the experiment and their settings.

use estimators::kalman::{ByFunction, Ekf, Flat, Gaussian, Ukf};
use estimators::{LinearizedZf, Relation, System, Zf, ZfOptions};
use nalgebra::{Matrix2, Matrix4, SMatrix, SVector, Vector4};
use setrep::{StripRule, Zonotope};

use super::plant::{Bearing, Drive, INITIAL, NOISE_SIGMA, PROCESS_SIGMA, Polar};
use crate::contest::{self, Contestant, Zonotopic};
use crate::{Mode, ScenarioError};

/// Initial estimate. The paper prints three entries for four states; this is the only completion that fits its Table 2.
pub const ESTIMATE: [f64; 4] = [3.0; 4];
/// Factor of the variances of the noises that the filters suppose.
pub const TUNING: f64 = 1.5;

/// Half width of the first set of the zonotopic filter: three standard deviations.
pub const RADIUS: f64 = 3.0;
/// Bounds on the process noise that it supposes, as the paper prints them.
pub const PROCESS_BOUND: [f64; 4] = [0.0, 0.0, 0.3674, 0.3674];
/// Bounds on the measurement noise that it supposes, as the paper prints them: m, rad.
pub const NOISE_BOUND: [f64; 2] = [0.1837, 0.0032];
/// Its order `phi`, which no run reaches.
pub const ORDER: usize = 10_000;

/// Which filter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Unscented Kalman filter.
    Unscented,
    /// Extended Kalman filter.
    Extended,
    /// The paper's zonotopic filter, linearised.
    Linearized,
    /// The zonotopic filter with a guarantee.
    MeanValue,
    /// The same from a small set around the truth.
    MeanValueNearTruth,
}

/// A filter under a name.
pub type Contender = contest::Contender<Kind>;

/// A filter at an initial estimate.
///
/// # Errors
/// Those of the constructors.
pub fn filter(kind: Kind, bearing: Bearing, estimate: [f64; 4]) -> Result<Box<dyn Contestant<4>>, ScenarioError> {
    let belief = Gaussian::<Flat, 4>::new(Vector4::from(estimate), &Matrix4::identity())?;
    let (q, r) = noises();
    let system = system(bearing, PROCESS_BOUND, NOISE_BOUND)?;
    let first = Zonotope::from_box(&estimate, &[RADIUS; 4])?;
    Ok(match kind {
        Kind::Unscented => Box::new(Ukf::<Model, Flat, 4, 2, 4, 2>::new(model(bearing), belief, &q, &r)?),
        Kind::Extended => Box::new(Ekf::<Model, Flat, 4, 2, 4, 2>::new(model(bearing), belief, &q, &r)?),
        Kind::Linearized => Box::new(Zonotopic(LinearizedZf::new(system, first, options())?)),
        Kind::MeanValue => Box::new(Zonotopic(Zf::new(system, first, ZfOptions::new(GUARANTEED_ORDER))?)),
        Kind::MeanValueNearTruth => {
            let near = Zonotope::from_box(&INITIAL, &NEAR)?;
            Box::new(Zonotopic(Zf::new(system, near, ZfOptions::new(GUARANTEED_ORDER))?))
        }
    })
}

/// The filters of the paper, and the extended Kalman filter.
pub const PUBLISHED: [Contender; 3] = [
    Contender { method: "ukf", mode: None, kind: Kind::Unscented },
    Contender { method: "zf", mode: Some(Mode::Sound), kind: Kind::Linearized },
    Contender { method: "ekf", mode: None, kind: Kind::Extended },
];

/// The zonotopic filter with a guarantee, from the paper's first set and from a small one around the truth: this vehicle lets neither converge.
pub const GUARANTEED: [Contender; 2] = [
    Contender { method: "zf/mean-value", mode: Some(Mode::Rigorous), kind: Kind::MeanValue },
    Contender { method: "zf/mean-value-near-truth", mode: Some(Mode::Rigorous), kind: Kind::MeanValueNearTruth },
];
/// Its order, and the half widths of the small set.
const GUARANTEED_ORDER: usize = 24;
const NEAR: [f64; 4] = [0.3, 0.3, 0.1, 0.1];

/// The paper's options: least segments, whole strips.
#[must_use]
pub fn options() -> ZfOptions {
    ZfOptions::new(ORDER).with_rule(StripRule::Segments).with_whole_strips()
}

/// The model of the zonotopic filters.
///
/// # Errors
/// Bounds that are not finite or negative.
pub fn system(bearing: Bearing, process: [f64; 4], noise: [f64; 2]) -> Result<System, ScenarioError> {
    let (w, v) = (Zonotope::from_box(&[0.0; 4], &process)?, Zonotope::from_box(&[0.0; 2], &noise)?);
    Ok(System::new(Relation::new(Drive), w, Relation::new(Polar(bearing)), v)?)
}

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
