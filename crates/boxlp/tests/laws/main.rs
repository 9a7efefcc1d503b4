//! What must hold for every problem: independence of history, graceful limits, no allocation, typed errors.
#![allow(clippy::unwrap_used, reason = "a failing unwrap is a failing test")]

#[path = "../common/mod.rs"]
mod common;

mod allocation;
mod errors;
mod history;
mod limits;
