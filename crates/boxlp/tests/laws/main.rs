//! What must hold for every problem: independence of history, graceful limits, no allocation, typed errors.

#[path = "../common/mod.rs"]
mod common;

mod allocation;
mod errors;
mod history;
mod limits;
