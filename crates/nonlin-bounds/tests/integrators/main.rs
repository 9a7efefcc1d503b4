//! Integrators: the discrete models are what they say, and the flow encloses solutions known in closed form.
#![allow(clippy::unwrap_used, reason = "test helpers")]

mod discrete;
mod flow;
mod quadrature;
