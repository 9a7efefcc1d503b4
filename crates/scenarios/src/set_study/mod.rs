//! What the experiments with set-valued filters share: a plant is simulated, filters follow it, sizes and containment are noted.
//!
//! Reading order: [`trajectory`] and [`additive`] (the truth, by the contract of [`crate::truth`]), [`filter`] and [`case`] (what the study asks of a
//! filter and its name), [`course`] (one filter along one trajectory), [`mod@study`] (many runs), [`rows`], [`ratios`] and [`figures`] (tables and curves),
//! [`timing`] (how long the phases of a step take).

pub mod additive;
pub mod case;
pub mod course;
pub mod figures;
pub mod filter;
pub mod ratios;
pub mod rows;
pub mod study;
pub mod tables;
pub mod timing;
pub mod trajectory;

pub use additive::Additive;
pub use case::Case;
pub use course::{Course, End, Measure, RADIUS};
pub use filter::{Contender, SetEstimator};
pub use study::{Cell, study};
pub use trajectory::Trajectory;
