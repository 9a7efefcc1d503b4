//! Volumes of all candidates for the intersection with a strip, from one pass over the minors.
//!
//! Candidate `j` replaces `g_j` by `sigma g_j / (a'g_j)` and every other `g_i` by `g_i - (a'g_i / a'g_j) g_j`, which is orthogonal to `a`. Of
//! the `n`-subsets of its generators, those without `j` lie in the plane `a'x = 0` and have the determinant 0; in those with `j` the
//! subtractions do not change the determinant, and the replaced column scales it. Hence
//!
//! ```text
//! Vol_j = 2^n sigma W_j / |a'g_j|,    W_j = sum of |det G_J| over the n-subsets J with j in J,
//! Vol_0 = 2^n sum_j W_j / n,
//! ```
//!
//! with minors of the **original** generators only: the cost of one volume instead of `ng + 1`.

use core::ops::ControlFlow;

use super::super::materialize::is_model_size;
use crate::ops::volume::MINOR_LIMIT;
use crate::wedge::{MAX_DIM, Wedge, check_subsets, normal_from_minors};
use crate::{Part, SetError, Workspace, Zonotope};

impl Zonotope {
    /// Volumes (approximate) of the set and of the candidates for its intersection with a strip `a'x in m +- half_width`: entry 0 is
    /// the set's, entry `j + 1` that of the candidate that replaces generator `j`, infinite where `a'g_j = 0`. The box remainder counts
    /// where it is of [model size](Self::materialize_model_size), but is no candidate. Allocates nothing within the capacity of the
    /// workspace.
    ///
    /// Approximate: in plain floating point, to about `n` roundings; what they are for, a choice, needs no more.
    /// **Source:** candidates: Bravo, Alamo, Camacho 2006, paper 001, (34)-(37); shared minors: ours.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in the direction, [`SetError::TooManySubsets`] beyond
    /// [`MINOR_LIMIT`] minors, [`SetError::TooManyDimensions`] beyond 14.
    ///
    /// ```
    /// # use setrep::{Workspace, Zonotope};
    /// let mut square = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// square.materialize();
    /// let mut workspace = Workspace::new();
    /// // A strip of width 1/2 across the square: the candidate is its part in the strip.
    /// assert_eq!(square.approx_candidate_volumes(&[1.0, 0.0], 0.25, &mut workspace)?, [4.0, 1.0, f64::INFINITY]);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn approx_candidate_volumes<'a>(
        &self,
        direction: &[f64],
        half_width: f64,
        workspace: &'a mut Workspace,
    ) -> Result<&'a [f64], SetError> {
        let n = self.dim();
        SetError::check_size(Part::Direction, n, direction.len())?;
        SetError::check_finite(Part::Direction, n, direction)?;
        let total = self.sum_minors(workspace)?;
        let (sums, volumes) = (&workspace.coordinates, &mut workspace.objective);
        let unit = 2_f64.powi(n as i32);
        volumes.clear();
        volumes.push(unit * total);
        volumes.extend(self.generators.columns().zip(sums).map(|(column, sum)| {
            let along: f64 = direction.iter().zip(column).map(|(a, g)| a * g).sum();
            if along == 0.0 { f64::INFINITY } else { unit * half_width * (sum / along.abs()) }
        }));
        Ok(volumes)
    }

    /// Writes the `W_j` of all generators to `workspace.coordinates` and returns the sum over all subsets, `sum_j W_j / n`.
    pub(super) fn sum_minors(&self, workspace: &mut Workspace) -> Result<f64, SetError> {
        let n = self.dim();
        let Workspace { coordinates: sums, matrix: columns, wedge, .. } = workspace;
        columns.clear();
        columns.extend_from_slice(self.generators.as_slice());
        for (i, &r) in self.remainder.iter().enumerate().filter(|(_, r)| **r > 0.0) {
            let extent = self.generators.columns().map(|g| g[i].abs()).sum();
            if is_model_size(r, extent, self.center[i]) {
                columns.extend((0..n).map(|k| if k == i { r } else { 0.0 }));
            }
        }
        let count = columns.len() / n;
        sums.clear();
        sums.resize(count, 0.0);
        if check_subsets(n, count, n, MINOR_LIMIT)? == 0 {
            return Ok(0.0);
        }
        let wedge = match wedge {
            Some(wedge) if wedge.fits(n, n - 1) => wedge,
            other => other.insert(Wedge::new(n, n - 1)),
        };
        Ok(match n {
            2 => accumulate::<2>(wedge, columns, sums),
            3 => accumulate::<3>(wedge, columns, sums),
            4 => accumulate::<4>(wedge, columns, sums),
            5 => accumulate::<5>(wedge, columns, sums),
            6 => accumulate::<6>(wedge, columns, sums),
            _ => accumulate_any(wedge, columns, sums),
        })
    }
}

/// Adds `|det|` of every `n`-subset to the sums of its columns; returns the sum over the subsets. The normal of `n - 1` columns gives
/// the determinants with all columns behind them.
fn accumulate<const N: usize>(wedge: &mut Wedge<f64>, columns: &[f64], sums: &mut [f64]) -> f64 {
    let (columns, _) = columns.as_chunks::<N>();
    let mut total = 0.0;
    wedge.for_each(columns.as_flattened(), &mut |subset, minors| {
        let mut normal = [0.0; N];
        normal_from_minors(minors, &mut normal);
        let behind = subset.last().map_or(0, |last| last + 1);
        let mut with_subset = 0.0;
        for (sum, column) in sums[behind..].iter_mut().zip(&columns[behind..]) {
            let minor = (0..N).map(|i| normal[i] * column[i]).sum::<f64>().abs();
            *sum += minor;
            with_subset += minor;
        }
        subset.iter().for_each(|&j| sums[j] += with_subset);
        total += with_subset;
        ControlFlow::Continue(())
    });
    total
}

/// [`accumulate`] in any dimension.
fn accumulate_any(wedge: &mut Wedge<f64>, columns: &[f64], sums: &mut [f64]) -> f64 {
    let mut total = 0.0;
    wedge.for_each(columns, &mut |subset, minors| {
        let n = minors.len();
        let mut normal = [0.0; MAX_DIM];
        normal_from_minors(minors, &mut normal[..n]);
        let behind = subset.last().map_or(0, |last| last + 1);
        let mut with_subset = 0.0;
        for (sum, column) in sums[behind..].iter_mut().zip(columns[behind * n..].chunks_exact(n)) {
            let minor = normal.iter().zip(column).map(|(l, g)| l * g).sum::<f64>().abs();
            *sum += minor;
            with_subset += minor;
        }
        subset.iter().for_each(|&j| sums[j] += with_subset);
        total += with_subset;
        ControlFlow::Continue(())
    });
    total
}
