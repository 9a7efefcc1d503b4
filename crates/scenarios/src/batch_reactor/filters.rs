//! The filters of the experiment and their settings.

use estimators::kalman::{ByFunction, Ekf, Flat, Gaussian, Ukf};
use estimators::{Relation, System, Zf, ZfOptions};
use nalgebra::{Matrix1, Matrix2, Vector2};
use setrep::{StripRule, Zonotope};

use super::plant::{NOISE_BOUND, NOISE_SIGMA, PROCESS_BOUND, Pressure, Rates, Reaction};
use crate::contest::{self, Contestant, Zonotopic};
use crate::{Mode, ScenarioError};

/// Initial estimate, atm.
pub const ESTIMATE: [f64; 2] = [2.5, 1.5];
/// Variance of its error, atm^2.
const VARIANCE: f64 = 0.16;
/// Variance of the process noise that the Kalman filters suppose, atm^2.
const PROCESS_VARIANCE: f64 = 1e-10;

/// Half width of the first set of the zonotopic filter, atm.
const RADIUS: f64 = 1.2;
/// Its order `phi`.
const ORDER: usize = 14;

/// What varies between zonotopic filters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ZfSetting {
    /// How an intersection is chosen.
    pub rule: StripRule,
    /// Whether strips are clipped first.
    pub tighten: bool,
    /// Half width of the first set, atm.
    pub radius: f64,
    /// Bound on the process noise, atm a step.
    pub process: f64,
    /// Bound on the measurement noise, atm.
    pub noise: f64,
    /// Most generators.
    pub order: usize,
}

impl ZfSetting {
    /// As in the paper.
    pub const PAPER: Self = Self {
        rule: StripRule::Volume,
        tighten: false,
        radius: RADIUS,
        process: PROCESS_BOUND,
        noise: NOISE_BOUND,
        order: ORDER,
    };

    /// The filter at the initial estimate.
    ///
    /// # Errors
    /// Those of the constructors.
    pub fn filter(&self, rates: Rates) -> Result<Zf, ScenarioError> {
        let (w, v) = (Zonotope::from_box(&[0.0; 2], &[self.process; 2])?, Zonotope::from_box(&[0.0], &[self.noise])?);
        let system = System::new(Relation::new(Reaction(rates)), w, Relation::new(Pressure), v)?;
        let options = ZfOptions { tighten: self.tighten, ..ZfOptions::new(self.order).with_rule(self.rule) };
        Ok(Zf::new(system, Zonotope::from_box(&ESTIMATE, &[self.radius; 2])?, options)?)
    }
}

/// Which filter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Unscented Kalman filter.
    Unscented,
    /// Extended Kalman filter.
    Extended,
    /// Zonotopic filter.
    Zonotopic(ZfSetting),
}

/// A filter under a name.
pub type Contender = contest::Contender<Kind>;

/// A filter at its initial estimate.
///
/// # Errors
/// Those of the constructors.
pub fn filter(kind: Kind, rates: Rates) -> Result<Box<dyn Contestant<2>>, ScenarioError> {
    let model = (ByFunction::new(Reaction(rates)), ByFunction::new(Pressure));
    let belief = Gaussian::new(Vector2::from(ESTIMATE), &(Matrix2::identity() * VARIANCE))?;
    let (q, r) = (Matrix2::identity() * PROCESS_VARIANCE, Matrix1::new(NOISE_SIGMA * NOISE_SIGMA));
    Ok(match kind {
        Kind::Unscented => Box::new(Ukf::<Model, Flat, 2, 1, 2, 1>::new(model, belief, &q, &r)?),
        Kind::Extended => Box::new(Ekf::<Model, Flat, 2, 1, 2, 1>::new(model, belief, &q, &r)?),
        Kind::Zonotopic(setting) => Box::new(Zonotopic(setting.filter(rates)?)),
    })
}

const fn zonotopic(method: &'static str, setting: ZfSetting) -> Contender {
    Contender { method, mode: Some(Mode::Rigorous), kind: Kind::Zonotopic(setting) }
}

/// The filters of the paper, and those beside them: the extended Kalman filter, and tightened strips.
pub const PUBLISHED: [Contender; 4] = [
    Contender { method: "ukf", mode: None, kind: Kind::Unscented },
    zonotopic("zf", ZfSetting::PAPER),
    Contender { method: "ekf", mode: None, kind: Kind::Extended },
    zonotopic("zf/tightened", ZfSetting { tighten: true, ..ZfSetting::PAPER }),
];

/// Other settings of the zonotopic filter: what the paper says diverges, what holds the truth for certain.
pub const VARIANTS: [Contender; 9] = [
    zonotopic("zf/segments", ZfSetting { rule: StripRule::Segments, ..ZfSetting::PAPER }),
    zonotopic("zf/segments-order-60", ZfSetting { rule: StripRule::Segments, order: 60, ..ZfSetting::PAPER }),
    zonotopic("zf/determinant", ZfSetting { rule: StripRule::Determinant, ..ZfSetting::PAPER }),
    zonotopic("zf/radius-1.3", ZfSetting { radius: 1.3, ..ZfSetting::PAPER }),
    zonotopic("zf/radius-1.4", ZfSetting { radius: 1.4, ..ZfSetting::PAPER }),
    zonotopic("zf/radius-1.5", ZfSetting { radius: 1.5, ..ZfSetting::PAPER }),
    zonotopic("zf/noise-0.6", ZfSetting { noise: 0.6, ..ZfSetting::PAPER }),
    zonotopic("zf/process-3e-4", ZfSetting { process: 3e-4, ..ZfSetting::PAPER }),
    zonotopic("zf/process-1e-3", ZfSetting { process: 1e-3, ..ZfSetting::PAPER }),
];

/// Motion and sensor of the Kalman filters.
type Model = (ByFunction<Reaction>, ByFunction<Pressure>);
