//! Reduction to a bounded number of generators and constraints.

use super::ConstrainedZonotope;
use super::rows::finite_norm;
use crate::{Reduction, SetError, Workspace, Zonotope};

/// How large a constrained zonotope may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Complexity {
    /// Most generators, at least the dimension of the set.
    pub generators: usize,
    /// Most constraints.
    pub constraints: usize,
}

impl ConstrainedZonotope {
    /// Encloses the set in one of at most the given complexity; does nothing if it is within it already.
    ///
    /// Constraints first, then generators: the set is simplified ([`rescale`](Self::rescale),
    /// [`remove_inactive_generators`](Self::remove_inactive_generators)), constraints beyond the limit are
    /// [eliminated](Self::eliminate_constraints), then [generators reduced](Self::reduce_generators). That needs as many generators as
    /// dimensions and constraints together, so a limit below `n + constraints` costs further constraints. Of generators beyond dimensions,
    /// constraints and limit together, the rest are reduced at once: they are small and make eliminations slow. Allocates nothing within
    /// the capacity of set and workspace.
    ///
    /// **Guarantee:** superset of the set, of at most the given complexity.
    ///
    /// # Errors
    /// [`SetError::TooFewGenerators`] for a limit below the dimension, [`SetError::Overflow`]; the set is then unchanged.
    ///
    /// ```
    /// # use setrep::{Complexity, ConstrainedZonotope, Reduction, Workspace};
    /// let mut workspace = Workspace::new();
    /// let mut set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// for k in 0..6 {
    ///     set.intersect_half_space(&[1.0, f64::from(k) - 2.5], 1.0, &mut workspace)?;
    /// }
    /// set.reduce(Complexity { generators: 4, constraints: 2 }, Reduction::Method4, &mut workspace)?;
    /// assert!(set.num_generators() <= 4 && set.num_constraints() <= 2);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn reduce(&mut self, limit: Complexity, method: Reduction, workspace: &mut Workspace) -> Result<(), SetError> {
        self.reduce_comparing(limit, method, 1, workspace)
    }

    /// [`reduce`](Self::reduce) with constraints eliminated by [comparing](Self::eliminate_comparing) some `candidates`.
    ///
    /// **Guarantee:** as [`reduce`](Self::reduce).
    ///
    /// # Errors
    /// As [`reduce`](Self::reduce).
    pub fn reduce_comparing(
        &mut self,
        limit: Complexity,
        method: Reduction,
        candidates: usize,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        if limit.generators < self.dim() {
            return Err(SetError::TooFewGenerators { max_generators: limit.generators, dim: self.dim() });
        }
        let within =
            |set: &Self| set.num_generators() <= limit.generators && set.num_constraints() <= limit.constraints;
        if within(self) {
            return Ok(());
        }
        // Each step leaves the set unchanged if it fails, and is valid by itself: the last one can only fail by overflow.
        let mut before = self.copy_into(workspace.backup.take());
        let steps = |set: &mut Self, workspace: &mut Workspace| -> Result<(), SetError> {
            set.remove_inactive(&mut workspace.coordinates);
            set.rescale(workspace)?;
            set.remove_inactive(&mut workspace.coordinates);
            let most = (set.dim() + set.num_constraints()).saturating_add(limit.generators);
            if set.num_constraints() > limit.constraints && set.num_generators() > most {
                set.reduce_generators(method, most, workspace)?;
            }
            set.eliminate_comparing(limit.constraints, candidates, workspace)?;
            if set.num_generators() > limit.generators {
                set.eliminate_comparing(limit.generators - set.dim(), candidates, workspace)?;
                set.reduce_generators(method, limit.generators, workspace)?;
            }
            Ok(())
        };
        let result = steps(self, workspace);
        if result.is_err() {
            core::mem::swap(self, &mut before);
        }
        workspace.backup = Some(before);
        result
    }

    /// Encloses the set in one with at most `max_generators` generators and the same number of constraints.
    ///
    /// The set is the part of the lifted zonotope `{ (x, t) : x = c + G xi + e, t = A xi }` of dimension `n + nc` with `t in [b]`;
    /// the lift is reduced as a zonotope, and what rounding adds to its remainder in `t` widens `[b]`. Rows that an intersection has formed from
    /// `G` make the lift flat; [`Reduction::Method4`] reduces it in its span.
    ///
    /// **Guarantee:** superset of the set; at most `max_generators` generators.
    /// **Source:** Scott, Raimondo, Marseglia, Braatz 2016, Section 4.3.
    ///
    /// # Errors
    /// [`SetError::TooFewGenerators`] for a limit below `n + nc`, [`SetError::Overflow`]; the set is then unchanged.
    pub fn reduce_generators(
        &mut self,
        method: Reduction,
        max_generators: usize,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        let (n, size) = (self.dim(), self.dim() + self.num_constraints());
        if max_generators < size {
            return Err(SetError::TooFewGenerators { max_generators, dim: size });
        }
        if self.num_generators() <= max_generators {
            return Ok(());
        }
        let mut lift = workspace.lift.take().unwrap_or_else(|| self.body.clone());
        self.lift_into(&mut lift);
        let result = lift.reduce(method, max_generators, workspace).and_then(|()| self.adopt(&lift, n));
        workspace.lift = Some(lift);
        result?;
        self.remove_inactive(&mut workspace.coordinates);
        self.clip_ranges();
        Ok(())
    }

    /// `<(c, 0), [G; A], (r, 0)>`.
    fn lift_into(&self, lift: &mut Zonotope) {
        let (n, rows) = (self.dim(), self.num_constraints());
        lift.center.clear();
        lift.center.extend_from_slice(self.center());
        lift.center.resize(n + rows, 0.0);
        lift.remainder.clear();
        lift.remainder.extend_from_slice(self.remainder());
        lift.remainder.resize(n + rows, 0.0);
        lift.generators.reset(n + rows, self.num_generators());
        for j in 0..self.num_generators() {
            let column = lift.generators.col_mut(j);
            column[..n].copy_from_slice(self.generators().col(j));
            column[n..].copy_from_slice(self.constraints.col(j));
        }
    }

    /// Takes generators and remainder from a lift, whose center has not changed.
    fn adopt(&mut self, lift: &Zonotope, n: usize) -> Result<(), SetError> {
        for i in 0..self.num_constraints() {
            let sum = lift.generators().columns().map(|column| column[n + i].abs()).sum();
            finite_norm(i, sum, lift.num_generators())?;
            if !self.ranges[i].inflate(lift.remainder()[n + i]).is_bounded() {
                return Err(SetError::Overflow { row: i });
            }
        }
        let rows = self.num_constraints();
        self.body.remainder.copy_from_slice(&lift.remainder()[..n]);
        self.body.generators.reset(n, lift.num_generators());
        self.constraints.reset(rows, lift.num_generators());
        for (j, column) in lift.generators().columns().enumerate() {
            self.body.generators.col_mut(j).copy_from_slice(&column[..n]);
            self.constraints.col_mut(j).copy_from_slice(&column[n..]);
        }
        for (range, &widening) in self.ranges.iter_mut().zip(&lift.remainder()[n..]) {
            *range = range.inflate(widening);
        }
        Ok(())
    }
}
