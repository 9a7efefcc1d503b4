//! Solution sets by affine enclosures: rows of the mean value, slope, Taylor and natural forms.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, SetError, Strip};

use crate::image::enclose_over_hull;
use crate::{AffineEnclosure, BoundError, DynFunction, Expansion, Form, Operand, Workspace};

/// Rows `C x in [d]`, one for each output that says something. Shapes `C: k x n`, `[d]: k` intervals.
///
/// The rows of `C` are directions in which the equations bind, and so candidates for the directions of a template as well.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Rows {
    directions: Matrix,
    ranges: Vec<Interval>,
    outputs: Vec<usize>,
}

impl Rows {
    /// No rows, to be overwritten.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The matrix `C`.
    #[must_use]
    pub fn directions(&self) -> &Matrix {
        &self.directions
    }

    /// The ranges `[d]`, possibly unbounded on one side.
    #[must_use]
    pub fn ranges(&self) -> &[Interval] {
        &self.ranges
    }

    /// The output that each row comes from.
    #[must_use]
    pub fn outputs(&self) -> &[usize] {
        &self.outputs
    }

    /// The rows one by one, for sets that are cut by strips.
    ///
    /// # Errors
    /// [`SetError::ZeroDimension`] for rows without variables.
    pub fn strips(&self) -> Result<Vec<Strip>, BoundError> {
        let direction = |i: usize| -> Vec<f64> { self.directions.columns().map(|column| column[i]).collect() };
        self.ranges.iter().enumerate().map(|(i, &range)| Ok(Strip::new(&direction(i), range)?)).collect()
    }

    /// Intersection of a constrained zonotope with all rows: no generators, one constraint a row.
    ///
    /// **Guarantee:** superset of the exact intersection.
    ///
    /// # Errors
    /// As [`ConstrainedZonotope::intersect_rows`]; the set is then unchanged.
    pub fn intersect(&self, set: &mut ConstrainedZonotope, workspace: &mut Workspace) -> Result<(), BoundError> {
        if self.ranges.is_empty() {
            return Ok(());
        }
        Ok(set.intersect_rows(&self.directions, &self.ranges, &mut workspace.sets)?)
    }
}

impl AffineEnclosure {
    /// Rows that every solution of `g(x, v) in Y` fulfils, `Y` a box with sides that may be unbounded: `C x in [d]` with
    /// `J = [C D]` and `[d] = Y - [e] - D (V - gamma_v) + C gamma_x`.
    ///
    /// The first `states` variables are `x`; the others, if any, are noises `v` that range over their sides `V` of the box. An output
    /// without a finite bound gives no row. Measurement noise, remainder and rounding widen `[d]`: there are no slack columns.
    /// Inexact invariants `h(x, d) = 0` are such equations with `Y = {0}` and `v = d`.
    ///
    /// **Guarantee:** `C x` lies in `[d]` for every `x` in the box for which a `v` in the box has `g(x, v)` in `Y`.
    /// **Source:** paper 003, Propositions 3 and 4, Corollaries 1 and 2, Remark 13, as ranges; paper 001, (30)-(33) for the natural form.
    ///
    /// # Errors
    /// [`BoundError::Dimension`], [`BoundError::EmptyInterval`] for an empty side of `Y`; [`SetError::EmptySet`] if an output is defined
    /// nowhere on the box, unless its side of `Y` is the whole line. The rows are then unchanged.
    ///
    /// ```
    /// use nonlin_bounds::{AffineEnclosure, Domain, Form, Function, Rows, Workspace};
    /// use scalars::{Interval, Scalar};
    /// use setrep::ConstrainedZonotope;
    ///
    /// struct Circle;
    /// impl Function for Circle {
    ///     const VARIABLES: Option<usize> = Some(2);
    ///     fn outputs(&self) -> usize { 1 }
    ///     fn eval<S: Scalar>(&self, x: &[S], _p: &[S], y: &mut [S]) { y[0] = x[0].sqr() + x[1].sqr(); }
    /// }
    /// let mut workspace = Workspace::new();
    /// let mut set = ConstrainedZonotope::from_box(&[1.0, 0.0], &[0.25, 0.25])?;
    /// let hull = set.interval_hull(&mut workspace.sets)?;
    /// let (mut enclosure, mut rows) = (AffineEnclosure::new(), Rows::new());
    /// enclosure.enclose(Form::Taylor, &Circle, &Domain::new(&hull, &[1.0, 0.0]), &mut workspace)?;
    /// enclosure.rows_into(2, &[Interval::ONE], &mut rows)?;
    /// rows.intersect(&mut set, &mut workspace)?;
    /// // 2 x_1 lies in [2 - 1/8, 2].
    /// assert!(set.interval_hull(&mut workspace.sets)?[0].width() < 0.0626);
    /// # Ok::<(), nonlin_bounds::BoundError>(())
    /// ```
    pub fn rows_into(&self, states: usize, values: &[Interval], rows: &mut Rows) -> Result<(), BoundError> {
        self.check_solution(states, values.len())?;
        if let Some(index) = values.iter().position(Interval::is_empty) {
            return Err(BoundError::EmptyInterval { operand: Operand::Outputs, index });
        }
        // What has no value says nothing of the states unless a value was seen.
        if self.offsets.iter().zip(values).any(|(offset, value)| offset.is_empty() && *value != Interval::ENTIRE) {
            return Err(SetError::EmptySet.into());
        }
        let says = |i: usize| -> Option<Interval> {
            let range = values[i] - self.fixed_part(i, states, states);
            (range.lo() > f64::NEG_INFINITY || range.hi() < f64::INFINITY).then_some(range)
        };
        rows.ranges.clear();
        rows.ranges.extend((0..self.outputs()).filter_map(says));
        rows.outputs.clear();
        rows.outputs.extend((0..self.outputs()).filter(|&i| says(i).is_some()));
        rows.directions.reset(rows.ranges.len(), states);
        for (row, &i) in rows.outputs.iter().enumerate() {
            for k in 0..states {
                rows.directions[(row, k)] = self.jacobian[(i, k)];
            }
        }
        Ok(())
    }

    /// Intersection of a set with the solutions of `g(x, v) in Y`, `Y` a box: [`rows_into`](Self::rows_into) and
    /// [`Rows::intersect`] in one.
    ///
    /// **Guarantee:** superset of `{ x in X : g(x, v) in Y, (x, v) in H }`.
    ///
    /// # Errors
    /// As these; the set is then unchanged.
    pub fn intersect(
        &self,
        set: &mut ConstrainedZonotope,
        values: &[Interval],
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        let mut rows = core::mem::take(&mut workspace.rows);
        let result = self.rows_into(set.dim(), values, &mut rows).and_then(|()| rows.intersect(set, workspace));
        workspace.rows = rows;
        result
    }

    /// Intersection of a set with the solutions of `g(x, v) in Y`, `Y` a constrained zonotope, as a generalised intersection:
    /// `{ x in X : C x in Y - [e] - D (V - gamma_v) + C gamma_x }`, the generators and constraints of `Y` appended to those of `X`.
    ///
    /// **Guarantee:** superset of `{ x in X : g(x, v) in Y, (x, v) in H }`.
    ///
    /// # Errors
    /// [`BoundError::Dimension`], [`BoundError::UnboundedResult`], [`BoundError::Set`]; the set is then unchanged.
    pub fn intersect_set(
        &self,
        set: &mut ConstrainedZonotope,
        values: &ConstrainedZonotope,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        let states = set.dim();
        self.check_solution(states, values.dim())?;
        self.shifts_into(|_| Interval::ZERO, states, states, workspace)?;
        self.cut(set, workspace, |other, _, _| {
            other.clone_from(values);
            Ok(())
        })
    }

    /// Intersection of a set with the solutions of `g(x, v) in Y` for noises in a constrained zonotope `V`, `Y` a bounded box: as
    /// [`intersect_set`](Self::intersect_set) with `-D (V - gamma_v)` for the set and `Y - [e] + C gamma_x` for the box.
    ///
    /// For noises that mix the outputs; a box of noises needs no generators in [`intersect`](Self::intersect).
    ///
    /// **Guarantee:** superset of `{ x in X : g(x, v) in Y, v in V, (x, v) in H }`.
    ///
    /// # Errors
    /// [`BoundError::Dimension`], [`BoundError::UnboundedResult`], [`BoundError::Set`]; the set is then unchanged.
    pub fn intersect_with_noise(
        &self,
        set: &mut ConstrainedZonotope,
        values: &[Interval],
        noise: &ConstrainedZonotope,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        let (m, states) = (self.outputs(), set.dim());
        self.check_solution(states, values.len())?;
        BoundError::check_size(Operand::Variables, self.variables(), states + noise.dim())?;
        self.shifts_into(|i| values[i], states, self.variables(), workspace)?;
        self.cut(set, workspace, |other, map, workspace| {
            other.clone_from(noise);
            workspace.row.clear();
            workspace.row.extend(self.at[states..].iter().map(|x| -x));
            other.translate(&workspace.row)?;
            map.assign_column_slice(m, noise.dim(), &self.jacobian.as_slice()[m * states..])?;
            map.as_mut_slice().iter_mut().for_each(|x| *x = -*x);
            Ok(other.linear_map_in_place(map, &mut workspace.sets)?)
        })
    }

    /// `Ok` if states and values fit the function.
    pub(crate) fn check_solution(&self, states: usize, values: usize) -> Result<(), BoundError> {
        BoundError::check_size(Operand::Outputs, self.outputs(), values)?;
        BoundError::check_size(Operand::Variables, self.variables().min(states), states)
    }

    /// `[e_i] + D_i (V - gamma_v) - C_i gamma_x`, the first `states` variables being `x`, those from `boxed` on noises with their side of
    /// the box; those between take no part.
    fn fixed_part(&self, i: usize, states: usize, boxed: usize) -> Interval {
        let mut sum = self.offsets[i];
        for (k, column) in self.jacobian.columns().enumerate() {
            if column[i] == 0.0 {
            } else if k < states {
                sum -= Interval::point(self.at[k]).scale(column[i]);
            } else if k >= boxed {
                sum += self.hull[k].add_f64(-self.at[k]).scale(column[i]);
            }
        }
        sum
    }

    /// Writes `Y_i` minus the fixed parts to the offsets of the workspace.
    pub(crate) fn shifts_into(
        &self,
        values: impl Fn(usize) -> Interval,
        states: usize,
        boxed: usize,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        workspace.offsets.clear();
        workspace.offsets.extend((0..self.outputs()).map(|i| values(i) - self.fixed_part(i, states, boxed)));
        match workspace.offsets.iter().position(|shift| !shift.is_bounded()) {
            Some(output) => Err(BoundError::UnboundedResult { output }),
            None => Ok(()),
        }
    }

    /// The generalised intersection of `set` through `C` with the set that `build` makes, moved by the offsets in the workspace.
    pub(crate) fn cut(
        &self,
        set: &mut ConstrainedZonotope,
        workspace: &mut Workspace,
        build: impl FnOnce(&mut ConstrainedZonotope, &mut Matrix, &mut Workspace) -> Result<(), BoundError>,
    ) -> Result<(), BoundError> {
        let mut map = core::mem::take(&mut workspace.map);
        let mut other = workspace.constrained.take().unwrap_or_else(|| set.clone());
        let (m, states) = (self.outputs(), set.dim());
        let steps = || -> Result<(), BoundError> {
            build(&mut other, &mut map, workspace)?;
            other.add_box(&workspace.offsets)?;
            map.assign_column_slice(m, states, &self.jacobian.as_slice()[..m * states])?;
            Ok(set.intersect(&map, &other, &mut workspace.sets)?)
        };
        let result = steps();
        workspace.constrained = Some(other);
        workspace.map = map;
        result
    }
}

/// The part of a set with `g(x, p) in Y`, `Y` a box whose sides may be unbounded, in one of the forms of [`Form`] over the interval
/// hull of the set. Noises are among the variables: stack their set with the states'.
///
/// To enclose several times over one hull, to name noises, or to allocate nothing, use [`AffineEnclosure`].
///
/// **Guarantee:** superset of `{ x in X : g(x, p) in Y }` for every `p` in the parameters, remainder and rounding included.
///
/// # Errors
/// As [`AffineEnclosure::enclose`] and [`AffineEnclosure::intersect`]; [`SetError::EmptySet`] if the set is proven empty.
pub fn affine_solution(
    form: Form,
    g: &dyn DynFunction,
    set: &ConstrainedZonotope,
    values: &[Interval],
    at: Expansion<'_>,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<ConstrainedZonotope, BoundError> {
    let enclosure = enclose_over_hull(form, g, set, at, p, workspace)?;
    let mut solution = set.clone();
    enclosure.intersect(&mut solution, values, workspace)?;
    Ok(solution)
}
