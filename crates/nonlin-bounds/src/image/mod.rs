//! Images of sets, `{ f(x, p) : x in X }`; one method a file.

mod affine;
mod polytopic;
mod set;

pub use affine::affine_image;
pub use polytopic::polytopic_image;
pub use set::GeneratorSet;
