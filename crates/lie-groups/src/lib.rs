//! Lie groups over f64 and over intervals: exp, log, Jacobians with rigorous enclosures.
