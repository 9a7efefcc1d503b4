//! Outward-rounded interval arithmetic and the scalar trait models are written in.

mod arithmetic;
mod elementary;
mod environment;
mod error;
mod interval;
mod power;
pub mod rounding;
mod scalar;
mod set_operations;
mod stumpff;
mod text;
mod trigonometric;

pub use environment::fp_env_ok;
pub use error::ScalarError;
pub use interval::Interval;
pub use scalar::Scalar;
