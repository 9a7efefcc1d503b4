//! The state lies in the set where the filters promise it, and near it where they do not.

#![allow(clippy::unwrap_used, reason = "a failed unwrap is a failed test")]

#[path = "../support/mod.rs"]
mod support;

mod hard_truth;
mod hulls;
mod linear;
mod spatial_strips;
mod strips;
mod strips_calibration;
mod strips_extremes;
mod strips_groups;
mod strips_hard;
mod strips_spans;
mod vehicle;
