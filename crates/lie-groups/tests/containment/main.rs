//! The interval groups: every exact image of a point of a box lies in the enclosure, and the enclosure is not much wider.

#![allow(clippy::unwrap_used)]

#[path = "../support/mod.rs"]
mod support;

mod boxes;
mod elements;
mod fixtures;
mod functions;
mod groups;
mod hard;
mod size;
