//! Outward-rounded interval arithmetic and the scalar trait models are written in.
