//! Boxes of states in space: what a filter starts from, what it reports, and what it is asked about.

use lie_groups::SO3;
use scalars::Interval;

use super::space::largest_length;
use crate::EstimatorError;
use crate::invariant_strips::check_bounded;

/// A box of states `(R, x_1 .. x_K)`: an attitude `R`, which turns body into world coordinates, and vectors of the world.
///
/// `R = exp(turn) center`, `turn` a rotation vector (rad) in a box along the axes of the world: with the third axis up, its last side is what is
/// not known of the heading, the first two what is not known of the vertical.
///
/// `K = 1` is `SE(3)`; position and velocity are `SE_2(3)`.
#[derive(Debug, Clone, PartialEq)]
pub struct SpatialBox {
    /// The center of the attitudes.
    pub center: SO3<f64>,
    /// Rotation vectors from it, rad, world axes.
    pub turn_rad: [Interval; 3],
    /// Vectors in world coordinates; the first is the position.
    pub vectors: Vec<[Interval; 3]>,
}

impl SpatialBox {
    /// A box in `SE_K(3)`: attitudes within `turn_rad` of `center`, and `K` vectors.
    ///
    /// ```
    /// use estimators::SpatialBox;
    /// use lie_groups::{LieGroup, SO3};
    /// use scalars::Interval;
    /// let (tilt, heading, side) = (Interval::new(-0.1, 0.1)?, Interval::new(-1.0, 1.0)?, Interval::new(-5.0, 5.0)?);
    /// let upright = SpatialBox::new(SO3::identity(), [tilt, tilt, heading], &[[side; 3]]);
    /// assert!(upright.angle_rad() < 1.011);
    /// # Ok::<(), scalars::ScalarError>(())
    /// ```
    #[must_use]
    pub fn new(center: SO3<f64>, turn_rad: [Interval; 3], vectors: &[[Interval; 3]]) -> Self {
        Self { center, turn_rad, vectors: vectors.to_vec() }
    }

    /// The box of the position.
    ///
    /// # Panics
    /// If there is no vector, as indexing a slice does; a filter always has one.
    #[must_use]
    pub fn position(&self) -> &[Interval; 3] {
        &self.vectors[0]
    }

    /// Upper bound of the angle between the center and an attitude of the box, rad, at most `pi` but for rounding.
    #[must_use]
    pub fn angle_rad(&self) -> f64 {
        let length = largest_length(&self.turn_rad);
        // Also for an angle that is not known at all.
        if length < core::f64::consts::PI { length } else { Interval::PI.hi() }
    }

    /// Becomes a copy without allocating.
    pub(super) fn assign(&mut self, other: &Self) {
        self.center = other.center;
        self.turn_rad = other.turn_rad;
        self.vectors.clone_from(&other.vectors);
    }

    /// `Ok` for a box that a filter can start from.
    pub(super) fn check(&self) -> Result<(), EstimatorError> {
        if self.vectors.is_empty() {
            return Err(EstimatorError::Size { what: "vectors of the world", expected: 1, found: 0 });
        }
        crate::error::check_finite("attitude", &self.center.quaternion())?;
        for (index, side) in self.turn_rad.iter().enumerate() {
            if side.is_empty() {
                return Err(EstimatorError::EmptyRange { what: "attitude", index });
            }
        }
        check_bounded("vectors of the world", self.vectors.as_flattened())
    }
}
