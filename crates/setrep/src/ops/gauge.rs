//! Gauge of a point: by how much a set must be scaled to hold it.

use core::ops::ControlFlow;

use super::membership::{FACET_LIMIT, distinct_directions};
use crate::wedge::{Wedge, check_subsets, normal_from_minors};
use crate::{Part, SetError, Zonotope};

impl Zonotope {
    /// Gauge `min { t >= 0 : p in c + t (X - c) }`, approximate: at most 1 inside, above 1 outside, up to rounding.
    ///
    /// The largest `|l'(p - c)| / (sum_j |l'g_j| + |l|'r)` over the facet normals `l`, in plain floating point after scaling (the
    /// gauge does not depend on it); `inf` if the set is flat and the point off its plane (by more than `1e-12` of the point's distance).
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`], [`SetError::TooManySubsets`] beyond [`FACET_LIMIT`]
    /// normals, [`SetError::TooManyDimensions`] beyond 14.
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
        let mut directions = distinct_directions(self);
        check_subsets(n, directions.len() / n, n - 1, FACET_LIMIT)?;
        // Directions of length about 1, and a set of size about 1: no product over- or underflows where it matters.
        for direction in directions.chunks_exact_mut(n) {
            rescale(direction, largest(direction));
        }
        let mut offset: Vec<f64> = point.iter().zip(&self.center).map(|(p, c)| 0.5 * p - 0.5 * c).collect();
        let mut generators: Vec<f64> = self.generators.as_slice().iter().map(|g| 0.5 * g).collect();
        let mut remainder: Vec<f64> = self.remainder.iter().map(|r| 0.5 * r).collect();
        let size = largest(&offset).max(largest(&generators)).max(largest(&remainder));
        for part in [&mut offset, &mut generators, &mut remainder] {
            rescale(part, size);
        }
        let (mut normal, mut gauge) = (vec![0.0; n], 0.0_f64);
        Wedge::<f64>::new(n, n - 1).for_each(&directions, &mut |_, minors| {
            normal_from_minors(minors, &mut normal);
            let dot = |x: &[f64]| normal.iter().zip(x).map(|(l, x)| l * x).sum::<f64>();
            let absolute = |x: &[f64]| normal.iter().zip(x).map(|(l, x)| (l * x).abs()).sum::<f64>();
            let distance = dot(&offset).abs();
            let radius = generators.chunks_exact(n).map(|g| dot(g).abs()).sum::<f64>() + absolute(&remainder);
            if distance > 1e-12 * absolute(&offset) {
                gauge = gauge.max(distance / radius);
            }
            ControlFlow::Continue(())
        });
        Ok(gauge)
    }
}

/// Largest entry, by absolute value.
fn largest(entries: &[f64]) -> f64 {
    entries.iter().fold(0.0, |m, x| m.max(x.abs()))
}

/// Divides by a positive finite `size`, in two steps because its reciprocal may overflow; by nothing for `size = 0`.
fn rescale(entries: &mut [f64], size: f64) {
    if size > 0.0 {
        let root = size.sqrt();
        for x in entries {
            *x = *x / root / root;
        }
    }
}
