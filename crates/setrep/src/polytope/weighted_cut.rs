//! Convex combinations of which a second quantity is bounded.

use scalars::Interval;

use super::VPolytope;
use crate::bounds::add_lengths;
use crate::{Matrix, Part, SetError};

/// A cut that takes less than this share of the width of the values is left out: its new vertices would be rounding's more than the
/// set's.
const NOTHING: f64 = 1e-9;

/// Pairs of columns on both sides of a cut before it is refused.
const MAX_PAIRS: usize = 20_000;

impl VPolytope {
    /// The combinations of the columns whose values combine to at most a level, `{ sum_i l_i v_i + e : l >= 0, sum_i l_i = 1,
    /// sum_i l_i a_i <= b, |e| <= r }`, shape `a: m`.
    ///
    /// With `a_i = d'v_i` it is the intersection with a half-space; with values of a function that is not linear its consequence for the
    /// hull. The simplex of the weights is cut along its edges: columns with `a_i <= b` stay, and each of them has a point on the
    /// segment to each of the others, of which [`thinned`](Self::thinned) with `share` keeps those that matter. No facets are needed. Unless
    /// `share` is zero, a cut that takes less than `1e-9` of the width of the values is left out, so that half-spaces that nearly coincide with
    /// facets add no vertices.
    ///
    /// **Guarantee:** superset; exact for `share = 0` but for the remainder. A set without columns left is proven empty.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] for the values (`-inf` says nothing and is allowed) and the level;
    /// [`SetError::EmptySet`], proven; [`SetError::OverBudget`] beyond 20,000 segments.
    pub fn cut_by_values(&self, values: &[f64], level: f64, share: f64) -> Result<Self, SetError> {
        SetError::check_size(Part::Offsets, self.num_vertices(), values.len())?;
        SetError::check_finite(Part::Offsets, 1, &[level])?;
        if let Some(index) = values.iter().position(|a| a.is_nan() || *a == f64::INFINITY) {
            SetError::check_finite(Part::Offsets, values.len(), &values[index..=index])?;
        }
        let (kept, cut): (Vec<usize>, Vec<usize>) = (0..values.len()).partition(|&i| values[i] <= level);
        if cut.is_empty() || values.contains(&f64::NEG_INFINITY) {
            return Ok(self.clone());
        }
        if kept.is_empty() {
            return Err(SetError::EmptySet);
        }
        let (least, most) =
            values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &a| (lo.min(a), hi.max(a)));
        if share > 0.0 && most - level <= NOTHING * (most - least) {
            return Ok(self.clone());
        }
        let pairs = kept.len().saturating_mul(cut.len());
        if pairs > MAX_PAIRS {
            return Err(SetError::OverBudget { count: pairs, limit: MAX_PAIRS });
        }
        let n = self.dim();
        let mut section = Matrix::zeros(n, 0);
        section.reserve_cols(pairs);
        let mut lost = vec![0.0_f64; n];
        let mut column = vec![0.0; n];
        let unit = Interval::ZERO.hull(Interval::ONE);
        for &i in kept.iter().filter(|&&i| values[i] < level) {
            let from = self.vertices.col(i);
            let gap = Interval::point(level) - Interval::point(values[i]);
            for &j in &cut {
                let way = (gap / (Interval::point(values[j]) - Interval::point(values[i]))).intersection(unit);
                for (k, (&x, &y)) in from.iter().zip(self.vertices.col(j)).enumerate() {
                    let at = Interval::point(x) + way * (Interval::point(y) - Interval::point(x));
                    column[k] = at.mid();
                    lost[k] = lost[k].max(at.rad());
                }
                section.append_columns(&column);
            }
        }
        if let Some(row) = (0..n).find(|&k| !lost[k].is_finite()) {
            return Err(SetError::Overflow { row });
        }
        let mut vertices = Matrix::zeros(n, 0);
        kept.iter().for_each(|&i| vertices.append_columns(self.vertices.col(i)));
        if section.cols() > 0 {
            // Few of the new points matter, and the values of a linear function put them in a plane: they are the first to be thinned.
            let section = Self::with_remainder(section, &lost)?.thinned(share);
            vertices.append_columns(section.vertices.as_slice());
            lost = section.remainder;
        }
        let remainder: Vec<f64> = self.remainder.iter().zip(&lost).map(|(&r, &lost)| add_lengths(r, lost)).collect();
        Ok(Self::with_remainder(vertices, &remainder)?.thinned(share))
    }
}
