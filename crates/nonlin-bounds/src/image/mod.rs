//! Images of sets, `{ f(x, p) : x in X }`; one method a file.

mod affine;
mod dc;
mod decomposition;
mod polytopic;
mod set;

pub use affine::affine_image;
pub use dc::{ConvexSplit, dc_image, dc_image_of_zonotope};
pub use decomposition::{decomposition_image, decomposition_image_of_zonotope};
pub use polytopic::polytopic_image;
pub use set::GeneratorSet;
