//! Cartesian product `X x Y = { (x, y) : x in X, y in Y }`.

use super::ConstrainedZonotope;
use crate::Zonotope;

impl ConstrainedZonotope {
    /// Cartesian product: `<(c, d), diag(G, H), (r, s); diag(A, B), ([a], [b])>`.
    ///
    /// **Guarantee:** exact.
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
        self.body.product_assign(&other.body);
        self.append_constraints(other);
    }

    /// Cartesian product with a zonotope, in place.
    ///
    /// **Guarantee:** exact.
    pub fn product_assign_zonotope(&mut self, other: &Zonotope) {
        self.body.product_assign(other);
        self.pad_constraints();
    }

    /// Appends the columns and rows of `other`'s constraints, block-diagonally; the body has `other`'s generators already.
    pub(super) fn append_constraints(&mut self, other: &Self) {
        let (columns, rows) = (self.constraints.cols(), self.ranges.len());
        self.constraints.push_zero_cols(other.constraints.cols());
        self.constraints.push_zero_rows(other.ranges.len());
        for j in 0..other.constraints.cols() {
            self.constraints.col_mut(columns + j)[rows..].copy_from_slice(other.constraints.col(j));
        }
        self.ranges.extend_from_slice(&other.ranges);
    }
}
