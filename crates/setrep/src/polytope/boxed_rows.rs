//! Half-spaces kept over time inside a known box, one linear program after another.

use boxlp::{Problem, Solver};
use scalars::Interval;
use scalars::rounding::{add_down, add_up, sub_up};

use super::HPolytope;
use super::frame::Frame;
use super::row_contradiction::RowContradiction;
use super::solve::dot_upper;
use crate::constrained_zonotope::refused;
use crate::{Matrix, Part, SetError};

mod support;

/// The set `{ x in B : a_i'x <= h_i }` of rows that come and go, with its box `B` known beforehand.
///
/// Where [`HPolytope::optimizer`] first computes a bounding box, here it is given, and the solver keeps its basis while rows are
/// appended, dropped or moved. Supports come from the bound of weak duality, so no rounding of the solver brings them below the exact
/// maximum. Nothing is allocated in steady state.
///
/// ```
/// # use scalars::Interval;
/// # use setrep::BoxedRows;
/// let side = Interval::new(-8.0, 8.0)?;
/// let mut rows = BoxedRows::new(&[side, side])?;
/// let first = rows.push(&[1.0, 1.0], 1.0)?;
/// rows.push(&[-1.0, 1.0], 1.0)?;
/// assert!((1.0..1.0 + 1e-13).contains(&rows.support(&[0.0, 1.0])?));
/// rows.set_offset(first, 3.0)?;
/// assert!((2.0..2.0 + 1e-13).contains(&rows.support(&[0.0, 1.0])?));
/// rows.retain(|row| row != first);
/// assert!((8.0..8.0 + 1e-13).contains(&rows.support(&[0.0, 1.0])?));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct BoxedRows {
    frame: Frame,
    /// Minus the center of the frame.
    opposite: Vec<f64>,
    /// Row by row.
    normals: Vec<f64>,
    offsets: Vec<f64>,
    /// Upper bounds of `h_i(frame) - h_i`.
    shifts: Vec<f64>,
    solver: Solver,
    /// Offsets have changed since the solver saw them.
    moved: bool,
    active: Vec<(usize, f64)>,
    contradiction: Option<RowContradiction>,
    scaled: Vec<f64>,
    keep: Vec<bool>,
}

impl BoxedRows {
    /// The box itself, without rows. Sides without width are fine.
    ///
    /// **Guarantee:** the box in use holds `sides`; its sides are up to twice as long.
    ///
    /// # Errors
    /// [`SetError::ZeroDimension`]; [`SetError::UnboundedInterval`] for an empty or unbounded side; [`SetError::Overflow`].
    pub fn new(sides: &[Interval]) -> Result<Self, SetError> {
        check_sides(sides)?;
        let frame = Frame::around(sides, 1.0)?;
        let solver = Solver::new(Problem::new(sides.len()).map_err(refused)?);
        Ok(Self {
            opposite: frame.center.iter().map(|c| -c).collect(),
            frame,
            normals: Vec::new(),
            offsets: Vec::new(),
            shifts: Vec::new(),
            solver,
            moved: false,
            active: Vec::new(),
            contradiction: None,
            scaled: Vec::new(),
            keep: Vec::new(),
        })
    }

    /// Dimension `n` of the space.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.opposite.len()
    }

    /// Number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.offsets.len()
    }

    /// Whether there is no row.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.offsets.is_empty()
    }

    /// `a_i`.
    ///
    /// # Panics
    /// If there is no row `i`, as indexing a slice does.
    #[must_use]
    pub fn normal(&self, i: usize) -> &[f64] {
        let n = self.dim();
        &self.normals[i * n..(i + 1) * n]
    }

    /// All `h_i`.
    #[must_use]
    pub fn offsets(&self) -> &[f64] {
        &self.offsets
    }

    /// Side `j` of the box in use, rounded outward.
    ///
    /// # Panics
    /// If there is no side `j`, as indexing a slice does.
    #[must_use]
    pub fn side(&self, j: usize) -> Interval {
        Interval::point(self.frame.center[j]).inflate(self.frame.scales[j])
    }

    /// Whether `values` lie within side `j` of the box in use.
    ///
    /// # Panics
    /// If there is no side `j`, as indexing a slice does.
    #[must_use]
    pub fn holds(&self, j: usize, values: &Interval) -> bool {
        let (c, s) = (self.frame.center[j], self.frame.scales[j]);
        sub_up(c, s) <= values.lo() && values.hi() <= add_down(c, s)
    }

    /// Appends the row `a'x <= h` and returns its index; `h = inf` says nothing.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`], [`SetError::Overflow`]; nothing changes then.
    pub fn push(&mut self, normal: &[f64], offset: f64) -> Result<usize, SetError> {
        SetError::check_size(Part::Normals, self.dim(), normal.len())?;
        SetError::check_finite(Part::Normals, 1, normal)?;
        check_offset(offset)?;
        self.load(normal, offset)?;
        self.normals.extend_from_slice(normal);
        self.offsets.push(offset);
        Ok(self.offsets.len() - 1)
    }

    /// Replaces `h_i`, keeping the basis.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if there is no row `i`; [`SetError::NonFinite`]. Nothing changes then.
    pub fn set_offset(&mut self, i: usize, offset: f64) -> Result<(), SetError> {
        check_offset(offset)?;
        let rows = self.offsets.len();
        let Some(h) = self.offsets.get_mut(i) else {
            return Err(SetError::Dimension { part: Part::Offsets, expected: rows, found: i });
        };
        *h = offset;
        self.moved = true;
        Ok(())
    }

    /// Adds to `h_i`, rounded up; NaN makes it infinite.
    ///
    /// # Panics
    /// If there is no row `i`, as indexing a slice does.
    pub fn raise(&mut self, i: usize, by: f64) {
        self.offsets[i] = add_up(self.offsets[i], by).max(f64::MIN);
        self.moved = true;
    }

    /// Keeps the rows for whose index `keep` says `true`, in their order.
    pub fn retain(&mut self, mut keep: impl FnMut(usize) -> bool) {
        let n = self.dim();
        self.keep.clear();
        self.keep.extend((0..self.offsets.len()).map(&mut keep));
        if self.keep.iter().all(|&kept| kept) {
            return;
        }
        self.solver.retain_rows(|i| self.keep[i]);
        let mut kept = 0;
        for i in 0..self.keep.len() {
            if self.keep[i] {
                self.normals.copy_within(i * n..(i + 1) * n, kept * n);
                self.offsets[kept] = self.offsets[i];
                self.shifts[kept] = self.shifts[i];
                kept += 1;
            }
        }
        self.normals.truncate(kept * n);
        self.offsets.truncate(kept);
        self.shifts.truncate(kept);
    }

    /// Takes another box around the set, after `rewrite(i, a_i, h_i)` has replaced each row; the basis is lost. A row that overflows says
    /// nothing from then on.
    ///
    /// # Errors
    /// As [`new`](Self::new), or [`SetError::Dimension`]; nothing changes then.
    pub fn reframe(
        &mut self,
        sides: &[Interval],
        mut rewrite: impl FnMut(usize, &mut [f64], &mut f64),
    ) -> Result<(), SetError> {
        let n = self.dim();
        SetError::check_size(Part::Interval, n, sides.len())?;
        check_sides(sides)?;
        self.frame.assign_around(sides, 1.0)?;
        self.opposite.iter_mut().zip(&self.frame.center).for_each(|(o, c)| *o = -c);
        self.solver.truncate_rows(0);
        self.shifts.clear();
        let (mut normals, mut offsets) = (core::mem::take(&mut self.normals), core::mem::take(&mut self.offsets));
        for (i, (normal, offset)) in normals.chunks_exact_mut(n).zip(&mut offsets).enumerate() {
            rewrite(i, normal, offset);
            let usable = normal.iter().all(|a| a.is_finite()) && check_offset(*offset).is_ok();
            if !usable || self.load(normal, *offset).is_err() {
                normal.fill(0.0);
                *offset = f64::INFINITY;
                // A row of zeros is always taken.
                self.load(normal, *offset)?;
            }
        }
        (self.normals, self.offsets) = (normals, offsets);
        Ok(())
    }

    /// The rows that say something, and the sides of the box.
    ///
    /// # Errors
    /// [`SetError::Overflow`] for sides that are not finite.
    pub fn to_polytope(&self) -> Result<HPolytope, SetError> {
        let n = self.dim();
        let kept: Vec<usize> = (0..self.len()).filter(|&i| self.offsets[i].is_finite()).collect();
        let mut normals = Matrix::zeros(kept.len(), n);
        for (row, &i) in kept.iter().enumerate() {
            for j in 0..n {
                normals[(row, j)] = self.normals[i * n + j];
            }
        }
        let offsets: Vec<f64> = kept.iter().map(|&i| self.offsets[i]).collect();
        let sides: Vec<Interval> = (0..n).map(|j| self.side(j)).collect();
        HPolytope::new(normals, &offsets)?.intersection(&HPolytope::from_intervals(&sides)?)
    }

    /// Appends a row to the solver, in coordinates of the frame.
    fn load(&mut self, normal: &[f64], offset: f64) -> Result<(), SetError> {
        let lost = self.frame.underflow(normal.iter().copied());
        let shift = add_up(dot_upper(normal, &self.opposite), lost);
        self.scaled.clear();
        self.scaled.extend(normal.iter().zip(&self.frame.scales).map(|(a, s)| a * s));
        self.solver.push_row(&self.scaled, f64::NEG_INFINITY, moved_up(offset, shift)).map_err(refused)?;
        self.shifts.push(shift);
        Ok(())
    }
}

/// `offset + shift` rounded up, and a number the solver takes: a bound below all numbers is one below all sums of a row.
fn moved_up(offset: f64, shift: f64) -> f64 {
    add_up(offset, shift).max(f64::MIN)
}

fn check_offset(offset: f64) -> Result<(), SetError> {
    if offset.is_nan() || offset == f64::NEG_INFINITY {
        return Err(SetError::NonFinite { part: Part::Offsets, row: 0, col: 0, value: offset });
    }
    Ok(())
}

fn check_sides(sides: &[Interval]) -> Result<(), SetError> {
    if sides.is_empty() {
        return Err(SetError::ZeroDimension { part: Part::Interval });
    }
    match sides.iter().position(|side| side.is_empty() || !side.is_bounded()) {
        Some(row) => Err(SetError::UnboundedInterval { part: Part::Interval, row, col: 0 }),
        None => Ok(()),
    }
}
