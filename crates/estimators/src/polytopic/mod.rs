//! Filters on polytopes: paper 004's direct one on vertices, [`Vh`]; its rivals, the mean value filter [`Rrsr`] and those by decomposition
//! functions, [`DCz`] and [`DZb`]; and several filters at once, [`Comb`].
//!
//! Reading order: `vh`, with `noise` (noises beside vertices); `d_cz`, `d_zb`, with `decomposed` (their update); `rrsr`; `comb`, with `forms` (what a polytope can be turned into);
//! `stability` ([`stability()`]: do the sets stay bounded?).

mod comb;
mod d_cz;
mod d_zb;
mod decomposed;
mod forms;
mod noise;
mod rrsr;
mod stability;
mod vh;

pub use comb::{Comb, CombMember, CombOptions};
pub use d_cz::{DCz, DCzOptions, DCzScratch, DecomposedConstrained};
pub use d_zb::{DZb, DZbOptions, DZbScratch, DecomposedBundle};
pub use forms::PolytopeForm;
pub use rrsr::Rrsr;
pub use stability::{Stability, WidthBound, stability};
pub use vh::{VertexPolytopes, Vh, VhCenter, VhOptions, VhScratch};
