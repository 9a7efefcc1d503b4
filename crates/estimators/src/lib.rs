//! Set-membership filters on vector spaces and Lie groups.
mod error;
mod error_set;
mod estimator;
pub mod gain;
mod inzsmf;
mod zsmf;

pub use error::EstimatorError;
pub use estimator::{Estimator, Guarantee};
pub use gain::{Gain, f_radius_gain, observability_rank, place};
pub use inzsmf::{ErrorSide, InZsmf, Left, Outputs, Right};
pub use zsmf::{Model, Zsmf};
