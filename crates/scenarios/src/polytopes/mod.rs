//! What the experiments of paper 004 share.
//!
//! Reading order: [`methods`] (the filters by their names), [`sizes`] (volumes, vertices, facets), [`frames`] (figures of the sets step by step), [`tables`] (rows
//! beside the paper's), [`cost`] (a step of V-H in interval hulls).

pub mod cost;
pub mod frames;
pub mod methods;
pub mod sizes;
pub mod tables;

pub use methods::PolytopeCase;
