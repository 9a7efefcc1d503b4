//! What images ask of a set made of generators.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, SetError, Zonotope};

use crate::{BoundError, Expansion, Workspace};

/// A set made of generators, whose images under affine functions are cheap: [`Zonotope`] and [`ConstrainedZonotope`].
pub trait GeneratorSet: Clone + sealed::Sealed {
    /// Dimension `n` of the space.
    fn dim(&self) -> usize;

    /// Interval hull into a slice of length `n`, by linear programs where there are constraints.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::TooLarge`].
    fn hull_into(&self, hull: &mut [Interval], workspace: &mut setrep::Workspace) -> Result<(), SetError>;
}

pub(crate) mod sealed {
    use super::{BoundError, ConstrainedZonotope, Expansion, Interval, Matrix, SetError, Workspace, Zonotope};

    /// The steps of an affine image, each in place.
    pub trait Sealed: Sized {
        /// The set of the workspace that an image is built in.
        fn draft(workspace: &mut Workspace) -> &mut Option<Self>;
        /// The expansion point in the hull.
        fn expand(
            &self,
            at: &Expansion<'_>,
            hull: &[Interval],
            workspace: &mut Workspace,
            point: &mut [f64],
        ) -> Result<(), BoundError>;
        /// `t + X`.
        fn shift(&mut self, translation: &[f64]) -> Result<(), SetError>;
        /// `R X`.
        fn map(&mut self, map: &Matrix, workspace: &mut setrep::Workspace) -> Result<(), SetError>;
        /// `X + [e]`.
        fn add_sides(&mut self, sides: &[Interval]) -> Result<(), SetError>;
        /// A superset of `X + Y`, the sum itself but for the constraints of `Y` where there can be none.
        fn add_set(&mut self, other: &ConstrainedZonotope) -> Result<(), SetError>;
        /// The set without its constraints, and these.
        fn body(&self) -> (&Zonotope, Option<&ConstrainedZonotope>);
    }
}

impl GeneratorSet for Zonotope {
    fn dim(&self) -> usize {
        self.dim()
    }

    fn hull_into(&self, hull: &mut [Interval], _workspace: &mut setrep::Workspace) -> Result<(), SetError> {
        self.interval_hull_into(hull)
    }
}

impl GeneratorSet for ConstrainedZonotope {
    fn dim(&self) -> usize {
        self.dim()
    }

    fn hull_into(&self, hull: &mut [Interval], workspace: &mut setrep::Workspace) -> Result<(), SetError> {
        self.interval_hull_into(hull, workspace)
    }
}

/// The steps by the set's own methods.
macro_rules! steps {
    ($set:ty, $draft:ident, $point:expr, $other:expr, $body:expr) => {
        impl sealed::Sealed for $set {
            fn draft(workspace: &mut Workspace) -> &mut Option<Self> {
                &mut workspace.$draft
            }
            fn expand(
                &self,
                at: &Expansion<'_>,
                hull: &[Interval],
                workspace: &mut Workspace,
                point: &mut [f64],
            ) -> Result<(), BoundError> {
                $point(self, at, hull, workspace, point)
            }
            fn shift(&mut self, translation: &[f64]) -> Result<(), SetError> {
                self.translate(translation)
            }
            fn map(&mut self, map: &Matrix, workspace: &mut setrep::Workspace) -> Result<(), SetError> {
                self.linear_map_in_place(map, workspace)
            }
            fn add_sides(&mut self, sides: &[Interval]) -> Result<(), SetError> {
                self.add_box(sides)
            }
            fn add_set(&mut self, other: &ConstrainedZonotope) -> Result<(), SetError> {
                self.add_assign($other(other))
            }
            fn body(&self) -> (&Zonotope, Option<&ConstrainedZonotope>) {
                $body(self)
            }
        }
    };
}
steps!(
    Zonotope,
    zonotope,
    |set: &Zonotope, at: &Expansion<'_>, hull: &[Interval], _, point: &mut [f64]| at.of_zonotope(set, hull, point),
    ConstrainedZonotope::unconstrained,
    |set| (set, None)
);
steps!(
    ConstrainedZonotope,
    constrained,
    |set, at: &Expansion<'_>, hull: &[Interval], workspace, point: &mut [f64]| {
        at.of_constrained(set, hull, workspace, point)
    },
    |set| set,
    with_constraints
);

fn with_constraints(set: &ConstrainedZonotope) -> (&Zonotope, Option<&ConstrainedZonotope>) {
    (set.unconstrained(), Some(set))
}
