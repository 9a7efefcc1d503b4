//! The corpus of 13 kinds of sets against other solvers.

#[path = "../common/mod.rs"]
mod common;

mod agreement;
mod clarabel_oracle;
mod ladder;
mod microlp_oracle;
