//! Sets in sets, and what a set can lose: questions about all points of a set at once, with answers that are proofs.
//!
//! Both start from a factorisation `L C = T + M B` (a linear program without a box, by Clarabel), of which nothing is believed: what it
//! misses by is enclosed, taken up by a proven [correction](correction::Correction), and every bound is proven again.

mod contains;
mod correction;
mod factorization;
mod pontryagin;

pub use contains::Containment;
