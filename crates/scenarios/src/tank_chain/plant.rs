//! The plant: a chain of tanks, each of which drains into the next.

use estimators::{Relation, System};
use nonlin_bounds::Function;
use rand::{Rng, RngExt};
use scalars::Scalar;
use setrep::{ConstrainedZonotope, Zonotope};

use crate::ScenarioError;
use crate::noise::NoiseKind;
use crate::set_study::{Additive, Trajectory};

/// Bound of the noise on every level after a step.
pub const PROCESS_NOISE: f64 = 1e-3;
/// Bound of the noise on every measured level.
pub const OUTPUT_NOISE: f64 = 0.05;
/// Levels at the start: anything in this range.
pub const START: [f64; 2] = [2.0, 4.0];
/// Where the true levels at the start are drawn from.
pub const TRUE_START: [f64; 2] = [2.2, 3.8];

/// Levels after half a second: `x_i+ = x_i + h kappa (sqrt x_{i-1} - sqrt x_i) + w_i`; the first tank is filled at the rate `0.1 + 0.01 (4 - x_n)`
/// instead, which the last one controls. `h = 0.5`, `kappa = 0.015 sqrt(2 g)`, `g = 9.81`; variables `(x, w)`.
#[derive(Clone, Copy, Debug)]
pub struct Tanks {
    /// Number of tanks.
    pub n: usize,
}

impl Function for Tanks {
    fn variables(&self) -> usize {
        2 * self.n
    }

    fn outputs(&self) -> usize {
        self.n
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let rate = S::decimal("0.0075") * S::decimal("19.62").sqrt();
        let (levels, noises) = x.split_at(self.n);
        // 0.5 (0.1 + 0.01 (4 - x_n)).
        let mut inflow = S::decimal("0.07") - S::decimal("0.005") * levels[self.n - 1];
        for ((y, &level), &noise) in y.iter_mut().zip(levels).zip(noises) {
            let outflow = rate * level.sqrt();
            *y = level + (inflow - outflow) + noise;
            inflow = outflow;
        }
    }
}

/// The measured levels, the first tank and every third: variables `(x, v)`.
#[derive(Clone, Copy, Debug)]
pub struct Levels {
    /// Number of tanks.
    pub n: usize,
}

impl Levels {
    /// Indices of the measured tanks: those numbered 1, 3, 6, 9 and so on.
    pub fn measured(self) -> impl Iterator<Item = usize> {
        std::iter::once(0).chain((2..self.n).step_by(3))
    }
}

impl Function for Levels {
    fn variables(&self) -> usize {
        self.n + self.outputs()
    }

    fn outputs(&self) -> usize {
        self.measured().count()
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        for (k, (y, tank)) in y.iter_mut().zip(self.measured()).enumerate() {
            *y = x[tank] + x[self.n + k];
        }
    }
}

/// The system of `n` tanks.
///
/// # Errors
/// None: the parts fit.
pub fn system(n: usize) -> Result<System, ScenarioError> {
    let outputs = Levels { n }.outputs();
    let process = Zonotope::from_box(&vec![0.0; n], &vec![PROCESS_NOISE; n])?;
    let output = Zonotope::from_box(&vec![0.0; outputs], &vec![OUTPUT_NOISE; outputs])?;
    Ok(System::new(Relation::new(Tanks { n }), process, Relation::new(Levels { n }), output)?)
}

/// All levels at the start that the filters take for possible.
///
/// # Errors
/// None: the box is bounded.
pub fn start(n: usize) -> Result<ConstrainedZonotope, ScenarioError> {
    let [low, high] = START;
    Ok(ConstrainedZonotope::from_box(&vec![0.5 * (low + high); n], &vec![0.5 * (high - low); n])?)
}

/// A run of `steps` steps from true levels drawn from [`TRUE_START`].
///
/// # Errors
/// [`ScenarioError::Truth`] if a step cannot be proven.
pub fn simulate<R: Rng>(n: usize, kind: NoiseKind, steps: usize, rng: &mut R) -> Result<Trajectory, ScenarioError> {
    let (dynamics, measurement) = (Tanks { n }, Levels { n });
    let (process, output) = (vec![PROCESS_NOISE; n], vec![OUTPUT_NOISE; measurement.outputs()]);
    let [low, high] = TRUE_START;
    let start: Vec<f64> = (0..n).map(|_| low + (high - low) * rng.random::<f64>()).collect();
    let plant = Additive { dynamics: &dynamics, process: &process, measurement: &measurement, output: &output };
    plant.simulate(&start, vec![Vec::new(); steps], kind, rng)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::monte_carlo;

    #[test]
    fn one_step_by_hand() {
        let mut y = [0.0; 2];
        Tanks { n: 2 }.eval(&[2.25, 4.0, 0.001, 0.0], &[], &mut y);
        let rate = 0.5 * 0.015 * (2.0 * 9.81_f64).sqrt();
        assert!((y[0] - (2.25 + 0.5 * 0.1 - 1.5 * rate + 0.001)).abs() < 1e-15);
        assert!((y[1] - (4.0 + (1.5 - 2.0) * rate)).abs() < 1e-15);
        assert_eq!(Levels { n: 30 }.measured().collect::<Vec<_>>(), [0, 2, 5, 8, 11, 14, 17, 20, 23, 26, 29]);
        let mut z = [0.0; 1];
        Levels { n: 2 }.eval(&[3.0, 2.0, 0.25], &[], &mut z);
        assert_eq!(z, [3.25]);
    }

    /// Levels stay where the root is smooth, with every kind of noise.
    #[test]
    fn runs_are_proven_for_every_noise() {
        for kind in NoiseKind::ALL {
            for n in [1, 2, 6, 30] {
                let run = simulate(n, kind, 60, &mut monte_carlo::stream(1, "tanks", n)).unwrap();
                assert_eq!((run.steps(), run.outputs[0].len()), (60, Levels { n }.outputs()));
                assert!(run.states.iter().flatten().all(|level| level.lo() > 1.0 && level.hi() < 5.0));
            }
        }
    }
}
