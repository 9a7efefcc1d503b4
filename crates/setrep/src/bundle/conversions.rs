//! Bundles and constrained zonotopes.

use scalars::Interval;
use scalars::rounding::{add_down, add_up, sub_down, sub_up};

use super::ZonotopeBundle;
use crate::bounds::two_sum;
use crate::{ConstrainedZonotope, SetError, Zonotope};

impl ZonotopeBundle {
    /// The intersection as a constrained zonotope: all generators side by side, `n` equality rows for each further member.
    ///
    /// With `Z_1 = <c, G, 0>` and `Z_i = <d, H, s>`, the row block `[G  -H]` in `d - c +- s` says that both mean the same point. A
    /// remainder of `Z_1` of model size becomes generators first; what is left of it widens the rows, with their rounding.
    ///
    /// **Guarantee:** superset of the intersection; the same set but for rounding.
    /// **Source:** Scott, Raimondo, Marseglia, Braatz 2016, Proposition 1.
    ///
    /// # Errors
    /// [`SetError::Overflow`].
    pub fn to_constrained_zonotope(&self) -> Result<ConstrainedZonotope, SetError> {
        let mut set = ConstrainedZonotope::from(self.first().clone());
        self.assemble(&mut set)?;
        Ok(set)
    }

    /// [`to_constrained_zonotope`](Self::to_constrained_zonotope) into existing storage; what that holds after an error is a valid set.
    pub(super) fn assemble(&self, target: &mut ConstrainedZonotope) -> Result<(), SetError> {
        let n = self.dim();
        let rest = &self.members[1..];
        let ConstrainedZonotope { body, constraints, ranges } = target;
        ranges.clear();
        body.clone_from(self.first());
        if !rest.is_empty() {
            body.materialize_model_size();
        }
        let own = body.generators.cols();
        let mut column = own;
        body.generators.push_zero_cols(rest.iter().map(Zonotope::num_generators).sum());
        constraints.reset(n * rest.len(), body.generators.cols());
        for (block, member) in rest.iter().enumerate() {
            let rows = block * n..(block + 1) * n;
            for j in 0..own {
                constraints.col_mut(j)[rows.clone()].copy_from_slice(body.generators.col(j));
            }
            for h in member.generators().columns() {
                let target = &mut constraints.col_mut(column)[rows.clone()];
                target.iter_mut().zip(h).for_each(|(a, h)| *a = -h);
                column += 1;
            }
            for i in 0..n {
                let theirs = Interval::point(member.center()[i]).inflate(member.remainder()[i]);
                ranges.push(theirs - Interval::point(body.center[i]).inflate(body.remainder[i]));
            }
        }
        target.settle_ranges()
    }

    /// As [`to_constrained_zonotope`](Self::to_constrained_zonotope) with ranges rounded inward and `e = 0` for the first member: a
    /// subset of the intersection. `None` if rounding leaves nothing of a range.
    pub(super) fn inner_program(&self) -> Result<Option<ConstrainedZonotope>, SetError> {
        let mut inner = self.to_constrained_zonotope()?;
        inner.body.remainder.fill(0.0);
        let n = self.dim();
        for (row, range) in inner.ranges.iter_mut().enumerate() {
            let (member, i) = (&self.members[1 + row / n], row % n);
            let (difference, error) = two_sum(member.center()[i], -inner.body.center[i]);
            let (slack, error) = (member.remainder()[i], error.abs());
            let ends = if slack == 0.0 && error == 0.0 {
                (difference, difference)
            } else {
                (add_up(sub_up(difference, slack), error), sub_down(add_down(difference, slack), error))
            };
            let Ok(narrowed) = Interval::new(ends.0, ends.1) else { return Ok(None) };
            *range = narrowed;
        }
        Ok(Some(inner))
    }
}
