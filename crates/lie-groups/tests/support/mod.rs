//! What the test binaries share; each uses a part of it.
#![allow(dead_code)]

pub mod dd;
pub mod dense;
pub mod random;
