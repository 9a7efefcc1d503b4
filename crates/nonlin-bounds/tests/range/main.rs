//! Expansion points and ranges of functions over boxes.

mod expansion;
