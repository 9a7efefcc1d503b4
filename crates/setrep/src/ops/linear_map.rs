//! Image under a matrix, `R X = { R x : x in X }`.

use faer::{Accum, MatMut, MatRef, Par, linalg::matmul::matmul};
use scalars::Interval;
use scalars::rounding::add_up;

use super::materialize::is_model_size;
use crate::bounds::{add_abs_row_sums, add_lengths, gamma, product_sum_bound, sum_bound};
use crate::{Matrix, Part, SetError, Workspace, Zonotope};

impl Zonotope {
    /// Image of the set under the matrix `R: p x n`.
    ///
    /// `R <c, G, r> = <R c, R G, |R| r>`, after a remainder of model size has become generators.
    ///
    /// **Guarantee:** superset of the exact image; see [`linear_map_in_place`](Self::linear_map_in_place).
    /// **Source:** paper 000, Property 2.1.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in `R`, [`SetError::Overflow`].
    ///
    /// ```
    /// # use setrep::{Matrix, Zonotope};
    /// let square = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// let diamond = square.linear_map(&Matrix::from_rows(&[&[0.5, -0.5], &[0.5, 0.5]])?)?;
    /// assert!(diamond.support(&[1.0, 1.0])? < 1.0 + 1e-14);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn linear_map(&self, map: &Matrix) -> Result<Self, SetError> {
        let mut image = self.clone();
        image.linear_map_in_place(map, &mut Workspace::new())?;
        Ok(image)
    }

    /// [`linear_map`](Self::linear_map) in place; allocates nothing within the capacity of set and workspace.
    ///
    /// A row `i` of `R` with `z` nonzero entries gives entries off by at most `gamma_z sum_k |R_ik| |x_k|`, and only their sum over
    /// center and generators matters to the set, so `r_i' = sum_k |R_ik| (r_k + gamma_z (|c_k| + sum_j |G_kj|))`, rounded up. Rows
    /// that select or negate one coordinate are exact. A component `r_k` of [model size](Self::materialize_model_size) that `R` spreads
    /// over several rows becomes a generator first, for `|R| r` would wrap it.
    ///
    /// **Guarantee:** superset of the exact image.
    ///
    /// # Errors
    /// As [`linear_map`](Self::linear_map); the set is then unchanged.
    pub fn linear_map_in_place(&mut self, map: &Matrix, workspace: &mut Workspace) -> Result<(), SetError> {
        SetError::check_size(Part::Map, self.dim(), map.cols())?;
        if map.rows() == 0 {
            return Err(SetError::ZeroDimension { part: Part::Map });
        }
        self.magnitudes(map, workspace);
        remainder_of_image(map, None, self.num_generators() + self.dim() + 1, workspace)?;
        self.apply(map, workspace);
        Ok(())
    }

    /// Per row `k`: in `workspace.row_sums` a bound of `|c_k| + sum_j |G_kj|` (with the part of `r` that becomes generators), in
    /// `workspace.center` the part of `r` that is carried on.
    pub(crate) fn magnitudes(&self, map: &Matrix, workspace: &mut Workspace) {
        let (sums, carried) = (&mut workspace.row_sums, &mut workspace.center);
        sums.clear();
        sums.resize(self.dim(), 0.0);
        add_abs_row_sums(self.generators.as_slice(), sums);
        carried.clear();
        carried.extend_from_slice(&self.remainder);
        let is_large = |k: usize, extent: f64, scale: f64| {
            is_model_size(scale * self.remainder[k], extent, self.center[k]) && spreads(map.col(k))
        };
        // Once one component has grown large, its neighbours that it fed are not far behind: they go with it.
        let any_large = (0..sums.len()).any(|k| is_large(k, sums[k], 1.0));
        for k in 0..sums.len() {
            let extent = sums[k];
            sums[k] = sum_bound(extent + self.center[k].abs(), self.num_generators() + 4);
            if any_large && is_large(k, extent, 1e3) {
                sums[k] = add_up(sums[k], carried[k]);
                carried[k] = 0.0;
            }
        }
    }

    /// Replaces the set by its image, given [`magnitudes`](Self::magnitudes) and the new remainder in the workspace.
    pub(crate) fn apply(&mut self, map: &Matrix, workspace: &mut Workspace) {
        for k in 0..self.dim() {
            // What is not carried on becomes a generator.
            if self.remainder[k] != workspace.center[k] {
                self.generators.push_axis(k, self.remainder[k]);
            }
        }
        let (p, n) = (map.rows(), map.cols());
        self.remainder.clear();
        self.remainder.extend_from_slice(&workspace.remainder);
        if p == n && multiply_small(map.as_slice(), n, self.center.as_mut_slice()) {
            multiply_small(map.as_slice(), n, self.generators.as_mut_slice());
            return;
        }
        multiply(map, &self.center, 1, &mut workspace.center);
        core::mem::swap(&mut self.center, &mut workspace.center);
        multiply(map, self.generators.as_slice(), self.generators.cols(), &mut workspace.matrix);
        self.generators.swap_storage(p, &mut workspace.matrix);
    }
}

/// Whether a column of a map has more than one nonzero entry.
fn spreads(column: &[f64]) -> bool {
    column.iter().filter(|&&x| x != 0.0).count() > 1
}

/// The remainder of the image under `map` and its `spread`, from the magnitudes in the workspace; proves that no entry of the image
/// overflows. `columns` counts the columns that are mapped, the center included.
pub(crate) fn remainder_of_image(
    map: &Matrix,
    spread: Option<&Spread<'_>>,
    columns: usize,
    workspace: &mut Workspace,
) -> Result<(), SetError> {
    let (p, n) = (map.rows(), map.cols());
    workspace.remainder.clear();
    for i in 0..p {
        let (mut magnitude, mut carried, mut unit) = (0.0, 0.0, true);
        // Entries, and products of two nonzero factors: the others are exactly zero.
        let (mut nonzeros, mut products, mut carried_products) = (0, 0, 0);
        let row = map.as_slice()[i..].iter().step_by(p);
        for ((a, &x), &r) in row.zip(&workspace.row_sums).zip(&workspace.center) {
            let a = a.abs();
            magnitude += a * x;
            carried += a * r;
            unit &= (a == 0.0) | (a == 1.0);
            nonzeros += usize::from(a != 0.0);
            products += usize::from((a != 0.0) & (x != 0.0));
            carried_products += usize::from((a != 0.0) & (r != 0.0));
        }
        let remainder = if unit && nonzeros <= 1 {
            // The row selects, negates or drops one coordinate: exact.
            carried
        } else {
            magnitude = product_sum_bound(magnitude, products, n);
            let rounding = product_sum_bound(gamma(nonzeros) * magnitude, columns * products, 1);
            add_lengths(product_sum_bound(carried, carried_products, n), rounding)
        };
        let remainder = match spread {
            None => remainder,
            Some(spread) => add_lengths(remainder, spread.of_row(i, workspace)),
        };
        // The magnitude bounds every entry and every partial sum on the way to it; NaN fails the comparison.
        let bounded = magnitude + remainder < f64::MAX;
        if !bounded {
            SetError::check_finite(Part::Map, p, map.as_slice())?;
            return Err(SetError::Overflow { row: i });
        }
        workspace.remainder.push(remainder);
    }
    Ok(())
}

/// What the members of an interval matrix add to the image under its midpoint.
pub(crate) struct Spread<'a> {
    /// The radii `R`.
    pub(crate) rad: &'a Matrix,
    /// An enclosure of the set that may be tighter than its generators say.
    pub(crate) hull: Option<&'a [Interval]>,
}

impl Spread<'_> {
    /// `sum_k R_ik mag(H_k)`, rounded up.
    fn of_row(&self, i: usize, workspace: &Workspace) -> f64 {
        let n = self.rad.cols();
        let magnitudes = workspace.row_sums.iter().zip(&workspace.center).map(|(&x, &r)| add_lengths(x, r));
        let (mut sum, mut products) = (0.0, 0);
        for (k, magnitude) in magnitudes.enumerate() {
            // The magnitude of an empty interval is NaN, which `min` passes over.
            let magnitude = self.hull.map_or(magnitude, |hull| magnitude.min(hull[k].mag()));
            let radius = self.rad.as_slice()[k * self.rad.rows() + i];
            sum += radius * magnitude;
            products += usize::from(radius != 0.0 && magnitude != 0.0);
        }
        product_sum_bound(sum, products, n)
    }
}

/// `product = map * columns` through faer; `columns` holds `cols` columns.
fn multiply(map: &Matrix, columns: &[f64], cols: usize, product: &mut Vec<f64>) {
    let (p, n) = (map.rows(), map.cols());
    product.clear();
    product.resize(p * cols, 0.0);
    matmul(
        MatMut::from_column_major_slice_mut(product, p, cols),
        Accum::Replace,
        MatRef::from_column_major_slice(map.as_slice(), p, n),
        MatRef::from_column_major_slice(columns, n, cols),
        1.0,
        Par::Seq,
    );
}

/// `columns = map * columns` in place for the sizes of most groups; `false` if `n` is not among them.
///
/// At these sizes the call of a general product costs more than its arithmetic: see `examples/timing.rs`.
fn multiply_small(map: &[f64], n: usize, columns: &mut [f64]) -> bool {
    match n {
        1 => multiply_columns::<1>(map, columns),
        2 => multiply_columns::<2>(map, columns),
        3 => multiply_columns::<3>(map, columns),
        4 => multiply_columns::<4>(map, columns),
        _ => return false,
    }
    true
}

/// `columns = map * columns` in place, `map: N x N`.
#[inline]
fn multiply_columns<const N: usize>(map: &[f64], columns: &mut [f64]) {
    let mut r = [[0.0; N]; N];
    for (target, source) in r.iter_mut().zip(map.as_chunks::<N>().0) {
        *target = *source;
    }
    for column in columns.as_chunks_mut::<N>().0 {
        let mut y = [0.0; N];
        for k in 0..N {
            for i in 0..N {
                y[i] += r[k][i] * column[k];
            }
        }
        *column = y;
    }
}
