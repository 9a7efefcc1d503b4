//! Pontryagin difference `X - W = { x : x + w in X for every w in W }`, from outside and from inside.

use scalars::Interval;
use scalars::rounding::{ETA, add_down, add_up, mul_up, sub_down};

use super::contains::stacked;
use super::correction::Correction;
use super::factorization::{Goal, factorize};
use crate::bounds::two_sum;
use crate::{ConstrainedZonotope, Directions, Matrix, Part, SetError, Workspace, Zonotope};

impl ConstrainedZonotope {
    /// A superset of the Pontryagin difference with a zonotope: `X - c_W`, cut by `d'x <= h_X(d) - h_W(d)` for both signs of the
    /// directions given, of those of the [constraints](Directions::push_constraints), and of the axes.
    ///
    /// Every `x` of the difference has `x + w in X` for the `w` that is farthest along `d`. The result is the difference if the normals
    /// of all facets of `X` are among the directions. A contradiction gives a set that is proven empty.
    ///
    /// **Guarantee:** superset of the exact difference.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::TooLarge`], [`SetError::Overflow`].
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Directions, Workspace, Zonotope};
    /// let mut workspace = Workspace::new();
    /// let square = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// let noise = Zonotope::from_box(&[0.0, 0.0], &[0.25, 0.5])?;
    /// let outer = square.outer_pontryagin(&noise, &Directions::new(2), &mut workspace)?;
    /// assert!(outer.interval_hull(&mut workspace)?[0].hi() < 0.75 + 1e-14);
    /// let inner = square.inner_pontryagin(&noise)?.ok_or(setrep::SetError::EmptySet)?;
    /// assert!(inner.interval_hull(&mut workspace)?[0].hi() > 0.75 - 1e-6);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn outer_pontryagin(
        &self,
        subtrahend: &Zonotope,
        directions: &Directions,
        workspace: &mut Workspace,
    ) -> Result<Self, SetError> {
        let n = self.dim();
        SetError::check_size(Part::Center, n, subtrahend.dim())?;
        SetError::check_size(Part::Direction, n, directions.dim())?;
        let mut all = directions.clone();
        all.push_constraints(self, workspace)?;
        all.push_rows(&Matrix::identity(n))?;
        let mut rows = Matrix::zeros(0, n);
        let mut ranges = Vec::new();
        let mut optimizer = self.optimizer(workspace)?;
        let mut contradiction = false;
        for (k, d) in all.iter().enumerate() {
            let mut end = |sign: f64| -> Result<f64, SetError> {
                let d: Vec<f64> = d.iter().map(|d| sign * d).collect();
                let (value, error) = subtrahend.support_with_error(&d);
                // A value that is not finite bounds nothing.
                let least = if value.is_finite() { sub_down(value, error) } else { f64::NEG_INFINITY };
                Ok(add_up(optimizer.support(&d)?, -least))
            };
            let (hi, lo) = (end(1.0)?, -end(-1.0)?);
            rows.push_zero_rows(1);
            d.iter().enumerate().for_each(|(j, &x)| rows[(k, j)] = x);
            match Interval::new(lo, hi) {
                Ok(range) => ranges.push(range),
                Err(_) => contradiction = true,
            }
        }
        let mut difference = self.clone();
        if contradiction {
            difference.become_empty(1);
            return Ok(difference);
        }
        let shift: Vec<f64> = subtrahend.center().iter().map(|c| -c).collect();
        difference.translate(&shift)?;
        difference.intersect_rows(&rows, &ranges, workspace)?;
        Ok(difference)
    }

    /// A proven subset of the Pontryagin difference with a zonotope, or `None` if none was found; it has the generators and
    /// constraints of the set, shortened.
    ///
    /// Let `X = <c, G; A, [b]>`, `W = <c_W, H>`, and `G C = H` with `C` of small row sums (a linear program). With
    /// `D = 1 - sum_k |C_jk|` on the diagonal, the result is `<c - c_W, G D; A D, [b] shrunk by |A C| 1>`.
    ///
    /// *Proof.* A point of it is `c - c_W + G D xi`, a point of `W` is `c_W + H zeta`. Their sum is `c + G eta` with
    /// `eta = D xi + C zeta`, `|eta_j| <= D_j + sum_k |C_jk| <= 1`, and `A eta = A D xi + A C zeta` lies in `[b]`. In floating point,
    /// `G C` misses `H`, and `G D` and `c - c_W` are rounded; a correction `E` of the coordinates with
    /// `G E` equal to all of that together is proven to exist, and its bounds are subtracted from `D` and from the ranges as well.
    /// Equality rows of `A` belong to `G` in this: there the correction keeps `A eta = b` exactly.
    ///
    /// **Guarantee:** `x + w` lies in the exact set for every `x` of the result and every `w` of `W`.
    /// **Source:** Raghuraman, Koeln 2022, and Vinod, Weiss, Di Cairano 2024, for the construction.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::Overflow`].
    pub fn inner_pontryagin(&self, subtrahend: &Zonotope) -> Result<Option<Self>, SetError> {
        let n = self.dim();
        SetError::check_size(Part::Center, n, subtrahend.dim())?;
        let mut set = self.clone();
        set.body.materialize_model_size();
        // A smaller remainder is a subset.
        set.body.remainder.fill(0.0);
        set.pad_constraints();
        let mut noise = subtrahend.clone();
        noise.materialize();
        let equalities: Vec<usize> = (0..set.num_constraints()).filter(|&i| set.ranges[i].width() == 0.0).collect();
        let lift = stacked(&set, &equalities);
        let (p, k) = (lift.rows(), noise.num_generators());
        let mut target = Matrix::zeros(p, k);
        for j in 0..k {
            target.col_mut(j)[..n].copy_from_slice(noise.generators().col(j));
        }
        let Some(mut c) = set.coordinates_of(&noise)? else { return Ok(None) };
        let Some(correction) = Correction::new(&lift) else { return Ok(None) };
        correction.polish(&target, &mut c);
        // What the coordinates miss, with the rounding of c - c_W and of the shortened generators (at most u |G|).
        let mut center = vec![0.0; n];
        let mut rho = vec![0.0; p];
        for i in 0..p {
            if i < n {
                let (moved, error) = two_sum(set.center()[i], -noise.center()[i]);
                if !moved.is_finite() {
                    return Err(SetError::Overflow { row: i });
                }
                (center[i], rho[i]) = (moved, error.abs());
            }
            for column in 0..k {
                let entry = (0..lift.cols()).fold(Interval::point(target[(i, column)]), |rest, j| {
                    rest - Interval::point(lift[(i, j)]) * Interval::point(c[(j, column)])
                });
                rho[i] = add_up(rho[i], entry.mag());
            }
            rho[i] = (0..lift.cols()).fold(rho[i], |sum, j| add_up(sum, rounding_of(lift[(i, j)])));
        }
        let Some(slack) = correction.bounds(&rho) else { return Ok(None) };
        let used: Vec<f64> =
            (0..lift.cols()).map(|j| (0..k).fold(slack[j], |sum, column| add_up(sum, c[(j, column)].abs()))).collect();
        let lengths: Vec<f64> = used.iter().map(|&used| sub_down(1.0, used)).collect();
        if !lengths.iter().all(|&d| d >= 0.0) {
            return Ok(None);
        }
        Ok(set.shrink_ranges(&c, &slack, &equalities).then(|| {
            set.body.center = center;
            for (j, &d) in lengths.iter().enumerate() {
                set.body.generators.col_mut(j).iter_mut().for_each(|g| *g *= d);
                set.constraints.col_mut(j).iter_mut().for_each(|a| *a *= d);
            }
            set
        }))
    }

    /// Coordinates `C` with `[G; A] C = [H; 0]` up to the solver's accuracy, slacks of ranges left out.
    fn coordinates_of(&self, noise: &Zonotope) -> Result<Option<Matrix>, SetError> {
        let k = noise.num_generators();
        if k == 0 {
            return Ok(Some(Matrix::zeros(self.num_generators(), 0)));
        }
        let form = self.textbook_form()?;
        let l = stacked(&form, &(0..form.num_constraints()).collect::<Vec<_>>());
        let mut t = Matrix::zeros(l.rows(), k);
        for j in 0..k {
            t.col_mut(j)[..self.dim()].copy_from_slice(noise.generators().col(j));
        }
        let Some((all, _)) = factorize(&l, &t, &Matrix::zeros(0, k), Goal::Total) else { return Ok(None) };
        let mut c = Matrix::zeros(self.num_generators(), k);
        for j in 0..k {
            c.col_mut(j).copy_from_slice(&all.col(j)[..self.num_generators()]);
        }
        Ok(Some(c))
    }

    /// Shrinks the ranges with width by `|A C| 1 + |A| slack` and the rounding of the shortened rows; `false` if nothing is left of one.
    fn shrink_ranges(&mut self, c: &Matrix, slack: &[f64], equalities: &[usize]) -> bool {
        for i in (0..self.ranges.len()).filter(|i| !equalities.contains(i)) {
            let mut lost = 0.0;
            for column in 0..c.cols() {
                let activity = (0..c.rows()).fold(Interval::ZERO, |sum, j| {
                    sum + Interval::point(self.constraints[(i, j)]) * Interval::point(c[(j, column)])
                });
                lost = add_up(lost, activity.mag());
            }
            for (j, &slack) in slack.iter().enumerate() {
                let a = self.constraints[(i, j)];
                lost = add_up(lost, add_up(mul_up(a.abs(), slack), rounding_of(a)));
            }
            let (lo, hi) = (add_up(self.ranges[i].lo(), lost), add_down(self.ranges[i].hi(), -lost));
            match Interval::new(lo, hi) {
                Ok(range) => self.ranges[i] = range,
                Err(_) => return false,
            }
        }
        true
    }
}

/// Upper bound of the rounding error of a product of `x` with a number of magnitude at most 1.
fn rounding_of(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { add_up(mul_up(x.abs(), 0.5 * f64::EPSILON), ETA) }
}
