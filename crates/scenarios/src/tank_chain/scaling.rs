//! How radius and time of a step grow with the number of tanks.

use std::time::Instant;

use super::contenders::contenders;
use super::plant::simulate;
use crate::noise::NoiseKind;
use crate::set_study::Contender;
use crate::set_study::course::{follow, radius};
use crate::{Context, ScenarioError, monte_carlo};

/// Steps of a run: enough for a re-encoding of the filter that does so every tenth step.
pub const STEPS: usize = 12;

/// One run of a filter along a chain.
#[derive(Clone, Debug)]
pub struct Point {
    /// Number of tanks.
    pub n: usize,
    /// The filter's name.
    pub method: String,
    /// Radius after [`STEPS`] steps.
    pub radius: f64,
    /// Time of a step, seconds.
    pub step_s: f64,
}

/// One run a size and filter, with the same noises for all filters of a size.
///
/// # Errors
/// Those of the filters; [`ScenarioError::Truth`].
pub fn points(context: &Context<'_>, sizes: &[usize]) -> Result<Vec<Point>, ScenarioError> {
    let by_size = monte_carlo::run(context, "tank-chain, sizes", sizes.len(), |index, rng| {
        let n = sizes[index];
        let run = simulate(n, NoiseKind::Uniform, STEPS, rng)?;
        let point = |contender: &Contender| {
            let (mut filter, mut last) = (contender.start(())?, f64::INFINITY);
            let start = Instant::now();
            follow(&run, &mut *filter, &mut |_| {}, &mut |k, filter| {
                if k == STEPS {
                    last = radius(filter.hull());
                }
                Ok(())
            })?;
            let step_s = start.elapsed().as_secs_f64() / run.outputs.len() as f64;
            Ok(Point { n, method: contender.method.clone(), radius: last, step_s })
        };
        contenders(n).iter().map(point).collect::<Result<Vec<_>, ScenarioError>>()
    })?;
    Ok(by_size.into_iter().flatten().collect())
}

/// Exponent of the power law through `(x, y)` that fits best in logarithms; none for less than two points.
#[must_use]
pub fn exponent(points: &[(f64, f64)]) -> Option<f64> {
    let count = points.len() as f64;
    let mean = |pick: fn(&(f64, f64)) -> f64| points.iter().map(|point| pick(point).ln()).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let (covariance, variance) = points.iter().fold((0.0, 0.0), |(c, v), point| {
        let dx = point.0.ln() - x;
        (c + dx * (point.1.ln() - y), v + dx * dx)
    });
    (points.len() > 1).then(|| covariance / variance)
}

#[cfg(test)]
mod tests {
    use super::exponent;

    #[test]
    fn a_power_law_is_recovered() {
        let cubes: Vec<_> = [1.0, 2.0, 5.0].map(|x: f64| (x, 7.0 * x.powi(3))).into();
        assert!((exponent(&cubes).unwrap() - 3.0).abs() < 1e-12);
        assert_eq!(exponent(&cubes[..1]), None);
    }
}
