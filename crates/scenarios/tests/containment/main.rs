//! The truth contract, and the comparison of truth and sets.

mod errors;
mod truth;
mod watch;
