//! Identities that hold for every model and group.

#[path = "../support/mod.rs"]
mod support;

mod allocations;
mod coordinates;
mod gains;
mod sides;
mod splitting;
