//! Is a polytope empty, and why; a point deep inside it.

use scalars::Interval;
use scalars::rounding::{div_down, sqrt_up};

use super::vertices::Vertices;
use super::{HPolytope, MAX_FACES};
use crate::{IntervalVector, SetError};

/// Whether a set is empty, with the evidence.
#[derive(Debug, Clone, PartialEq)]
pub enum Feasibility {
    /// The half-spaces with these indices, at most `n + 1`, already have no common point, and each of them is needed for that.
    ProvenEmpty {
        /// Row indices, increasing.
        rows: Vec<usize>,
    },
    /// The box holds a point of the set.
    ProvenNonEmpty {
        /// An enclosure of one vertex.
        witness: IntervalVector,
    },
    /// The set is unbounded, and nonempty: it has no vertex to show, or a direction to infinity.
    ProvenUnbounded,
}

impl HPolytope {
    /// Whether the set is empty. Never undecided: the enumeration behind it is exact.
    ///
    /// The certificate of emptiness is an irreducible infeasible subsystem (found by leaving out rows one at a time), which a reader can
    /// check by himself: Helly's theorem bounds its size by `n + 1`.
    ///
    /// # Errors
    /// [`SetError::OverBudget`], [`SetError::Overflow`].
    ///
    /// ```
    /// # use setrep::{Feasibility, HPolytope, Matrix};
    /// let h = Matrix::from_rows(&[&[1.0], &[-1.0], &[2.0]])?;
    /// let empty = HPolytope::new(h, &[1.0, -1.5, 7.0])?;
    /// assert_eq!(empty.emptiness()?, Feasibility::ProvenEmpty { rows: vec![0, 1] });
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn emptiness(&self) -> Result<Feasibility, SetError> {
        match Vertices::enumerate(self, MAX_FACES) {
            Ok(vertices) => {
                let witness = IntervalVector::from_center(vertices.mids.col(0), vertices.radii.col(0))?;
                Ok(Feasibility::ProvenNonEmpty { witness })
            }
            Err(SetError::Unbounded) => Ok(Feasibility::ProvenUnbounded),
            Err(SetError::EmptySet) => Ok(Feasibility::ProvenEmpty { rows: self.infeasible_rows()? }),
            Err(error) => Err(error),
        }
    }

    /// Row indices of an irreducible infeasible subsystem of an empty set.
    fn infeasible_rows(&self) -> Result<Vec<usize>, SetError> {
        let mut rows: Vec<usize> = (0..self.num_half_spaces()).collect();
        let is_empty = |rows: &[usize]| match Vertices::enumerate(&self.select(rows), MAX_FACES) {
            Err(SetError::EmptySet) => Ok(true),
            Ok(_) | Err(SetError::Unbounded | SetError::Overflow { .. }) => Ok(false),
            Err(error) => Err(error),
        };
        let mut i = 0;
        while i < rows.len() {
            let mut fewer = rows.clone();
            fewer.remove(i);
            if is_empty(&fewer)? {
                rows = fewer;
            } else {
                i += 1;
            }
        }
        Ok(rows)
    }

    /// The mean of the vertices, and a proven lower bound of its distance to the boundary: a ball of this radius lies in the set.
    ///
    /// Not the Chebyshev centre, whose ball is the largest; the radius is positive whenever the set has interior points that rounding
    /// does not hide, and not positive (perhaps negative, by rounding) for flat sets.
    ///
    /// **Guarantee:** `{ x : |x - center|_2 <= radius }` is a subset of the set if `radius >= 0`.
    ///
    /// # Errors
    /// As [`to_v_polytope`](Self::to_v_polytope).
    pub fn interior_point(&self) -> Result<(Vec<f64>, f64), SetError> {
        let center = self.to_v_polytope()?.column_mean();
        let mut radius = f64::INFINITY;
        for (i, &offset) in self.offsets.iter().enumerate() {
            let terms = || self.normal(i).zip(&center);
            let slack = terms().fold(Interval::point(offset), |slack, (a, &x)| slack - Interval::point(a).scale(x));
            let length = sqrt_up(terms().fold(Interval::ZERO, |sum, (a, _)| sum + Interval::point(a).sqr()).hi());
            if length > 0.0 {
                radius = radius.min(div_down(slack.lo(), length));
            }
        }
        Ok((center, radius))
    }
}
