//! Filters on polytopes: paper 004's direct one on vertices, [`Vh`], and its rivals.
//!
//! Reading order: `vh`; `noise` (noises beside vertices).

mod noise;
mod vh;

pub use vh::{VertexPolytopes, Vh, VhOptions, VhScratch};
