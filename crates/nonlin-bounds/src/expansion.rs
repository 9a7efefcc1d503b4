//! [`Expansion`]: the point about which a function is expanded over a set.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Zonotope};

use crate::{BoundError, Operand, Workspace};

/// The point `gamma` of the interval hull `H` of a set about which a function is expanded.
///
/// Every point of `H` is valid; the choices differ in tightness. The linear programs of the papers, which minimise a weighted 1-norm of
/// `c - gamma` over the box `H`, are separable: their solution is `c` clamped to `H`, whatever the weights.
///
/// **Source:** paper 003, Section 4.4: heuristics C1, C2 (Proposition 5, equation (16)) and C3.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Expansion<'a> {
    /// C1: the midpoint of the hull, which makes the radius of `X - gamma` least.
    #[default]
    HullCenter,
    /// C2: the center of the zonotope that is left when all constraints are eliminated, clamped to the hull.
    EliminationCenter,
    /// C3: the center `c` of the set, clamped to the hull.
    SetCenter,
    /// A point of the hull.
    Point(&'a [f64]),
}

impl Expansion<'_> {
    /// Writes the point for a zonotope to `point` (length `n`); C2 and C3 are the same here.
    ///
    /// **Guarantee:** the point lies in the hull, exactly.
    ///
    /// # Errors
    /// [`BoundError::Dimension`]; [`BoundError::EmptyInterval`] and [`BoundError::NonFinite`] for a side of the hull that is empty or
    /// unbounded; [`BoundError::OutsideHull`] for a given point. `point` is then unchanged.
    pub fn of_zonotope(&self, set: &Zonotope, hull: &[Interval], point: &mut [f64]) -> Result<(), BoundError> {
        self.check(set.dim(), hull, point)?;
        self.place(set.center(), hull, point);
        Ok(())
    }

    /// Writes the point for a constrained zonotope to `point` (length `n`); allocates nothing within the capacity of the workspace.
    ///
    /// **Guarantee:** the point lies in the hull, exactly.
    ///
    /// # Errors
    /// As [`of_zonotope`](Self::of_zonotope), and [`BoundError::Set`] if an elimination overflows.
    ///
    /// ```
    /// # use nonlin_bounds::{Expansion, Workspace};
    /// # use setrep::{ConstrainedZonotope, Matrix};
    /// let generators = Matrix::from_rows(&[&[0.5, 1.0, -0.5], &[0.5, 0.5, 0.0]])?;
    /// let rows = Matrix::from_rows(&[&[1.0, 1.0, 1.0]])?;
    /// let set = ConstrainedZonotope::from_cg_rep(&[5.0, 0.5], &generators, &rows, &[1.5])?;
    /// let mut workspace = Workspace::new();
    /// let hull = set.interval_hull(&mut workspace.sets)?;
    /// let mut point = [0.0; 2];
    /// Expansion::EliminationCenter.of_constrained(&set, &hull, &mut workspace, &mut point)?;
    /// assert!(hull.contains(&point));
    /// # Ok::<(), nonlin_bounds::BoundError>(())
    /// ```
    pub fn of_constrained(
        &self,
        set: &ConstrainedZonotope,
        hull: &[Interval],
        workspace: &mut Workspace,
        point: &mut [f64],
    ) -> Result<(), BoundError> {
        self.check(set.dim(), hull, point)?;
        if *self != Self::EliminationCenter || set.num_constraints() == 0 {
            self.place(set.center(), hull, point);
            return Ok(());
        }
        let mut free = match workspace.eliminated.take() {
            Some(mut storage) => {
                storage.clone_from(set);
                storage
            }
            None => set.clone(),
        };
        let result = free.eliminate_constraints(0, &mut workspace.sets);
        if result.is_ok() {
            clamp(free.center(), hull, point);
        }
        workspace.eliminated = Some(free);
        Ok(result?)
    }

    /// Checks everything that can be wrong with the arguments.
    fn check(&self, dim: usize, hull: &[Interval], point: &[f64]) -> Result<(), BoundError> {
        BoundError::check_box(Operand::Hull, dim, hull)?;
        BoundError::check_size(Operand::ExpansionPoint, dim, point.len())?;
        let Self::Point(given) = self else { return Ok(()) };
        BoundError::check_size(Operand::ExpansionPoint, dim, given.len())?;
        if let Some(index) = given.iter().position(|x| !x.is_finite()) {
            return Err(BoundError::NonFinite { operand: Operand::ExpansionPoint, index });
        }
        match hull.iter().zip(*given).position(|(side, &x)| !side.contains(x)) {
            None => Ok(()),
            Some(index) => Err(BoundError::OutsideHull { index }),
        }
    }

    /// Writes the point for checked arguments and a set of the given center.
    fn place(&self, center: &[f64], hull: &[Interval], point: &mut [f64]) {
        match self {
            Self::HullCenter => point.iter_mut().zip(hull).for_each(|(x, side)| *x = side.mid()),
            Self::EliminationCenter | Self::SetCenter => clamp(center, hull, point),
            Self::Point(given) => point.copy_from_slice(given),
        }
    }
}

/// The point of the box next to `center`, coordinate by coordinate.
fn clamp(center: &[f64], hull: &[Interval], point: &mut [f64]) {
    for ((x, side), c) in point.iter_mut().zip(hull).zip(center) {
        *x = c.max(side.lo()).min(side.hi());
    }
}
