//! Interval hull: the smallest axis-aligned box around a set.

use scalars::Interval;

use crate::bounds::{add_abs_row_sums, add_lengths, sum_bound};
use crate::{IntervalVector, Part, SetError, Zonotope};

impl Zonotope {
    /// Interval hull `[c_i - h_i, c_i + h_i]`, `h_i = sum_j |G_ij| + r_i`.
    ///
    /// **Guarantee:** superset of the exact hull, hence of the set; wider by rounding only. A bound that overflows is infinite.
    ///
    /// ```
    /// # use setrep::{Matrix, Zonotope};
    /// let set = Zonotope::new(&[1.0, 0.0], &Matrix::from_rows(&[&[1.0, 2.0], &[0.0, -1.0]])?)?;
    /// assert!(set.interval_hull().contains(&[4.0, -1.0]));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    #[must_use]
    pub fn interval_hull(&self) -> IntervalVector {
        let mut radii = vec![0.0; self.dim()];
        self.hull_radii(&mut radii);
        self.center.iter().zip(&radii).map(|(&c, &h)| Interval::point(c).inflate(h)).collect()
    }

    /// [`interval_hull`](Self::interval_hull) into a slice of length `n`; allocates nothing.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if the slice has another length.
    pub fn interval_hull_into(&self, hull: &mut [Interval]) -> Result<(), SetError> {
        SetError::check_size(Part::Output, self.dim(), hull.len())?;
        for (i, side) in hull.iter_mut().enumerate() {
            let sum: f64 = self.generators.columns().map(|column| column[i].abs()).sum();
            let radius = add_lengths(sum_bound(sum, self.num_generators()), self.remainder[i]);
            *side = Interval::point(self.center[i]).inflate(radius);
        }
        Ok(())
    }

    /// Upper bounds of the half-widths `sum_j |G_ij| + r_i` into `radii` (zeros on entry, length `n`).
    pub(crate) fn hull_radii(&self, radii: &mut [f64]) {
        add_abs_row_sums(self.generators.as_slice(), radii);
        for (radius, &r) in radii.iter_mut().zip(&self.remainder) {
            *radius = add_lengths(sum_bound(*radius, self.num_generators() + 4), r);
        }
    }
}
