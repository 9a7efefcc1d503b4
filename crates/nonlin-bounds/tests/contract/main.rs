//! Contractors: no solution is lost, known boxes are found, contradictions are proven and named.
#![allow(clippy::unwrap_used, reason = "test helpers")]

#[path = "../common/mod.rs"]
mod common;

mod containment;
mod known_boxes;
mod newton;
mod programs;
mod reverse;
mod robustness;
