//! Noises of the vehicle, process and output together: those of the other experiments, every single vertex, and dwelling at vertices.

use rand::{Rng, RngExt};

use crate::monte_carlo::stream;
use crate::noise::{BoundedNoise, MARGIN, NoiseKind};
use crate::vehicle::{OUTPUT_BOUNDS, PROCESS_BOUNDS, Truth, Vehicle};
use crate::{Context, ScenarioError};

/// Mean number of steps at a vertex before another is drawn.
const DWELL_STEPS: f64 = 33.0;
/// Vertices of the box of `(w_theta, w_long, w_trans, v_1, v_2)`.
pub const VERTICES: u8 = 32;

/// How the noises of a run are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drive {
    /// Every component uniform between its bounds.
    Uniform,
    /// A random vertex at every step.
    Vertices,
    /// One random vertex for the whole run.
    ConstantVertex,
    /// A random vertex, left with probability 1/33 at every step.
    Dwell,
    /// The vertex with this number for the whole run; bit `i` says the sign of component `i`.
    Vertex(u8),
}

impl Drive {
    /// The drives of the tables.
    pub const ALL: [Self; 4] = [Self::Uniform, Self::Vertices, Self::ConstantVertex, Self::Dwell];

    /// The name used in rows and tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Uniform => NoiseKind::Uniform.name(),
            Self::Vertices => NoiseKind::Vertices.name(),
            Self::ConstantVertex => NoiseKind::ConstantVertex.name(),
            Self::Dwell => "dwelling at vertices",
            Self::Vertex(_) => "every vertex",
        }
    }

    /// One run with noises in boxes `excess` times those that the filters are told.
    fn simulate(self, excess: f64, steps: usize, rng: &mut impl Rng) -> Result<Truth, ScenarioError> {
        let ([w1, w2, w3], [v1, v2]) = (PROCESS_BOUNDS, OUTPUT_BOUNDS);
        let bounds = [w1, w2, w3, v1, v2].map(|bound| excess * bound);
        let inner = bounds.map(|bound| bound - MARGIN);
        let kind = if self == Self::Uniform { NoiseKind::Uniform } else { NoiseKind::Vertices };
        let mut drawn = BoundedNoise::new(kind, bounds);
        let mut held = inner.map(|bound| if rng.random::<bool>() { bound } else { -bound });
        if let Self::Vertex(number) = self {
            held = std::array::from_fn(
                |component| if number >> component & 1 == 1 { inner[component] } else { -inner[component] },
            );
        }
        let mut draw = || {
            let noise = match self {
                Self::Uniform | Self::Vertices => drawn.draw(rng),
                Self::ConstantVertex | Self::Vertex(_) => held,
                Self::Dwell => {
                    if rng.random::<f64>() * DWELL_STEPS < 1.0 {
                        held = inner.map(|bound| if rng.random::<bool>() { bound } else { -bound });
                    }
                    held
                }
            };
            ([noise[0], noise[1], noise[2]], [noise[3], noise[4]])
        };
        Ok(Vehicle::new().simulate_with(steps, excess, &mut draw)?)
    }
}

/// The truth of run `run`: `steps` periods with noises of the drive in boxes `excess` times those of the paper.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step cannot be proven.
pub fn truth_of(
    context: &Context<'_>,
    drive: Drive,
    excess: f64,
    steps: usize,
    run: usize,
) -> Result<Truth, ScenarioError> {
    drive.simulate(excess, steps, &mut stream(context.seed, "guaranteed-invariant", run))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every vertex is simulated within the bounds to 1e-12 and known to a few ulp.
    #[test]
    fn vertices_are_at_the_bounds_and_proven() {
        let context = Context::new(3);
        for number in 0..VERTICES {
            let truth = truth_of(&context, Drive::Vertex(number), 1.0, 20, 0).unwrap();
            assert!(truth.widest() < 1e-13);
            for (state, output) in truth.states.iter().zip(&truth.outputs) {
                let off = (output[0] - state.rounded().position[0]).abs();
                assert!((off - OUTPUT_BOUNDS[0]).abs() < 2e-12, "{off}");
            }
        }
    }

    /// A dwelling noise leaves its vertex now and then, and not at every step.
    #[test]
    fn dwelling_noises_dwell() {
        let truth = truth_of(&Context::new(3), Drive::Dwell, 1.0, 600, 0).unwrap();
        let sign = |k: usize| truth.outputs[k][0] > truth.states[k].rounded().position[0];
        let changes = (1..600).filter(|&k| sign(k) != sign(k - 1)).count();
        assert!((2..40).contains(&changes), "{changes}");
    }

    /// Noises beyond the bounds are proven to stay within the wider ones.
    #[test]
    fn excess_widens_the_bounds() {
        let truth = truth_of(&Context::new(1), Drive::Vertex(31), 1.2, 5, 0).unwrap();
        let off = truth.outputs[0][0] - truth.states[0].rounded().position[0];
        assert!((off - 1.2).abs() < 2e-12, "{off}");
    }
}
