//! The papers' experiments: plants, simulators, noise, metrics, Monte Carlo runs, figures.
//!
//! An [`Experiment`] is found in [`all`], is given a [`Context`] and hands back an [`Output`]: rows of numbers ([`results`]), a text
//! ([`report`]), figures ([`figure`]) and curves ([`curve`]), all in memory. Random streams and parallel runs come from [`monte_carlo`];
//! what experiments with set-valued filters share is in [`set_study`], those of paper 004 in [`polytopes`].

pub mod batch_reactor;
pub mod contender;
pub mod contest;
pub mod curve;
pub mod cz_attitude;
pub mod cz_planar;
pub mod data;
mod error;
pub mod experiment;
pub mod figure;
pub mod guaranteed_invariant;
pub mod html;
pub mod images;
pub mod inzsmf;
pub mod metrics;
pub mod monte_carlo;
pub mod noise;
pub mod polytope_planar;
pub mod polytopes;
pub mod published;
pub mod region;
pub mod report;
pub mod results;
pub mod set_study;
pub mod tank_chain;
pub mod truth;
pub mod unicycle;
pub mod vehicle;
pub mod vehicle_polar;
pub mod wheel_lever;
pub mod wheel_lever_3d;
pub mod wifibot;

pub use curve::Curve;
pub use error::ScenarioError;
pub use experiment::{Context, Experiment, Output, Progress, all};
pub use figure::Figure;
pub use report::{Report, Table};
pub use results::{Mode, Results, Row, Status};
