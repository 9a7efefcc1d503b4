//! Cartesian product `X x Y = { (x, y) : x in X, y in Y }`.

use super::ConstrainedZonotope;

impl ConstrainedZonotope {
    /// Cartesian product: `<(c, d), diag(G, H), (r, s); diag(A, B), ([a], [b])>`.
    ///
    /// **Guarantee:** exact.
    #[must_use]
    pub fn cartesian_product(&self, other: &Self) -> Self {
        let mut product = Self {
            body: self.body.cartesian_product(&other.body),
            constraints: self.constraints.clone(),
            ranges: self.ranges.clone(),
        };
        product.append_constraints(other);
        product
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
