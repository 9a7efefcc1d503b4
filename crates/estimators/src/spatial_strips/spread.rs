//! The rotations of a box of rotation vectors, as intervals of nine coordinates of their matrices.
//!
//! With `t = |r|`, `s = sin t / t`, `c = (1 - cos t) / t^2`: `exp(r) = I + s r^ + c r^^2`. Its antisymmetric part is `u^` with `u = s r`, first order
//! in `r`; its symmetric part has the diagonal `1 - c (r_j^2 + r_k^2)` and beside it `c r_j r_k`, both second order.

use scalars::Interval;

use super::space::{Matrix, Region};

/// The other two axes beside each.
pub(super) const OTHERS: [(usize, usize); 3] = [(1, 2), (2, 0), (0, 1)];

/// `(u, diagonal, off)` of `exp(r)` over a box of `r`: `off_i` is the symmetric part of the entries of the other two axes.
///
/// **Guarantee:** superset.
pub(super) fn coordinates(turn: &Region) -> [Interval; 9] {
    let squares = turn.map(Interval::sqr);
    let square = squares[0] + squares[1] + squares[2];
    let (sinc, versine) = (square.stumpff(1), square.stumpff(2));
    let unit = Interval::ONE.hull(-Interval::ONE);
    let mut all = [Interval::ZERO; 9];
    for (i, (j, k)) in OTHERS.into_iter().enumerate() {
        all[i] = (sinc * turn[i]).intersection(unit);
        all[3 + i] = (Interval::ONE - versine * (squares[j] + squares[k])).intersection(unit);
        all[6 + i] = (versine * (turn[j] * turn[k])).intersection(unit);
    }
    all
}

/// What a functional `<K, exp(r)> = sum K_jk exp(r)_jk` has before each coordinate, rounded.
#[inline]
pub(super) fn weights(k: &Matrix) -> [f64; 9] {
    [
        k[2][1] - k[1][2],
        k[0][2] - k[2][0],
        k[1][0] - k[0][1],
        k[0][0],
        k[1][1],
        k[2][2],
        k[1][2] + k[2][1],
        k[2][0] + k[0][2],
        k[0][1] + k[1][0],
    ]
}

/// The matrices `exp(-r)` over a box of `r`, as middles and radii of the coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spread {
    middles: [f64; 9],
    radii: [f64; 9],
}

impl Spread {
    pub(super) fn new(turn: &Region) -> Self {
        let mut all = coordinates(turn);
        for u in &mut all[..3] {
            *u = -*u;
        }
        let middles = all.map(|side| side.mid());
        let radii = all.map(|side| side.rad());
        Self { middles, radii }
    }

    /// Upper bound of `max |<K, exp(-r)>|`, but for at most 60 roundings of `|K|_1`.
    #[inline]
    pub(super) fn sup_abs(&self, k: &Matrix) -> f64 {
        let weights = weights(k);
        let (mut middle, mut radius) = (0.0, 0.0);
        for i in 0..9 {
            middle += weights[i] * self.middles[i];
            radius += weights[i].abs() * self.radii[i];
        }
        middle.abs() + radius
    }
}
