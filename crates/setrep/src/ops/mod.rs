//! One operation family a file.

mod affine;
mod cartesian_product;
mod gauge;
mod interval_hull;
mod interval_map;
pub(crate) mod linear_map;
pub(crate) mod materialize;
pub(crate) mod membership;
mod minkowski_sum;
mod planar;
mod size;
pub(crate) mod strip;
mod support;
pub(crate) mod volume;
mod witness;
