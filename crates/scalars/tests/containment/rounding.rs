//! The scalar helpers of `rounding` against exact numbers.

use scalars::rounding::*;

use crate::support::cases;
use crate::support::dyadic::{Dyadic, at_most};
use crate::support::random::Random;

#[test]
fn directed_operations_bound_exact_results() {
    let mut random = Random::new("directed rounding", 7);
    let one = Dyadic::from_float(1.0);
    for _ in 0..cases(100_000) {
        let (a, b) = (random.float(), random.float());
        let (x, y) = (Dyadic::from_float(a), Dyadic::from_float(b));
        let holds =
            |lo: f64, hi: f64, num: &Dyadic, den: &Dyadic| at_most(lo, num, den) && at_most(-hi, &num.neg(), den);
        assert!(holds(down(a), up(a), &x, &one) && down(a) < a && a < up(a), "step {a:e}");
        assert!(holds(add_down(a, b), add_up(a, b), &x.add(&y), &one), "{a:e} + {b:e}");
        assert!(holds(sub_down(a, b), sub_up(a, b), &x.add(&y.neg()), &one), "{a:e} - {b:e}");
        assert!(holds(mul_down(a, b), mul_up(a, b), &x.mul(&y), &one), "{a:e} * {b:e}");
        if b != 0.0 {
            assert!(holds(div_down(a, b), div_up(a, b), &x, &y), "{a:e} / {b:e}");
        }
        if a >= 0.0 {
            let (lo, hi) = (Dyadic::from_float(sqrt_down(a)), Dyadic::from_float(sqrt_up(a)));
            assert!(
                sqrt_down(a) >= 0.0 && lo.pow(2).compare(&x).is_le() && hi.pow(2).compare(&x).is_ge(),
                "sqrt {a:e}"
            );
        }
    }
}

/// One step is one float, or two; zero steps to the least floats; exact zeros do not step.
#[test]
fn steps_are_short() {
    let mut random = Random::new("steps", 8);
    for _ in 0..cases(100_000) {
        let a = random.float();
        assert!(up(a) <= a.next_up().next_up() && down(a) >= a.next_down().next_down(), "{a:e}");
    }
    assert_eq!((down(0.0), up(0.0)), (-ETA, ETA));
    assert_eq!((add_down(1.5, -1.5), add_up(1.5, -1.5)), (0.0, 0.0));
    assert_eq!((mul_down(0.0, 3.0), mul_up(3.0, 0.0)), (0.0, 0.0));
    assert_eq!((div_down(0.0, 3.0), div_up(0.0, -3.0)), (0.0, 0.0));
    assert_eq!((sqrt_down(0.0), sqrt_up(0.0)), (0.0, 0.0));
}

#[test]
fn overflow_and_nan_give_true_bounds() {
    let inf = f64::INFINITY;
    assert_eq!((down(inf) <= f64::MAX, up(inf)), (true, inf));
    assert_eq!((down(-inf), up(-inf) >= f64::MIN), (-inf, true));
    for bounds in [
        (down(f64::NAN), up(f64::NAN)),
        (add_down(inf, -inf), add_up(inf, -inf)),
        (mul_down(0.0, inf), mul_up(0.0, inf)),
        (div_down(1.0, 0.0), div_up(1.0, 0.0)),
        (div_down(-1.0, 0.0), div_up(-1.0, 0.0)),
        (sqrt_down(-1.0), sqrt_up(-1.0)),
    ] {
        assert_eq!(bounds, (-inf, inf));
    }
    let huge = add_down(f64::MAX, f64::MAX);
    assert!(huge.is_finite() && huge > 0.99 * f64::MAX);
}

#[test]
fn sums_and_error_constants() {
    let terms = [0.1; 1000];
    let exact = terms.iter().fold(Dyadic::from_float(0.0), |s, &t| s.add(&Dyadic::from_float(t)));
    let bound = sum_up(terms);
    assert!(Dyadic::from_float(bound).compare(&exact).is_ge() && bound < 100.0 + 1e-10);
    // gamma_k (1 - k u) >= k u, exactly.
    for k in [1, 2, 10, 1 << 20, 1 << 40] {
        let u = Dyadic::from_float(UNIT_ROUNDOFF);
        let ku = Dyadic::from_float(k as f64).mul(&u);
        let gamma = Dyadic::from_float(gamma_up(k));
        assert!(gamma.mul(&Dyadic::from_float(1.0).add(&ku.neg())).compare(&ku).is_ge(), "gamma {k}");
    }
    assert_eq!((gamma_up(0), gamma_up(1 << 53)), (0.0, f64::INFINITY));
}
