//! The corpus of 13 kinds of sets against other solvers.
#![allow(clippy::unwrap_used, reason = "a failing unwrap is a failing test")]

#[path = "../common/mod.rs"]
mod common;

mod agreement;
mod clarabel_oracle;
mod ladder;
mod microlp_oracle;
