//! Sets that enclose: zonotopes, constrained zonotopes and their operations, rounding included.
//!
//! The centre of the crate is [`Zonotope`], the set `<c, G, r> = { c + G xi + e : |xi| <= 1, |e| <= r }` of a center, generators
//! and a **box remainder**. Every operation on it returns a superset of the exact real-arithmetic result for its `f64` inputs:
//! what floating point rounds away is bounded and added to `r`. What cannot promise that says `approx` in its name or in its
//! first line of documentation.
//!
//! [`ConstrainedZonotope`] adds constraints with ranges, `A xi in [b]`: intersections with strips, half-spaces and other sets are exact
//! but for rounding, and support, hull, emptiness and membership come with proofs from linear programs that need not be trusted.
//!
//! Its [`reencode`](ConstrainedZonotope::reencode) bounds its complexity; [`ZonotopeBundle`] keeps an intersection of zonotopes as it is.
//!
//! Reading order: [`Matrix`], [`IntervalVector`], [`IntervalMatrix`], [`Zonotope`], then one operation a file in `ops`,
//! one order reduction a file in `reduce`; [`ConstrainedZonotope`] with its operations in `constrained_zonotope` (LP re-encoding in
//! `reencode`, sets in sets in `inclusion`), [`ZonotopeBundle`] in `bundle`; [`Strip`] and [`HalfSpace`]; [`HPolytope`] and [`VPolytope`]
//! in `polytope`. What all have in common is [`SupportFunction`]; from it alone come polytopes of bounded size around a set
//! ([`HPolytope::enclosing`]) and, in `plot`, [`Outline`] and [`Mesh`].
//!
//! ```
//! use setrep::{Matrix, Reduction, Workspace, Zonotope};
//!
//! let mut workspace = Workspace::new();
//! let rotation = Matrix::from_rows(&[&[0.8, -0.6], &[0.6, 0.8]])?;
//! let noise = Zonotope::from_box(&[0.0, 0.0], &[0.1, 0.1])?;
//!
//! let mut set = Zonotope::from_box(&[1.0, 2.0], &[0.5, 0.25])?;
//! for _ in 0..10 {
//!     set.linear_map_in_place(&rotation, &mut workspace)?;
//!     set.add_assign(&noise)?;
//!     set.reduce(Reduction::Girard, 8, &mut workspace)?;
//! }
//! assert!(set.num_generators() <= 8);
//! # Ok::<(), setrep::SetError>(())
//! ```

mod bounds;
mod bundle;
mod cholesky;
mod constrained_zonotope;
mod error;
mod interval_matrix;
mod interval_vector;
mod matrix;
mod matrix_nalgebra;
mod ops;
mod plot;
mod polytope;
mod reduce;
mod strip;
mod support_function;
mod wedge;
mod workspace;
mod zonotope;

pub use bundle::{BundleComplexity, ZonotopeBundle};
pub use constrained_zonotope::{
    Complexity, ConstrainedZonotope, Containment, Contradiction, Directions, Emptiness, Optimizer, Reencoding,
    TemplateWidths,
};
pub use error::{Part, SetError};
pub use interval_matrix::IntervalMatrix;
pub use interval_vector::IntervalVector;
pub use matrix::Matrix;
pub use ops::membership::{FACET_LIMIT, Membership};
pub use ops::strip::{StripCut, StripRule};
pub use ops::volume::MINOR_LIMIT;
pub use plot::{Mesh, Outline};
pub use polytope::{
    BoxedRows, ChebyshevBall, Feasibility, HPolytope, MAX_FACES, PolytopeOptimizer, RowContradiction, VPolytope,
};
pub use reduce::Reduction;
pub use strip::{HalfSpace, Strip};
pub use support_function::SupportFunction;
pub use workspace::Workspace;
pub use zonotope::Zonotope;
