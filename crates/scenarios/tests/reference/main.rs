//! Experiments against the papers' numbers, independent computations and values by hand.

// Helpers outside the test functions fail by panic as well.
#![allow(clippy::unwrap_used)]

mod batch_reactor;
mod determinism;
mod images;
mod metrics;
mod published;
mod sound;
mod tank_chain;
mod vehicle_polar;
mod wheel_lever;
mod wifibot;
