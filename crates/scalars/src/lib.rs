//! Outward-rounded interval arithmetic and the scalar trait models are written in.
//!
//! [`Interval`] is a closed set of real numbers whose every operation returns a superset of the exact image, rounding
//! included; [`Scalar`] is the trait that lets one generic model run over `f64` and over intervals.
//!
//! ```
//! use scalars::{Interval, Scalar};
//!
//! /// A model, written once.
//! fn area<S: Scalar>(radius: S) -> S {
//!     S::pi() * radius.sqr()
//! }
//!
//! let radius = Interval::decimal("0.1").hull(Interval::decimal("0.2"));
//! assert!(area(radius).contains(area(0.15_f64)));
//! assert_eq!(format!("{:.4}", area(radius)), "[0.0314, 0.1257]");
//! ```
//!
//! What the promise rests on: round-to-nearest without flush-to-zero ([`fp_env_ok`]), and elementary functions of `pxfm`
//! that are right to two units in the last place.
//!
//! Features: `serde` (off by default).

mod arithmetic;
mod display;
mod elementary;
mod environment;
mod error;
mod interval;
mod literal;
mod power;
pub mod rounding;
mod scalar;
#[cfg(feature = "serde")]
mod serialization;
mod set_operations;
mod stumpff;
mod trigonometric;

pub use environment::fp_env_ok;
pub use error::ScalarError;
pub use interval::Interval;
pub use scalar::Scalar;
