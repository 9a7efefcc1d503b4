//! Reverse elementary functions, with the conventions of [`super::reverse`].

use scalars::Interval;

use super::reverse::{between, both_signs, factor, from, nonnegative, up_to};

/// Largest angle whose turns are counted; the bounds of larger ones are left alone.
const LARGEST_ANGLE: f64 = 1e9;

/// Numbers between -1 and 1.
fn unit() -> Interval {
    between(-1.0, 1.0)
}

/// `a` of `z = sin(a)`: the pieces `j pi + (-1)^j asin(z)`.
pub(super) fn sin(z: Interval, a: Interval) -> Interval {
    let z = z.intersection(unit());
    if z == unit() {
        return a;
    }
    let angle = z.asin();
    periodic(a, z.is_empty(), |j| if j % 2.0 == 0.0 { multiple_of_pi(j) + angle } else { multiple_of_pi(j) - angle })
}

/// `a` of `z = cos(a)`: the pieces `j pi + acos(z)` for even `j`, `(j + 1) pi - acos(z)` for odd.
pub(super) fn cos(z: Interval, a: Interval) -> Interval {
    let z = z.intersection(unit());
    if z == unit() {
        return a;
    }
    let angle = z.acos();
    periodic(
        a,
        z.is_empty(),
        |j| {
            if j % 2.0 == 0.0 { multiple_of_pi(j) + angle } else { multiple_of_pi(j + 1.0) - angle }
        },
    )
}

/// `a` of `z = tan(a)`: the pieces `j pi + atan(z)`.
pub(super) fn tan(z: Interval, a: Interval) -> Interval {
    if z == Interval::ENTIRE {
        return a;
    }
    let angle = z.atan();
    periodic(a, z.is_empty(), |j| multiple_of_pi(j) + angle)
}

fn multiple_of_pi(j: f64) -> Interval {
    Interval::PI.scale(j)
}

/// Points of `a` in the union of the pieces, where piece `j` lies between `(j - 1/2) pi` and `(j + 1) pi` and the pieces are in order.
fn periodic(a: Interval, no_piece: bool, piece: impl Fn(f64) -> Interval) -> Interval {
    if no_piece || a.is_empty() {
        return Interval::EMPTY;
    }
    let pi = std::f64::consts::PI;
    let mut kept = a;
    if a.lo().abs() <= LARGEST_ANGLE {
        // All pieces before this one end a turn below a.
        let mut j = (a.lo() / pi).floor() - 2.0;
        while piece(j).hi() < a.lo() {
            j += 1.0;
        }
        kept = kept.intersection(from(piece(j).lo()));
    }
    if a.hi().abs() <= LARGEST_ANGLE && !kept.is_empty() {
        let mut j = (a.hi() / pi).ceil() + 1.0;
        while piece(j).lo() > a.hi() {
            j -= 1.0;
        }
        kept = kept.intersection(up_to(piece(j).hi()));
    }
    kept
}

/// `a` of `z = asin(a)`.
pub(super) fn asin(z: Interval, a: Interval) -> Interval {
    let quarter = Interval::FRAC_PI_2.hi();
    a.intersection(unit()).intersection(z.intersection(between(-quarter, quarter)).sin())
}

/// `a` of `z = acos(a)`.
pub(super) fn acos(z: Interval, a: Interval) -> Interval {
    a.intersection(unit()).intersection(z.intersection(between(0.0, Interval::PI.hi())).cos())
}

/// `a` of `z = atan(a)`.
pub(super) fn atan(z: Interval, a: Interval) -> Interval {
    let quarter = Interval::FRAC_PI_2;
    let z = z.intersection(between(-quarter.hi(), quarter.hi()));
    if z.is_empty() {
        return z;
    }
    let lower = if z.lo() > -quarter.lo() { from(Interval::point(z.lo()).tan().lo()) } else { Interval::ENTIRE };
    let upper = if z.hi() < quarter.lo() { up_to(Interval::point(z.hi()).tan().hi()) } else { Interval::ENTIRE };
    a.intersection(lower).intersection(upper)
}

/// `y` of `z = atan2(y, x)`, from `y = r sin z`, `r^2 = x^2 + y^2`, and `y = x tan z`.
pub(super) fn ordinate(z: Interval, y: Interval, x: Interval) -> Interval {
    let z = principal(z);
    let y = y.intersection(radius(x, y) * z.sin());
    let slope = z.tan();
    if slope.is_bounded() { y.intersection(x * slope) } else { y }
}

/// `x` of `z = atan2(y, x)`, from `x = r cos z`, `r^2 = x^2 + y^2`, and `y = x tan z`.
pub(super) fn abscissa(z: Interval, y: Interval, x: Interval) -> Interval {
    let z = principal(z);
    let x = x.intersection(radius(x, y) * z.cos());
    let slope = z.tan();
    if slope.is_bounded() { factor(y, slope, x) } else { x }
}

/// The angles in `[-pi, pi]`.
fn principal(z: Interval) -> Interval {
    z.intersection(between(-Interval::PI.hi(), Interval::PI.hi()))
}

fn radius(x: Interval, y: Interval) -> Interval {
    (x.sqr() + y.sqr()).sqrt()
}

/// `a` of `z = sinh(a)`.
pub(super) fn sinh(z: Interval, a: Interval) -> Interval {
    a.intersection(odd_inverse(z, asinh))
}

/// `a` of `z = cosh(a)`.
pub(super) fn cosh(z: Interval, a: Interval) -> Interval {
    let z = z.intersection(from(1.0));
    if z.is_empty() {
        return z;
    }
    // acosh z = ln(z + sqrt((z - 1) (z + 1))), increasing.
    let at = |x: f64| {
        let x = Interval::point(x);
        nonnegative((x + (x.add_f64(-1.0) * x.add_f64(1.0)).sqrt()).ln())
    };
    let upper = if z.hi() < f64::INFINITY { at(z.hi()).hi() } else { f64::INFINITY };
    both_signs(between(at(z.lo()).lo(), upper), a)
}

/// `a` of `z = tanh(a)`.
pub(super) fn tanh(z: Interval, a: Interval) -> Interval {
    a.intersection(odd_inverse(z.intersection(unit()), atanh))
}

/// Image of `z` under an increasing odd function, from enclosures of its values at numbers `>= 0`.
fn odd_inverse(z: Interval, at: impl Fn(f64) -> Interval) -> Interval {
    if z.is_empty() {
        return z;
    }
    let signed = |x: f64| if x < 0.0 { -at(-x) } else { at(x) };
    between(signed(z.lo()).lo(), signed(z.hi()).hi())
}

/// `asinh x = ln(x + sqrt(x^2 + 1))` for `x >= 0`, between `x - x^3 / 6` and `x`.
fn asinh(x: f64) -> Interval {
    if x == f64::INFINITY {
        return from(f64::MAX.ln().next_down());
    }
    let x = Interval::point(x);
    let cubic = x - x.powi(3) / Interval::point(6.0);
    (x + x.sqr().add_f64(1.0).sqrt()).ln().intersection(nonnegative(between(cubic.lo(), x.hi())))
}

/// `atanh x = ln((1 + x) / (1 - x)) / 2` for `0 <= x <= 1`, between `x` and `x + x^3 / (3 (1 - x^2))`.
fn atanh(x: f64) -> Interval {
    if x >= 1.0 {
        return from(18.0);
    }
    let x = Interval::point(x);
    let (above, below) = (x.add_f64(1.0), -x.add_f64(-1.0));
    let cubic = x + x.powi(3) / (above * below).scale(3.0);
    (above / below).ln().scale(0.5).intersection(between(x.lo(), cubic.hi()))
}

/// The root of degree `n >= 1` of an interval of numbers `>= 0`: `exp(ln(z) / n)`.
pub(super) fn root(z: Interval, n: u32) -> Interval {
    if z == Interval::ZERO {
        return z;
    }
    (z.ln() / Interval::point(f64::from(n))).exp()
}

/// `s` of `z = C_k(s)`, the Stumpff function, by Newton's method: `C_k(s) - C_k(m) = C_k'(t) (s - m)` for a `t` between.
///
/// `C_k' = (k C_(k+2) - C_(k+1)) / 2`. Where the derivative may be zero the two half-lines of the quotient are used; an unbounded range
/// is left alone.
pub(super) fn stumpff(k: usize, z: Interval, s: Interval) -> Interval {
    const STEPS: usize = 4;
    let mut s = s;
    for _ in 0..STEPS {
        if !s.is_bounded() {
            break;
        }
        let slope = (s.stumpff(k + 2) * Interval::point(k as f64) - s.stumpff(k + 1)).scale(0.5);
        let mid = Interval::point(s.mid());
        let offset = factor(z - mid.stumpff(k), slope, s - mid);
        let next = s.intersection(mid + offset);
        let enough = next.is_empty() || next.width() > 0.8 * s.width();
        s = next;
        if enough {
            break;
        }
    }
    s
}
