//! Experiment `inzsmf`: the invariant zonotopic set-membership filter of paper 000 against its Euclidean counterpart.

pub mod cases;
pub mod published;
pub mod study;
pub mod tracking;
