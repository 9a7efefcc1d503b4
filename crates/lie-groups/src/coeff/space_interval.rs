//! Coefficients of rotations of space over intervals: rigorous ranges from Stumpff functions and monotonicity.

use scalars::{Interval, Scalar};

use super::spin_set::SpinSet;
use super::{ScaledMaps, SpaceCoeff, space_scaled};
use crate::triples::{apply, squared, transposed};
use crate::{Coeff, GroupError};

/// `e = J / (4 q)` and `eta = (J^2 / q^2 - K / q) / 16` at one squared angle.
///
/// `e = sum_k 2 / (4 k^2 pi^2 - x)`, so both rise with `x` up to the pole.
fn e_slope_at(x: f64) -> [Interval; 2] {
    let quarter = Interval::point(x).scale(0.25);
    let [q, c2, c3, c4, c5] = [1, 2, 3, 4, 5].map(|k| quarter.stumpff(k));
    let ratio = (c2 - c3) / q;
    // K = C_3 - 3 C_4 + 3 C_5.
    let k = c3 + (c5 - c4) * Interval::point(3.0);
    [ratio.scale(0.25), (ratio.sqr() - k / q).scale(0.0625)]
}

fn hull<const K: usize>(a: [Interval; K], b: [Interval; K]) -> [Interval; K] {
    std::array::from_fn(|k| a[k].hull(b[k]))
}

fn hull_maps(a: &ScaledMaps<Interval>, b: &ScaledMaps<Interval>) -> ScaledMaps<Interval> {
    ScaledMaps { phi1: hull(a.phi1, b.phi1), phi2: hull(a.phi2, b.phi2), slope: hull(a.slope, b.slope) }
}

/// Up to here, short of a half turn, all coefficients of `s I + W` are monotone in `s` and `x`.
const NEAR: f64 = 9.86;

/// `(beta, gamma)`, each as the difference of two falling functions.
fn slopes(x: Interval) -> [Interval; 2] {
    let [c3, c4, c5] = [3, 4, 5].map(|k| x.stumpff(k));
    [c4.scale(2.0) - c3, c5 * Interval::point(3.0) - c4]
}

impl SpaceCoeff for Interval {
    type Spin = SpinSet;

    fn spin(w: [Interval; 3]) -> SpinSet {
        SpinSet::exp(w)
    }

    fn spin_bc(w: [Interval; 3]) -> (SpinSet, [Interval; 2]) {
        (SpinSet::exp(w), Self::bc(squared(&w)))
    }

    fn spin_log(spin: &SpinSet) -> Result<([Interval; 3], Interval), GroupError> {
        let w = spin.log()?;
        let [e, _] = Self::e_slope(squared(&w))?;
        Ok((w, e))
    }

    fn spin_product(a: &SpinSet, b: &SpinSet) -> SpinSet {
        a.product(b)
    }

    fn spin_reverse(spin: &SpinSet) -> SpinSet {
        spin.reverse()
    }

    fn spin_matrix(spin: &SpinSet) -> [[Interval; 3]; 3] {
        spin.matrix()
    }

    fn spin_act(spin: &SpinSet, v: [Interval; 3]) -> [Interval; 3] {
        apply(&spin.matrix(), v)
    }

    fn spin_act_inv(spin: &SpinSet, v: [Interval; 3]) -> [Interval; 3] {
        apply(&transposed(&spin.matrix()), v)
    }

    fn spin_quaternion(spin: &SpinSet) -> [Interval; 4] {
        spin.quaternion()
    }

    fn spin_from_quaternion(q: [Interval; 4]) -> Result<SpinSet, GroupError> {
        SpinSet::from_quaternion(q)
    }

    fn spin_from_matrix(m: [[Interval; 3]; 3]) -> Result<SpinSet, GroupError> {
        SpinSet::from_matrix(m)
    }

    fn bc(x: Interval) -> [Interval; 2] {
        [x.stumpff(2), x.stumpff(3)]
    }

    fn bc_slopes(x: Interval) -> [Interval; 4] {
        let ([b, c], [beta, gamma]) = (Self::bc(x), slopes(x));
        [b, c, beta, gamma]
    }

    fn e_slope(x: Interval) -> Result<[Interval; 2], GroupError> {
        x.check_finite(0)?;
        let theta = x.sqrt();
        // The f64 number TAU lies below 2 pi: up to it the pole is not reached.
        if theta.hi() > std::f64::consts::TAU {
            return Err(GroupError::FullTurn { theta_lo_rad: theta.lo(), theta_hi_rad: theta.hi() });
        }
        let (lo, hi) = (x.lo().max(0.0), x.hi().max(0.0));
        let at_lo = e_slope_at(lo);
        Ok(if lo == hi { at_lo } else { hull(at_lo, e_slope_at(hi)) })
    }

    /// `phi_k(Z) = int_0^1 e^(r Z) (1 - r)^(k-1) dr` has the coefficients `int r e^(r s) C_1(r^2 x) ..`, `int r^2 e^(r s) C_2(r^2 x) ..`: with the
    /// Stumpff functions positive and falling up to a half turn they rise with `s` and fall with `x`; so do the slopes, negated.
    fn scaled_maps(s: Interval, x: Interval) -> ScaledMaps<Interval> {
        if s.is_empty() || x.is_empty() {
            let (none3, none2) = ([Interval::EMPTY; 3], [Interval::EMPTY; 2]);
            return ScaledMaps { phi1: none3, phi2: none3, slope: none2 };
        }
        if !(s.is_bounded() && x.is_bounded()) {
            let (all3, all2) = ([Interval::ENTIRE; 3], [Interval::ENTIRE; 2]);
            return ScaledMaps { phi1: all3, phi2: all3, slope: all2 };
        }
        let (x_lo, x_hi) = (x.lo().max(0.0), x.hi().max(0.0));
        let far = || {
            let real = hull(space_scaled::real_phi(s.lo()), space_scaled::real_phi(s.hi()));
            space_scaled::closed(s, Interval::lit(x_lo.max(NEAR), x_hi), real)
        };
        if x_lo > NEAR {
            return far();
        }
        let first = space_scaled::at_point::<Interval>(s.lo(), x_hi.min(NEAR));
        if s.lo() == s.hi() && x_lo == x_hi {
            return first;
        }
        let near = hull_maps(&first, &space_scaled::at_point(s.hi(), x_lo));
        if x_hi > NEAR { hull_maps(&near, &far()) } else { near }
    }
}
