//! Names of the two-frame groups in use.

use crate::{SO2, ScaledSO2, TwoFrame};

/// SE_K(2) by its number of vectors `K` and dimension `N = 1 + 2 K`: heading and `K` fixed-frame vectors (positions, velocities, landmarks).
///
/// SE_1(2) is SE(2), for which [`SE2`](crate::SE2) is the type with names.
pub type SEK2<S, const K: usize, const N: usize> = TwoFrame<SO2<S>, S, 2, K, 0, 1, N>;

/// SE_2(2): heading, position and velocity, tangent `(theta, x1, x2, v1, v2)`.
pub type SE22<S> = SEK2<S, 2, 5>;

/// Sim(2): heading, log-scale and position, tangent `(theta, s, x1, x2)`; acts as `e^s R p + x`.
pub type Sim2<S> = TwoFrame<ScaledSO2<S>, S, 2, 1, 0, 2, 4>;

/// The two-frame group of heading, position and lever arm in the plane, tangent `(theta, x1, x2, l1, l2)`.
pub type TfgLever2<S> = TwoFrame<SO2<S>, S, 2, 1, 1, 1, 5>;

/// The two-frame group of heading, log-scale, position and lever arm in the plane, tangent `(theta, s, x1, x2, l1, l2)` (paper 002, Problem 3).
pub type TfgScaleLever2<S> = TwoFrame<ScaledSO2<S>, S, 2, 1, 1, 2, 6>;
