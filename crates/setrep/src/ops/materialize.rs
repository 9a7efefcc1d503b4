//! The box remainder as generators.

use crate::Zonotope;

impl Zonotope {
    /// Turns the box remainder into generators: `<c, G, r>` becomes `<c, [G diag(r)], 0>`, zero columns left out.
    ///
    /// **Guarantee:** exact (the same set).
    ///
    /// ```
    /// # use setrep::Zonotope;
    /// let mut x = Zonotope::from_box(&[0.0, 0.0], &[1.0, 0.0])?;
    /// x.materialize();
    /// assert_eq!((x.num_generators(), x.remainder()), (1, &[0.0, 0.0][..]));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn materialize(&mut self) {
        for (i, r) in self.remainder.iter_mut().enumerate() {
            if *r > 0.0 {
                self.generators.push_axis(i, *r);
                *r = 0.0;
            }
        }
    }
    /// Turns the components of the box remainder that are of model size into generators: those above `1e-9` of the generators' extent
    /// `sum_j |G_ij|` and above `1e-12` of the center `|c_i|` in their row. What stays is of the size of rounding.
    ///
    /// **Guarantee:** exact (the same set).
    ///
    /// ```
    /// # use setrep::{Matrix, Zonotope};
    /// let mut x = Zonotope::with_remainder(&[1.0, 1.0], &Matrix::identity(2), &[1e-3, 1e-15])?;
    /// x.materialize_model_size();
    /// assert_eq!((x.num_generators(), x.remainder()), (3, &[0.0, 1e-15][..]));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn materialize_model_size(&mut self) {
        for i in 0..self.dim() {
            let extent = self.generators.columns().map(|g| g[i].abs()).sum();
            if is_model_size(self.remainder[i], extent, self.center[i]) {
                self.generators.push_axis(i, self.remainder[i]);
                self.remainder[i] = 0.0;
            }
        }
    }
}

/// Whether the box remainder `r` is more than rounding beside the generators' extent and the center in its row.
pub(crate) fn is_model_size(r: f64, extent: f64, center: f64) -> bool {
    r > 1e-9 * extent && r > 1e-12 * center.abs()
}
