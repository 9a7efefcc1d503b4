//! Identities that hold for every model and group.

#![allow(clippy::unwrap_used, reason = "a failed unwrap is a failed test")]

#[path = "../support/mod.rs"]
mod support;

mod allocations;
mod coordinates;
mod gains;
mod sides;
mod splitting;
