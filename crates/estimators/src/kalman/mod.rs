//! Kalman filters: linear, extended and unscented, on vector spaces and on Lie groups.
//!
//! One filter, [`Kalman`], whose rule carries a [`Gaussian`] through motion and sensor: derivatives ([`Ekf`]; [`Kf`] for a
//! [`LinearModel`]) or sigma points ([`Ukf`]). What an error is says a [`Chart`]: `x - xhat` ([`Flat`]), or the left- or right-invariant
//! error on a group ([`OnGroup`]). A model is a [`Motion`] and a [`Sensor`]: one type, or a pair; [`ByFunction`] makes them of the
//! functions that the set-valued filters take.
//!
//! A [`Track`] remembers the predictions of an [`Ekf`] or a [`Kf`] and smooths them backwards. [`wheels`] has the invariant filters of paper
//! 002 for a wheeled robot whose wheel radius and antenna are not known.
//!
//! Reading order: `chart`, `gaussian` with `root`, `model`, `by_function`; `innovation` and `filter`; `ekf`, `linear`, `smoother`;
//! `sigma_points` and `ukf`; `wheels`.

mod by_function;
mod chart;
mod ekf;
mod filter;
mod gaussian;
mod innovation;
mod linear;
mod model;
mod root;
mod sigma_points;
mod smoother;
mod ukf;
pub mod wheels;

pub use by_function::ByFunction;
pub use chart::{Chart, Flat, OnGroup};
pub use ekf::{Ekf, Linearization};
pub use filter::{Forecast, Kalman, Observe};
pub use gaussian::Gaussian;
pub use innovation::{Innovation, Joint};
pub use linear::{Kf, LinearModel};
pub use model::{Motion, Sensor, SmoothMotion, SmoothSensor};
pub use sigma_points::SigmaPoints;
pub use smoother::Track;
pub use ukf::{Ukf, Unscented};
