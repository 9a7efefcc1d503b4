//! The floating-point environment the guarantees rest on.

use std::hint::black_box;

/// True if the thread rounds to nearest and keeps subnormal numbers (no flush-to-zero, no denormals-are-zero).
///
/// All bounds of this crate assume it. Foreign libraries may leave a process in another mode; call this at entry of
/// a computation whose bounds matter. It costs some tens of nanoseconds.
#[inline]
#[must_use]
pub fn fp_env_ok() -> bool {
    let one = black_box(1.0_f64);
    let tiny = black_box(f64::EPSILON / 4.0);
    let min_normal = black_box(f64::MIN_POSITIVE);
    let nearest =
        one + tiny == 1.0 && one - tiny / 2.0 == 1.0 && -one - tiny == -1.0 && one + 3.0 * tiny == 1.0 + f64::EPSILON;
    let half = black_box(min_normal * 0.5);
    nearest && half > 0.0 && black_box(half + half) == min_normal
}
