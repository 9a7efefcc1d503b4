//! Names of the two-frame groups in use.

use crate::{SO2, SO3, ScaledSO2, ScaledSO3, TwoFrame};

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

/// SE(3): rotation and position, tangent `(w1, w2, w3, x1, x2, x3)`.
pub type SE3<S> = TwoFrame<SO3<S>, S, 3, 1, 0, 3, 6>;

/// SE_2(3): rotation, position and velocity, tangent `(w, x, v)`; `act` moves points by the position.
pub type SE23<S> = TwoFrame<SO3<S>, S, 3, 2, 0, 3, 9>;

/// SE_K(3) by its number of vectors `K` and dimension `N = 3 + 3 K`.
pub type SEK3<S, const K: usize, const N: usize> = TwoFrame<SO3<S>, S, 3, K, 0, 3, N>;

/// Sim(3): rotation, log-scale and position, tangent `(w, s, x)`; acts as `e^s R p + x`.
pub type Sim3<S> = TwoFrame<ScaledSO3<S>, S, 3, 1, 0, 4, 7>;

/// The two-frame group of rotation, position and lever arm in space, tangent `(w, x, l)`.
pub type TfgLever3<S> = TwoFrame<SO3<S>, S, 3, 1, 1, 3, 9>;

/// The two-frame group of rotation, log-scale, position and lever arm in space, tangent `(w, s, x, l)`.
pub type TfgScaleLever3<S> = TwoFrame<ScaledSO3<S>, S, 3, 1, 1, 4, 10>;
