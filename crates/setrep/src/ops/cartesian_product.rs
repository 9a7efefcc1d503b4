//! Cartesian product `X x Y = { (x, y) : x in X, y in Y }`.

use crate::{Matrix, Zonotope};

impl Zonotope {
    /// Cartesian product of two zonotopes.
    ///
    /// `<c, G, r> x <d, H, s> = <(c, d), diag(G, H), (r, s)>`.
    ///
    /// **Guarantee:** exact.
    ///
    /// ```
    /// # use setrep::Zonotope;
    /// let x = Zonotope::from_box(&[0.0], &[1.0])?;
    /// let y = Zonotope::point(&[5.0])?;
    /// assert_eq!(x.cartesian_product(&y), Zonotope::from_box(&[0.0, 5.0], &[1.0, 0.0])?);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    #[must_use]
    pub fn cartesian_product(&self, other: &Self) -> Self {
        let (n, left) = (self.dim(), self.num_generators());
        let mut generators = Matrix::zeros(n + other.dim(), left + other.num_generators());
        for (j, column) in self.generators.columns().enumerate() {
            generators.col_mut(j)[..n].copy_from_slice(column);
        }
        for (j, column) in other.generators.columns().enumerate() {
            generators.col_mut(left + j)[n..].copy_from_slice(column);
        }
        Self {
            center: [self.center.as_slice(), &other.center].concat(),
            generators,
            remainder: [self.remainder.as_slice(), &other.remainder].concat(),
        }
    }
}
