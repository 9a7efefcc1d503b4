//! LP re-encoding: a reduction whose result has `n` generators and a few constraints, whatever the set had.
//!
//! A set with ranged constraints can be read off its support function. For an invertible `F` with rows `f_k`, let `[p_k]` be the
//! range of `f_k'x` over the set (two linear programs) and `T = F^-1`. Then `x = T F x` lies in the parallelotope
//! `T [p] = <T mid [p], T diag(rad [p])>`, and every further direction `d` with its range `[q]` is one row, `d'x in [q]`. Generators and
//! constraints of the set do not matter afterwards, its remainder disappears, and every coordinate uses the whole of `[-1, 1]`.
//!
//! # Rounding
//! `F` and `T` are floats, so `T F` is not quite the identity. For any `c` and every `x` of the set, whose hull is `H`,
//! `x = c + T F (x - c) + (I - T F)(x - c)`: the last term is at most `|I - T F| mag(H - c)` and goes to the box remainder, with the
//! rounding of `c + T mid` and of `T diag(rad)`. Rows `d'G` in `[q] - d'c +- |d|'r` are formed as those of an intersection. So the result
//! is a superset however badly frame and directions were chosen.

mod choice;
mod directions;
mod frame;
mod one_row;
mod parallelotopes;

pub use directions::Directions;
use frame::{Frame, power_of_two};
use scalars::Interval;

use super::ConstrainedZonotope;
use super::optimizer::Optimizer;
use super::rescale::product;
use super::rows::combine_box;
use crate::bounds::add_lengths;
use crate::{Part, SetError, Workspace};

/// A generator below this share of the set's extent and center, in every row, is rounding and goes to the remainder.
const CONSTANT: f64 = 64.0 * f64::EPSILON;

/// Settings of [`ConstrainedZonotope::reencode`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Reencoding {
    /// Most constraints of the result.
    pub constraints: usize,
    /// A direction is added while the set is narrower along it than this share of what it would otherwise be.
    pub stop_ratio: f64,
    /// How that width is found.
    pub widths: TemplateWidths,
}

impl Reencoding {
    /// At most so many constraints, down to a ratio of 0.98, by single rows.
    #[must_use]
    pub fn new(constraints: usize) -> Self {
        Self { constraints, stop_ratio: 0.98, widths: TemplateWidths::SingleRows }
    }
}

/// How the width of the growing result along a candidate direction is found; affects tightness and time only.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum TemplateWidths {
    /// The least over the rows taken one at a time, in closed form.
    #[default]
    SingleRows,
    /// Over all rows together: two linear programs a candidate and row.
    LinearPrograms,
}

/// Where a frame comes from.
#[derive(Debug, Clone, Copy)]
enum Source<'a> {
    /// The parallelotope of Method 4.
    Method4,
    /// Given rows, completed by axes.
    Along(&'a [&'a [f64]]),
}

/// Buffers of a re-encoding.
#[derive(Debug, Default, Clone)]
pub(crate) struct Scratch {
    frame: Frame,
    units: Vec<f64>,
    /// The center of the set, which is moved to the origin meanwhile; its magnitude and that of the generators.
    center: Vec<f64>,
    extents: Vec<f64>,
    /// The interval hull, its middle, its radii, and `mag(H - c)`.
    hull: Vec<Interval>,
    middle: Vec<f64>,
    radii: Vec<f64>,
    magnitudes: Vec<f64>,
    /// Ranges of the rows of the frame.
    along_frame: Vec<Interval>,
    /// Candidate after candidate, their ranges, and what the choice keeps of them.
    candidates: Vec<f64>,
    ranges: Vec<Interval>,
    choice: choice::Choice,
    zeros: Vec<f64>,
    negated: Vec<f64>,
}

impl ConstrainedZonotope {
    /// Encloses the set in one with `n` generators (or fewer) and at most `options.constraints` constraints, whose remainder is of
    /// rounding size.
    ///
    /// The generators are the parallelotope of Method 4, shrunk to the support of the set; the constraints are the ranges of the set
    /// along directions chosen one after the other where the result is widest beside the set, from the axes and `directions`, in which
    /// the chosen ones are left. A set that is proven empty becomes an empty one (a point if no constraints are allowed).
    /// Allocates nothing within the capacity of set, directions and workspace.
    ///
    /// **Guarantee:** superset of the set, within the limits.
    /// **Source:** ours; the parallelotope is that of Scott, Raimondo, Marseglia, Braatz 2016, Section 4.3 (Method 4).
    ///
    /// # Errors
    /// [`SetError::Dimension`] if the directions are of another space, [`SetError::TooLarge`], [`SetError::Overflow`]; set and
    /// directions are then unchanged.
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Directions, Matrix, Reencoding, Workspace, Zonotope};
    /// let mut workspace = Workspace::new();
    /// let body = Zonotope::new(&[0.0, 0.0], &Matrix::from_rows(&[&[1.0, 0.5, 0.25], &[0.0, 0.5, -0.25]])?)?;
    /// let mut set = ConstrainedZonotope::from(body);
    /// set.intersect_half_space(&[1.0, 1.0], 0.5, &mut workspace)?;
    /// let mut directions = Directions::new(2);
    /// directions.push(&[1.0, 1.0])?;
    /// set.reencode(Reencoding::new(1), &mut directions, &mut workspace)?;
    /// assert_eq!((set.num_generators(), set.num_constraints()), (2, 1));
    /// assert!(set.support(&[1.0, 1.0], &mut workspace)? < 0.5 + 1e-12);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn reencode(
        &mut self,
        options: Reencoding,
        directions: &mut Directions,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        SetError::check_size(Part::Direction, self.dim(), directions.dim())?;
        let mut scratch = core::mem::take(&mut workspace.reencoding);
        let result = self.in_draft(workspace, |draft, workspace| {
            draft.remove_inactive(&mut workspace.coordinates);
            draft.rescale(workspace)?;
            draft.remove_inactive(&mut workspace.coordinates);
            // About the origin, so that the place of the set costs no accuracy.
            scratch.center.clone_from(&draft.body.center);
            draft.body.center.fill(0.0);
            if scratch.measure(draft, Source::Method4, directions, workspace)? {
                draft.become_parallelotope(&scratch)?;
                draft.add_rows(options, &mut scratch, workspace)?;
            } else {
                draft.become_empty(options.constraints);
                scratch.choice.chosen.clear();
            }
            draft.body.translate(&scratch.center)
        });
        if result.is_ok() {
            directions.assign(&scratch.candidates, &scratch.choice.chosen);
        }
        workspace.reencoding = scratch;
        result
    }

    /// `<c, T diag(s), r>` from the ranges along the frame; the constraints are dropped.
    fn become_parallelotope(&mut self, scratch: &Scratch) -> Result<(), SetError> {
        let n = self.dim();
        let Scratch { frame, extents, middle, magnitudes, along_frame, zeros, .. } = scratch;
        self.ranges.clear();
        self.constraints.reset(0, 0);
        self.body.generators.reset(n, 0);
        let remainder = &mut self.body.remainder;
        (0..n).for_each(|i| remainder[i] = frame.residual_row(i, magnitudes));
        let center = &mut self.body.center;
        center.copy_from_slice(middle);
        for (k, range) in along_frame.iter().enumerate() {
            let (row, column) = (&frame.rows[k * n..(k + 1) * n], &frame.columns[k * n..(k + 1) * n]);
            // F (x - c).
            let range = *range - combine_box(row, middle, zeros);
            let (shift, radius) = (range.mid(), range.rad());
            let constant = column.iter().zip(extents).all(|(t, extent)| t.abs() * radius <= CONSTANT * extent);
            if !constant {
                self.body.generators.push_zero_cols(1);
                self.constraints.push_zero_cols(1);
            }
            for i in 0..n {
                let moved = Interval::point(center[i]) + Interval::point(column[i]).scale(shift);
                center[i] = moved.mid();
                let error = if constant {
                    scalars::rounding::mul_up(column[i].abs(), radius)
                } else {
                    let (entry, error) = product(column[i], radius);
                    let last = self.body.generators.cols() - 1;
                    self.body.generators.col_mut(last)[i] = entry;
                    error
                };
                remainder[i] = add_lengths(add_lengths(remainder[i], moved.rad()), error);
            }
        }
        self.check_magnitudes()
    }

    /// The empty set if a constraint is allowed to say so, a point otherwise.
    pub(super) fn become_empty(&mut self, constraints: usize) {
        self.body.generators.reset(self.body.center.len(), 0);
        self.body.remainder.fill(0.0);
        self.constraints.reset(0, 0);
        self.ranges.clear();
        if constraints > 0 {
            self.constraints.push_zero_rows(1);
            self.ranges.push(Interval::ONE);
        }
    }
}

impl Scratch {
    /// Hull, frame, candidates and all ranges of the set; `false` if they prove it empty.
    fn measure(
        &mut self,
        set: &ConstrainedZonotope,
        source: Source<'_>,
        directions: &Directions,
        workspace: &mut Workspace,
    ) -> Result<bool, SetError> {
        let n = set.dim();
        self.zeros.clear();
        self.zeros.resize(n, 0.0);
        self.radii.clear();
        self.radii.resize(n, 0.0);
        set.body.hull_radii(&mut self.radii);
        self.units.clear();
        self.units.extend(self.radii.iter().map(|&r| power_of_two(r)));
        self.extents.clear();
        self.extents.extend(self.radii.iter().zip(&self.center).map(|(r, c)| r + c.abs()));
        match source {
            Source::Method4 => self.frame.enclose(set, &self.units, workspace)?,
            Source::Along(rows) => self.frame.follow(rows.iter().copied(), &self.units),
        }
        self.hull.clear();
        self.hull.resize(n, Interval::EMPTY);
        let mut optimizer = set.optimizer(workspace)?;
        optimizer.interval_hull_into(&mut self.hull)?;
        if self.hull.iter().any(Interval::is_empty) {
            return Ok(false);
        }
        self.middle.clear();
        self.middle.extend(self.hull.iter().map(Interval::mid));
        self.radii.clear();
        self.radii.extend(self.hull.iter().map(Interval::rad));
        self.magnitudes.clear();
        self.magnitudes.extend(self.hull.iter().zip(&self.middle).map(|(side, &c)| side.add_f64(-c).mag()));
        if !self.frame.is_accurate(&self.magnitudes, &self.radii) {
            self.frame.axes(&self.units);
        }
        Ok(self.measure_frame(&mut optimizer)? && self.measure_candidates(directions, &mut optimizer)?)
    }

    fn measure_frame(&mut self, optimizer: &mut Optimizer<'_>) -> Result<bool, SetError> {
        let n = self.units.len();
        self.along_frame.clear();
        for row in self.frame.rows.chunks_exact(n) {
            self.along_frame.push(range_along(row, &self.hull, &mut self.negated, optimizer)?);
        }
        Ok(!self.along_frame.iter().any(Interval::is_empty))
    }

    /// Candidates: the directions given, then the axes; scaled to about the size of the hull, near-duplicates left out.
    fn measure_candidates(&mut self, directions: &Directions, optimizer: &mut Optimizer<'_>) -> Result<bool, SetError> {
        let n = self.units.len();
        self.candidates.clear();
        self.ranges.clear();
        for direction in directions.iter() {
            let width: f64 = direction.iter().zip(&self.radii).map(|(d, r)| d.abs() * r).sum();
            if width > 0.0 && width.is_finite() {
                let factor = power_of_two(width);
                self.candidates.extend(direction.iter().map(|d| d / factor));
                self.keep_candidate(optimizer)?;
            }
        }
        for k in 0..n {
            if self.radii[k] > 0.0 {
                let scale = 1.0 / self.units[k];
                self.candidates.extend((0..n).map(|i| if i == k { scale } else { 0.0 }));
                self.keep_candidate(optimizer)?;
            }
        }
        Ok(!self.ranges.iter().any(Interval::is_empty))
    }

    /// Measures the last candidate, or drops it if it is none or nearly one of those before it.
    fn keep_candidate(&mut self, optimizer: &mut Optimizer<'_>) -> Result<(), SetError> {
        let n = self.units.len();
        let (before, last) = self.candidates.split_at(self.candidates.len() - n);
        let mut others = self.frame.rows.chunks_exact(n).chain(before.chunks_exact(n));
        let useful =
            last.iter().all(|d| d.is_finite()) && !others.any(|other| choice::parallel(other, last, &self.units));
        if useful {
            self.ranges.push(range_along(last, &self.hull, &mut self.negated, optimizer)?);
        } else {
            self.candidates.truncate(self.candidates.len() - n);
        }
        Ok(())
    }
}

/// The range of `d'x` over the set, empty if the set is proven empty; along an axis that of the hull, which is known.
fn range_along(
    d: &[f64],
    hull: &[Interval],
    negated: &mut Vec<f64>,
    optimizer: &mut Optimizer<'_>,
) -> Result<Interval, SetError> {
    let mut nonzeros = (0..d.len()).filter(|&k| d[k] != 0.0);
    if let (Some(k), None) = (nonzeros.next(), nonzeros.next()) {
        return Ok(hull[k].scale(d[k]));
    }
    let hi = optimizer.support(d)?;
    negated.clear();
    negated.extend(d.iter().map(|d| -d));
    let lo = -optimizer.support(negated)?;
    Ok(Interval::new(lo, hi).unwrap_or(Interval::EMPTY))
}
