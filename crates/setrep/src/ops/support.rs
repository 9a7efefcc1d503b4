//! Support function `h(d) = max { d'x : x in X }`.

use scalars::rounding::{add_up, mul_up, up};

use crate::bounds::{gamma, underflow_bound};
use crate::{Part, SetError, Zonotope};

impl Zonotope {
    /// Support function `h(d) = d'c + sum_j |d'g_j| + |d|'r`, shape `d: n`. Allocates nothing.
    ///
    /// **Guarantee:** an upper bound of the exact value, above it by rounding only; `inf` where it overflows.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in the direction.
    ///
    /// ```
    /// # use setrep::Zonotope;
    /// let square = Zonotope::from_box(&[1.0, 0.0], &[1.0, 1.0])?;
    /// let h = square.support(&[1.0, 1.0])?;
    /// assert!((3.0..3.0 + 1e-14).contains(&h));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn support(&self, direction: &[f64]) -> Result<f64, SetError> {
        SetError::check_size(Part::Direction, self.dim(), direction.len())?;
        SetError::check_finite(Part::Direction, direction.len(), direction)?;
        let (value, error) = self.support_with_error(direction);
        Ok(add_up(value, error))
    }

    /// The support function in plain floating point, and a bound of its error (`inf` or NaN beside a value that overflows).
    ///
    /// Value and error bound are sums of the same products, at most `n + ng + 2` roundings deep: the error is at most
    /// `gamma_k |d|'(|c| + sum_j |g_j| + r)` plus underflow, and `gamma_2k` absorbs the rounding of that sum itself.
    pub(crate) fn support_with_error(&self, direction: &[f64]) -> (f64, f64) {
        let (mut value, mut magnitude) = (0.0, 0.0);
        for (k, d) in direction.iter().enumerate() {
            let (center, radius) = (d * self.center[k], d.abs() * self.remainder[k]);
            value += center + radius;
            magnitude += center.abs() + radius;
        }
        for column in self.generators.columns() {
            let (mut dot, mut absolute) = (0.0, 0.0);
            for (d, g) in direction.iter().zip(column) {
                let product = d * g;
                dot += product;
                absolute += product.abs();
            }
            value += f64::abs(dot);
            magnitude += absolute;
        }
        let (n, columns) = (self.dim(), self.num_generators());
        let relative = gamma(2 * (n + columns + 4));
        let lost = if magnitude == 0.0 && self.is_zero_along(direction) {
            0.0
        } else {
            2.0 * underflow_bound(n * (columns + 2))
        };
        (value, if lost == 0.0 { 0.0 } else { up(mul_up(relative, magnitude) + lost) })
    }

    /// Whether every product `d_k x_k` is zero because a factor is.
    fn is_zero_along(&self, direction: &[f64]) -> bool {
        let zero = |k: usize| {
            self.center[k] == 0.0
                && self.remainder[k] == 0.0
                && self.generators.columns().all(|column| column[k] == 0.0)
        };
        direction.iter().enumerate().all(|(k, &d)| d == 0.0 || zero(k))
    }
}
