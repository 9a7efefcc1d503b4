//! What the test binaries share; each uses a part of it.
#![allow(dead_code)]

pub(crate) mod dd;
pub(crate) mod dense;
pub(crate) mod erased;
pub(crate) mod random;
