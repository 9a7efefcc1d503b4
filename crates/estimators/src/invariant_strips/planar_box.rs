//! Boxes of planar states: what a filter starts from, what it reports, and what it is asked about.

use scalars::Interval;

use crate::EstimatorError;

/// A box of states of a planar group: heading, scale, vectors of the world and vectors of the body.
///
/// `fixed` are the vectors whose coordinates are those of the world (position, velocity), `body` those that turn with the body (lever
/// arms). Lengths in the unit of the positions.
///
/// | group | constructor |
/// |---|---|
/// | `SE(2)` | [`se2`](Self::se2) |
/// | `SE_K(2)` | [`se_k2`](Self::se_k2) |
/// | two frames, lever arm | [`lever_arm`](Self::lever_arm) |
/// | two frames, scale and lever arm | [`scale_and_lever_arm`](Self::scale_and_lever_arm) |
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PlanarBox {
    /// Heading in rad, modulo `2 pi`; an interval at least `2 pi` wide, or the whole line, is a heading that is not known at all.
    pub heading_rad: Interval,
    /// Scale of the odometry, positive; the point 1 where it is known.
    pub scale: Interval,
    /// Vectors in world coordinates; the first is the position.
    pub fixed: Vec<[Interval; 2]>,
    /// Vectors in body coordinates.
    pub body: Vec<[Interval; 2]>,
}

impl PlanarBox {
    /// A box in `SE(2)`.
    ///
    /// ```
    /// use estimators::PlanarBox;
    /// use scalars::Interval;
    /// let side = Interval::new(-5.0, 5.0)?;
    /// let anywhere = PlanarBox::se2(Interval::ENTIRE, [side, side]);
    /// assert_eq!(anywhere.scale, Interval::ONE);
    /// # Ok::<(), scalars::ScalarError>(())
    /// ```
    #[must_use]
    pub fn se2(heading_rad: Interval, position: [Interval; 2]) -> Self {
        Self { heading_rad, scale: Interval::ONE, fixed: vec![position], body: Vec::new() }
    }

    /// A box in `SE_K(2)`, `K` vectors of the world; the first is the position.
    #[must_use]
    pub fn se_k2(heading_rad: Interval, vectors: &[[Interval; 2]]) -> Self {
        Self { heading_rad, scale: Interval::ONE, fixed: vectors.to_vec(), body: Vec::new() }
    }

    /// A box in the two-frame group of a vehicle whose sensor sits at an unknown place (paper 002, Problem 2).
    #[must_use]
    pub fn lever_arm(heading_rad: Interval, position: [Interval; 2], arm: [Interval; 2]) -> Self {
        Self { heading_rad, scale: Interval::ONE, fixed: vec![position], body: vec![arm] }
    }

    /// A box in the two-frame group of a vehicle with unknown scale of the odometry and lever arm (paper 002, Problem 3).
    #[must_use]
    pub fn scale_and_lever_arm(
        heading_rad: Interval,
        scale: Interval,
        position: [Interval; 2],
        arm: [Interval; 2],
    ) -> Self {
        Self { heading_rad, scale, fixed: vec![position], body: vec![arm] }
    }

    /// The box of the position.
    ///
    /// # Panics
    /// If there is no vector of the world, as indexing a slice does; a filter always has one.
    #[must_use]
    pub fn position(&self) -> &[Interval; 2] {
        &self.fixed[0]
    }

    /// Area of the box of the position, rounded up.
    ///
    /// # Panics
    /// As [`position`](Self::position).
    #[must_use]
    pub fn position_area(&self) -> f64 {
        let [x, y] = self.fixed[0];
        scalars::rounding::mul_up(x.width(), y.width())
    }

    /// Width of the heading, at most `2 pi` (rounded up); NaN for an empty one.
    #[must_use]
    pub fn heading_width_rad(&self) -> f64 {
        let (width, turn) = (self.heading_rad.width(), 2.0 * Interval::PI.hi());
        if width > turn { turn } else { width }
    }

    /// The two ends of the heading, each reduced to about `(-pi, pi]`; the heading runs counterclockwise from the first to the second.
    ///
    /// Rounded to nearest, for display; `None` if the heading is not known at all.
    #[must_use]
    pub fn heading_ends_rad(&self) -> Option<(f64, f64)> {
        let turn = 2.0 * core::f64::consts::PI;
        if self.heading_rad.width() >= turn {
            return None;
        }
        let reduced = |angle: f64| angle - turn * (angle / turn).round();
        Some((reduced(self.heading_rad.lo()), reduced(self.heading_rad.hi())))
    }

    /// `Ok` for a box that a filter can start from.
    pub(super) fn check(&self) -> Result<(), EstimatorError> {
        if self.fixed.is_empty() {
            return Err(EstimatorError::Size { what: "vectors of the world", expected: 1, found: 0 });
        }
        if self.heading_rad.is_empty() {
            return Err(EstimatorError::EmptyRange { what: "heading", index: 0 });
        }
        check_bounded("scale", &[self.scale])?;
        if self.scale.lo() <= 0.0 {
            return Err(EstimatorError::NotPositive { what: "scale", index: 0, value: self.scale.lo() });
        }
        check_bounded("vectors of the world", self.fixed.as_flattened())?;
        check_bounded("vectors of the body", self.body.as_flattened())
    }
}

/// `Ok` if all sides are nonempty and bounded.
pub(crate) fn check_bounded(what: &'static str, sides: &[Interval]) -> Result<(), EstimatorError> {
    for (index, side) in sides.iter().enumerate() {
        if side.is_empty() {
            return Err(EstimatorError::EmptyRange { what, index });
        }
        if !side.is_bounded() {
            let value = if side.lo().is_finite() { side.hi() } else { side.lo() };
            return Err(EstimatorError::NotFinite { what, index, value });
        }
    }
    Ok(())
}
