//! Is a model made for an invariant filter? Residuals of the defining identities on sampled states.
//!
//! A filter on a group has an error that evolves by itself, whatever the estimate, exactly if the dynamics are group affine and the output is
//! compatible. Both are identities between products, so a model can be tried on a few states: residuals of rounding size (1e-15 on states of size 1) say
//! that the identity holds, anything else is the size of its violation.
//!
//! Worth knowing: a vector that is constant **in the body** (a lever arm) is group affine in the plane but not in space, because only
//! rotations of the plane commute. In space the dynamics that are group affine are those of a vector that turns with the frame, `X -> Omega^-1 X`.
//!
//! ```
//! use lie_groups::{LieGroup, SO2, TfgLever2, check_group_affine};
//! use nalgebra::{SVector, Vector2};
//!
//! // Odometry: turn by 0.1, drive 0.5 ahead, the lever arm stays.
//! let step = |x: &TfgLever2<f64>| {
//!     let ahead = x.frame().act(&Vector2::new(0.5, 0.0));
//!     TfgLever2::new(x.frame().compose(&SO2::from_angle(0.1)), [x.fixed()[0] + ahead], *x.body())
//! };
//! let states: Vec<_> = (0..4).map(|k| TfgLever2::exp(&SVector::from_fn(|i, _| ((3 * k + i) as f64).sin()))).collect();
//! assert!(check_group_affine(step, &states)? < 1e-14);
//! # Ok::<(), lie_groups::GroupError>(())
//! ```

use nalgebra::SVector;

use crate::{GroupError, LieGroup};

/// Which error of an estimate `Xhat` of `X`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorKind {
    /// `Xhat^-1 X`.
    Left,
    /// `X Xhat^-1`.
    Right,
}

/// `|log(a^-1 b)|`.
fn gap<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(a: &G, b: &G) -> Result<f64, GroupError> {
    Ok(a.inverse().compose(b).log()?.norm())
}

/// Largest `|log((f(A) f(I)^-1 f(B))^-1 f(A B))|` over all pairs of sampled states: 0 if and only if the dynamics `f` are group affine on them.
///
/// Hold the input of the model fixed in the closure, and try several inputs.
///
/// **Source:** Barrau, Bonnabel, The invariant extended Kalman filter as a stable observer, 2017, equation (4); paper 002, section II.
///
/// # Errors
/// Those of [`LieGroup::log`]: states that are not finite.
pub fn check_group_affine<G, const N: usize, const D: usize>(
    f: impl Fn(&G) -> G,
    states: &[G],
) -> Result<f64, GroupError>
where
    G: LieGroup<f64, N, D>,
{
    let from_identity = f(&G::identity()).inverse();
    let mut worst = 0.0_f64;
    for a in states {
        let moved = f(a).compose(&from_identity);
        for b in states {
            worst = worst.max(gap(&moved.compose(&f(b)), &f(&a.compose(b)))?);
        }
    }
    Ok(worst)
}

/// Largest `|h(A B) - act(A, h(B))|` over all pairs of sampled states: 0 if the output `h` is compatible with the action on outputs.
///
/// `act(A, y)` is the action `A *_y y` that the filter's innovation uses, for a position `y = x + R l` the motion `R y + x`.
///
/// **Source:** paper 002, Definition 2.
pub fn check_compatible_output<G, const N: usize, const D: usize, const M: usize>(
    h: impl Fn(&G) -> SVector<f64, M>,
    act: impl Fn(&G, &SVector<f64, M>) -> SVector<f64, M>,
    states: &[G],
) -> f64
where
    G: LieGroup<f64, N, D>,
{
    let mut worst = 0.0_f64;
    for a in states {
        for b in states {
            let residual = (h(&a.compose(b)) - act(a, &h(b))).norm();
            // NaN is no agreement.
            worst = if residual.is_nan() { f64::INFINITY } else { worst.max(residual) };
        }
    }
    worst
}

/// Spread of the evolution of one error over all sampled estimates: largest `|log(E_i^-1 E_j)|`, where `E_i` is the error after one step of
/// `f` from the error `exp(xi)` at estimate `i`. 0 if the error is autonomous: the same error evolves in the same way everywhere.
///
/// **Source:** paper 002, section II-B.
///
/// # Errors
/// Those of [`LieGroup::log`]: states that are not finite.
pub fn check_autonomous<G, const N: usize, const D: usize>(
    f: impl Fn(&G) -> G,
    kind: ErrorKind,
    errors: &[SVector<f64, N>],
    estimates: &[G],
) -> Result<f64, GroupError>
where
    G: LieGroup<f64, N, D>,
{
    let mut worst = 0.0_f64;
    for xi in errors {
        let error = G::exp(xi);
        let after = |estimate: &G| match kind {
            ErrorKind::Left => f(estimate).inverse().compose(&f(&estimate.compose(&error))),
            ErrorKind::Right => f(&error.compose(estimate)).compose(&f(estimate).inverse()),
        };
        let evolved: Vec<G> = estimates.iter().map(after).collect();
        for (k, a) in evolved.iter().enumerate() {
            for b in &evolved[k + 1..] {
                worst = worst.max(gap(a, b)?);
            }
        }
    }
    Ok(worst)
}
