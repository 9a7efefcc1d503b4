//! Cartesian product `X x Y = { (x, y) : x in X, y in Y }`.

use crate::Zonotope;

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
        let mut product = self.clone();
        product.product_assign(other);
        product
    }

    /// [`cartesian_product`](Self::cartesian_product) in place; allocates nothing within the capacity of the set.
    ///
    /// **Guarantee:** exact.
    pub fn product_assign(&mut self, other: &Self) {
        let (n, left) = (self.dim(), self.num_generators());
        self.center.extend_from_slice(&other.center);
        self.remainder.extend_from_slice(&other.remainder);
        self.generators.push_zero_rows(other.dim());
        self.generators.push_zero_cols(other.num_generators());
        for (j, column) in other.generators.columns().enumerate() {
            self.generators.col_mut(left + j)[n..].copy_from_slice(column);
        }
    }
}
