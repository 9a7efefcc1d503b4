//! Timed comparisons.
