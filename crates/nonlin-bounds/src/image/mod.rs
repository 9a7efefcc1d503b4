//! Images of sets, `{ f(x, p) : x in X }`; one method a file.
//!
//! | method | set types | adds | take it |
//! |---|---|---|---|
//! | [`affine_image`], `Form::Taylor` | zonotope, constrained zonotope | nothing | by default |
//! | [`affine_image`], `Form::Slope` | both | nothing | about a point far from the middle of the hull |
//! | [`affine_image`], `Form::MeanValue` | both | nothing | without Hessians |
//! | [`affine_image`], `Form::Natural` | both | nothing | where nothing is smooth |
//! | [`QuadraticEnclosure::image`](crate::QuadraticEnclosure::image) | both | `ng (ng + 1) / 2` generators | for the shape of a curved image |
//! | [`decomposition_image`] | both | a constraint an output at most | where outputs are nearly monotone along axes or generators |
//! | [`dc_image`] | both | nothing | for functions that are known to be convex but for a convex part |
//! | [`polytopic_image`] | V-polytope | vertices | for sets far from a parallelotope |
//!
//! "Nothing": the remainder of the affine forms goes to the set's box remainder. It is model-size there; what is done next to the set
//! turns it into generators where it must.

mod affine;
mod dc;
mod decomposition;
mod polytopic;
mod set;

pub use affine::affine_image;
pub(crate) use affine::enclose_over_hull;
pub use dc::{ConvexSplit, dc_image, dc_image_of_zonotope};
pub use decomposition::{decomposition_image, decomposition_image_of_zonotope, decomposition_images_of_zonotope};
pub use polytopic::{polytopic_image, polytopic_image_with_noise};
pub use set::GeneratorSet;
