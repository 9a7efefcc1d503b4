//! Images of sets, `{ f(x, p) : x in X }`; one method a file.

mod polytopic;

pub use polytopic::polytopic_image;
