//! The parallelotope of a re-encoding: generators `T`, and rows `F` with `T F` near the identity.

use scalars::Interval;

use crate::bounds::power_of_two_below;
use crate::{ConstrainedZonotope, Reduction, SetError, Workspace};

/// Axes of this share of the set's extent complete generators that do not span the space.
const COMPLETION: f64 = 1e-6;

/// A frame is refused if `(I - T F)(x - c)` may exceed this share of the hull: what a condition of about `1e6` leaves.
const MAX_RESIDUAL: f64 = 1e-10;

/// The frame; all matrices `n x n`.
#[derive(Debug, Default, Clone)]
pub(super) struct Frame {
    /// `T`, column after column.
    pub(super) columns: Vec<f64>,
    /// `F`, row after row.
    pub(super) rows: Vec<f64>,
    /// Upper bounds of `|I - T F|`, row after row.
    residual: Vec<f64>,
    scratch: Vec<f64>,
}

impl Frame {
    /// Makes the frame of the axes in the given units, powers of two: `T F = I` exactly.
    pub(super) fn axes(&mut self, units: &[f64]) {
        let n = units.len();
        for target in [&mut self.columns, &mut self.rows, &mut self.residual] {
            target.clear();
            target.resize(n * n, 0.0);
        }
        for (i, unit) in units.iter().enumerate() {
            self.columns[i * n + i] = *unit;
            self.rows[i * n + i] = 1.0 / unit;
        }
    }

    /// Makes the frame of the parallelotope that Method 4 puts around the set without its constraints; the axes if that fails.
    pub(super) fn enclose(
        &mut self,
        set: &ConstrainedZonotope,
        units: &[f64],
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        let n = set.dim();
        let mut lift = workspace.lift.take().unwrap_or_else(|| set.body.clone());
        lift.clone_from(&set.body);
        for (i, unit) in units.iter().enumerate() {
            lift.generators.push_axis(i, set.remainder()[i].max(COMPLETION * unit));
        }
        let reduced = lift.reduce(Reduction::Method4, n, workspace);
        let complete = reduced.is_ok() && lift.num_generators() == n;
        if complete {
            self.columns.clear();
            for column in lift.generators.columns() {
                // Columns of about the size of the set: only their directions matter.
                let size = column.iter().zip(units).fold(0.0_f64, |m, (x, u)| m.max((x / u).abs()));
                let factor = power_of_two(size);
                self.columns.extend(column.iter().map(|x| x / factor));
            }
        }
        workspace.lift = Some(lift);
        reduced?;
        if !(complete && self.invert(units)) {
            self.axes(units);
        }
        Ok(())
    }

    /// Makes a frame whose rows are about the given directions (at most `n`), completed by axes in the given units; the axes if they
    /// are nearly dependent.
    ///
    /// Starting from the axes, each direction `d = sum_k (d'T_k) f_k` takes the place of the row with the largest coefficient.
    pub(super) fn follow<'a>(&mut self, directions: impl Iterator<Item = &'a [f64]>, units: &[f64]) {
        let n = units.len();
        self.axes(units);
        let mut free = vec![true; n];
        for d in directions.take(n) {
            let coefficients: Vec<f64> =
                self.columns.chunks_exact(n).map(|t| t.iter().zip(d).map(|(t, d)| t * d).sum()).collect();
            let size = |k: &usize| coefficients[*k].abs();
            let Some(k) = (0..n).filter(|&k| free[k]).max_by(|k, l| size(k).total_cmp(&size(l))) else { break };
            if size(&k) > 0.0 {
                free[k] = false;
                for i in 0..n {
                    let pivot = self.columns[k * n + i] / coefficients[k];
                    for j in (0..n).filter(|&j| j != k) {
                        self.columns[j * n + i] -= coefficients[j] * pivot;
                    }
                    self.columns[k * n + i] = pivot;
                }
            }
        }
        if !self.invert(units) {
            self.axes(units);
        }
    }

    /// Whether `|I - T F| mag` is small beside the hull's radii.
    pub(super) fn is_accurate(&self, magnitudes: &[f64], radii: &[f64]) -> bool {
        (0..radii.len()).all(|i| self.residual_row(i, magnitudes) <= MAX_RESIDUAL * radii[i])
    }

    /// `sum_j |I - T F|_ij mag_j`, rounded up.
    pub(super) fn residual_row(&self, i: usize, magnitudes: &[f64]) -> f64 {
        let n = magnitudes.len();
        let row = self.residual[i * n..(i + 1) * n].iter().zip(magnitudes);
        row.fold(Interval::ZERO, |sum, (&e, &m)| sum + Interval::point(e) * Interval::point(m)).hi()
    }

    /// `F = T^-1` by Gauss-Jordan elimination in the units given, and the residual; `false` if a pivot vanishes.
    fn invert(&mut self, units: &[f64]) -> bool {
        let n = units.len();
        let Self { columns, rows, residual, scratch: a } = self;
        a.clear();
        // Row-major T in units.
        a.extend((0..n * n).map(|k| columns[(k % n) * n + k / n] / units[k / n]));
        rows.clear();
        rows.extend((0..n * n).map(|k| if k / n == k % n { 1.0 } else { 0.0 }));
        for k in 0..n {
            let pivot = (k..n).max_by(|&i, &j| a[i * n + k].abs().total_cmp(&a[j * n + k].abs())).unwrap_or(k);
            for j in 0..n {
                a.swap(k * n + j, pivot * n + j);
                rows.swap(k * n + j, pivot * n + j);
            }
            let inverse = 1.0 / a[k * n + k];
            if !inverse.is_finite() {
                return false;
            }
            for j in 0..n {
                a[k * n + j] *= inverse;
                rows[k * n + j] *= inverse;
            }
            for i in (0..n).filter(|&i| i != k) {
                let share = a[i * n + k];
                for j in 0..n {
                    a[i * n + j] -= share * a[k * n + j];
                    rows[i * n + j] -= share * rows[k * n + j];
                }
            }
        }
        for row in rows.chunks_exact_mut(n) {
            row.iter_mut().zip(units).for_each(|(x, unit)| *x /= unit);
        }
        residual.clear();
        for i in 0..n {
            for j in 0..n {
                let unit = if i == j { Interval::ONE } else { Interval::ZERO };
                let entry = (0..n).fold(unit, |rest, k| {
                    rest - Interval::point(columns[k * n + i]) * Interval::point(rows[k * n + j])
                });
                residual.push(entry.mag());
            }
        }
        rows.iter().chain(residual.iter()).all(|x| x.is_finite())
    }
}

/// The largest power of two at most `x`, within the range whose products are safe; 1 for zero.
pub(super) fn power_of_two(x: f64) -> f64 {
    if x > 0.0 { power_of_two_below(x.clamp(1e-150, 1e150)) } else { 1.0 }
}
