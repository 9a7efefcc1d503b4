//! The filters of paper 002 on the logs: heading, wheel scale and an added lever arm, from position fixes once a second.
//!
//! Reading order: [`fit`] (what the reference says of scale and lever arm), [`study`] (runs), [`report`] (rows, figure, text).

pub mod fit;
pub mod report;
pub mod study;

pub use fit::Fit;
pub use study::{Case, Study};
