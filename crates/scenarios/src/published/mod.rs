//! Algorithms as papers 003 and 004 print them or as their authors run them, in plain floating point.
//!
//! They are here to reproduce numbers and to show what an enclosure gains: none of them accounts for rounding, and the printed
//! form of Lemma 2 of paper 003 is no enclosure at all. Their valid counterparts are those of `nonlin-bounds` and `setrep`.
//!
//! Reading order: [`cg_rep`] (the set), [`elimination`] (of its constraints), [`inclusion`], [`mean_value`] and [`taylor`]
//! (paper 003), [`theorem_2`] and [`cas_jacobian`] (paper 004).

pub mod cas_jacobian;
pub mod cg_rep;
pub mod elimination;
pub mod inclusion;
pub mod mean_value;
pub mod taylor;
pub mod theorem_2;

pub use cg_rep::CgRep;
