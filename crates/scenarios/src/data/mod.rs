//! Measured data that does not ship with the project: where it lies and how it is read.

mod locate;
mod log_error;
pub mod wifibot;

pub use locate::locate;
pub use log_error::LogError;
