//! Tapes: what is recorded, what a replay encloses, how it is printed.
#![allow(clippy::unwrap_used, reason = "test helpers")]

#[path = "../common/mod.rs"]
mod common;

mod backward;
mod display;
mod recording;
mod replay;
