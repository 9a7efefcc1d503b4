//! The filters of the experiment.

use estimators::Relation;
use scalars::Interval;
use setrep::{Complexity, Strip};

use super::paper::METHODS;
use super::plant::{AttitudeStep, start, system};
use super::textbook::TextbookStep;
use crate::set_study::{Case, Contender};
use crate::{Mode, ScenarioError};

/// The bound on the measurement noise that the paper prints.
pub const PRINTED_NOISE: f64 = 0.15;
/// The bound at which all of its Table 3 comes out.
pub const SMALLER_NOISE: f64 = 0.10;
/// Our filters: with linear programs, without.
pub const RANGED: [&str; 2] = ["rcz", "rcz/cheap"];
/// What is not the paper's: its first-order filters with our eliminations, and our filters.
pub const OURS: [&str; 5] = ["czfo/compared", "czfo+c/compared", "czfo+fc/compared", RANGED[0], RANGED[1]];

/// The names of all filters: those of the paper, then ours.
#[must_use]
pub fn all() -> Vec<&'static str> {
    METHODS.into_iter().chain(OURS).collect()
}

/// Names of the filters on zonotopes.
#[must_use]
pub fn is_zonotopic(method: &str) -> bool {
    method.starts_with("zmv") || method.starts_with("zfo")
}

/// Filters of these names for a bound on the measurement noise, all of them rigorous.
///
/// # Errors
/// None for a bound that is finite.
pub fn rigorous(noise: f64, names: &[&str]) -> Result<Vec<Contender>, ScenarioError> {
    contenders(Relation::new(AttitudeStep), noise, names, Mode::Rigorous)
}

/// The zonotope filters on the dynamics as they are printed: what the paper's figures of them imply.
///
/// # Errors
/// None for a bound that is finite.
pub fn published(noise: f64) -> Result<Vec<Contender>, ScenarioError> {
    let names: Vec<&str> = METHODS.into_iter().filter(|name| is_zonotopic(name)).collect();
    contenders(Relation::new(TextbookStep), noise, &names, Mode::Published)
}

fn contenders(step: Relation, noise: f64, names: &[&str], mode: Mode) -> Result<Vec<Contender>, ScenarioError> {
    let unit = |i: usize| -> [f64; 4] { std::array::from_fn(|k| if k == i { 1.0 } else { 0.0 }) };
    let unit_range = Interval::ONE.hull(-Interval::ONE);
    let feasible = (0..4).map(|i| Strip::new(&unit(i), unit_range)).collect::<Result<Vec<_>, _>>()?;
    let limit = Complexity { generators: 12, constraints: 5 };
    let case = Case { system: system(step, noise)?, start: start()?, limit, feasible };
    case.contenders(names, mode)
}
