//! Temporaries of a generic evaluation, on the stack up to a limit.

use scalars::Scalar;

/// Calls `work` with `size` zeros: on the stack up to 64, allocated beyond.
#[inline]
pub(crate) fn with_zeros<S: Scalar, R>(size: usize, work: impl FnOnce(&mut [S]) -> R) -> R {
    match size {
        0..=4 => on_stack::<S, R, 4>(size, work),
        5..=8 => on_stack::<S, R, 8>(size, work),
        9..=16 => on_stack::<S, R, 16>(size, work),
        17..=64 => on_stack::<S, R, 64>(size, work),
        _ => work(&mut vec![S::zero(); size]),
    }
}

/// A frame of its own for every size, so that small ones stay small.
#[inline(never)]
fn on_stack<S: Scalar, R, const K: usize>(size: usize, work: impl FnOnce(&mut [S]) -> R) -> R {
    work(&mut [S::zero(); K][..size])
}
