//! Set-valued filters on the examples of papers 003 and 004: truth contract, published numbers, containment, bars of our own filter.

// Helpers outside the test functions fail by panic as well.
#![allow(clippy::unwrap_used)]

mod attitude;
mod containment;
mod planar;
mod polytopes;
mod truth;

use rand_chacha::ChaCha8Rng;
use scenarios::monte_carlo::stream;
use scenarios::set_study::{Contender, Course, RADIUS, Trajectory};

/// Radii of a filter along a trajectory.
fn radii(trajectory: &Trajectory, contender: &Contender) -> Vec<f64> {
    Course::of(trajectory, &mut *contender.start(()).unwrap(), &[RADIUS]).unwrap().values.remove(0)
}

/// The contender of a name.
fn named<'a>(contenders: &'a [Contender], name: &str) -> &'a Contender {
    contenders.iter().find(|contender| contender.method == name).unwrap()
}

/// A random stream of these tests.
fn random(name: &str, run: usize) -> ChaCha8Rng {
    stream(20261122, name, run)
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// So many runs, times the environment variable `ORBITOPE_CASES`.
fn cases(count: usize) -> usize {
    count * std::env::var("ORBITOPE_CASES").ok().and_then(|factor| factor.parse().ok()).unwrap_or(1)
}
