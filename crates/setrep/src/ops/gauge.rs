//! Gauge of a point: by how much a set must be scaled to hold it.

use core::ops::ControlFlow;

use super::membership::{FACET_LIMIT, distinct_directions};
use crate::wedge::{Wedge, normal_from_minors, subset_count};
use crate::{Part, SetError, Zonotope};

impl Zonotope {
    /// Gauge `min { t >= 0 : p in c + t (X - c) }`, approximate: at most 1 inside, above 1 outside, up to rounding.
    ///
    /// The largest `|l'(p - c)| / (sum_j |l'g_j| + |l|'r)` over the facet normals `l`, in plain floating point; `inf` if the set is
    /// flat and the point off its plane (by more than `1e-12` of the point's distance).
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`], [`SetError::TooManySubsets`] beyond [`FACET_LIMIT`] normals or
    /// 14 dimensions.
    ///
    /// ```
    /// # use setrep::Zonotope;
    /// let square = Zonotope::from_box(&[1.0, 1.0], &[1.0, 2.0])?;
    /// assert!((square.gauge_approx(&[4.0, 1.0])? - 3.0).abs() < 1e-12);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn gauge_approx(&self, point: &[f64]) -> Result<f64, SetError> {
        let n = self.dim();
        SetError::check_size(Part::Point, n, point.len())?;
        SetError::check_finite(Part::Point, n, point)?;
        let directions = distinct_directions(self);
        let subsets = subset_count(n, directions.len() / n, n - 1);
        if subsets > FACET_LIMIT {
            return Err(SetError::TooManySubsets { subsets, limit: FACET_LIMIT });
        }
        let offset: Vec<f64> = point.iter().zip(&self.center).map(|(p, c)| p - c).collect();
        let (mut normal, mut gauge) = (vec![0.0; n], 0.0_f64);
        Wedge::<f64>::new(n, n - 1).for_each(&directions, &mut |_, minors| {
            normal_from_minors(minors, &mut normal);
            let dot = |x: &[f64]| normal.iter().zip(x).map(|(l, x)| l * x).sum::<f64>();
            let absolute = |x: &[f64]| normal.iter().zip(x).map(|(l, x)| (l * x).abs()).sum::<f64>();
            let distance = dot(&offset).abs();
            let radius = self.generators.columns().map(|g| dot(g).abs()).sum::<f64>() + absolute(&self.remainder);
            if distance > 1e-12 * absolute(&offset) {
                gauge = gauge.max(distance / radius);
            }
            ControlFlow::Continue(())
        });
        Ok(gauge)
    }
}
