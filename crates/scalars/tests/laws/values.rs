//! Construction, bad input, equality, constants, and the floating-point environment.

use num_traits::{One, Zero};
use scalars::{Interval, Scalar, ScalarError, fp_env_ok};

const INF: f64 = f64::INFINITY;

#[test]
fn bounds_that_are_no_interval_are_typed_errors() {
    for (lo, hi) in [(2.0, 1.0), (f64::NAN, 1.0), (1.0, f64::NAN), (INF, INF), (-INF, -INF), (INF, -INF)] {
        assert!(matches!(Interval::new(lo, hi), Err(ScalarError::InvalidBounds { .. })), "[{lo}, {hi}]");
    }
    assert_eq!(Interval::new(2.0, 1.0).unwrap_err().to_string(), "[2, 1] is not a nonempty interval of real numbers");
    assert_eq!(Interval::new(-INF, INF), Ok(Interval::ENTIRE));
}

/// NaN and infinities never shrink a set: they stand for any number, or for one that overflowed.
#[test]
fn values_that_are_no_numbers_give_enclosures() {
    assert_eq!(Interval::point(f64::NAN), Interval::ENTIRE);
    assert_eq!(Interval::point(INF), Interval::new(f64::MAX, INF).unwrap());
    assert_eq!(Interval::point(-INF), Interval::new(-INF, f64::MIN).unwrap());
    assert_eq!(Interval::ONE.scale(f64::NAN), Interval::ENTIRE);
    assert_eq!(Interval::ONE.add_f64(f64::NAN), Interval::ENTIRE);
    assert_eq!(Interval::ONE.inflate(f64::NAN), Interval::ENTIRE);
    assert_eq!(Interval::ONE.inflate(-1.0), Interval::ONE);
    assert_eq!(<Interval as Scalar>::lit(1.0, f64::NAN), Interval::ENTIRE);
    assert_eq!(<Interval as Scalar>::ratio(1, 0), Interval::ENTIRE);
    assert_eq!(<Interval as Scalar>::decimal("0,1"), Interval::ENTIRE);
    assert!(<f64 as Scalar>::ratio(1, 0).is_nan() && <f64 as Scalar>::decimal("0,1").is_nan());
}

#[test]
fn equality_is_that_of_sets() {
    let zero = Interval::new(-0.0, 0.0).unwrap();
    assert!(zero == Interval::ZERO && zero.is_zero() && Interval::ONE.is_one());
    assert!(Interval::EMPTY == Interval::ONE.intersection(Interval::ZERO) && Interval::EMPTY != Interval::ZERO);
    assert_eq!(Interval::default(), Interval::ZERO);
}

/// Exact zeros are not widened, and the sign of a result is kept where the signs of the operands decide it.
#[test]
fn zeros_and_signs_are_exact() {
    let x = Interval::new(0.3, 0.7).unwrap();
    assert_eq!((x * Interval::ZERO, Interval::ZERO * Interval::ENTIRE), (Interval::ZERO, Interval::ZERO));
    assert_eq!((Interval::ZERO / x, x.scale(0.0)), (Interval::ZERO, Interval::ZERO));
    assert_eq!(Interval::ONE - Interval::ONE, Interval::ZERO);
    assert_eq!(Interval::ZERO.sqr().sqrt().sin().tan().atan().asin().sinh().tanh(), Interval::ZERO);
    assert_eq!(Interval::ONE.ln(), Interval::ZERO);
    let tiny = Interval::point(1e-300);
    assert_eq!((tiny * tiny, -tiny * tiny), (Interval::new(0.0, f64::from_bits(1)).unwrap(), -(tiny * tiny)));
    assert_eq!((tiny / Interval::point(1e300)).lo(), 0.0);
    assert_eq!(tiny.sqr().lo(), 0.0);
    assert_eq!((Interval::new(0.0, 1.0).unwrap() * x).lo(), 0.0);
}

/// Overflow leaves a finite bound on the side where the exact number is finite.
#[test]
fn overflow_keeps_a_finite_bound() {
    let huge = Interval::point(f64::MAX);
    for result in
        [huge + huge, huge * huge, huge / Interval::point(1e-300), huge.sqr(), huge.powi(3), huge.exp(), huge.cosh()]
    {
        assert!(result.hi() == INF && result.lo() > 0.9 * f64::MAX && result.lo().is_finite(), "{result:?}");
        let negative = -result;
        assert!(negative.lo() == -INF && negative.hi().is_finite());
    }
    assert!(!(huge - huge).is_empty() && (huge - huge).contains(0.0));
}

/// Division through zero, as IEEE 1788 says.
#[test]
fn division_by_intervals_with_zero() {
    let one = Interval::ONE;
    let half_line = Interval::new(0.0, INF).unwrap();
    assert_eq!(one / Interval::ZERO, Interval::EMPTY);
    assert_eq!(one / half_line, half_line);
    assert_eq!(one / -half_line, -half_line);
    assert_eq!(one / Interval::new(-1.0, 1.0).unwrap(), Interval::ENTIRE);
    let quotient = one / Interval::new(0.0, 2.0).unwrap();
    assert!(quotient.lo() <= 0.5 && quotient.lo() > 0.499 && quotient.hi() == INF);
    assert_eq!((-one) / Interval::new(0.0, 2.0).unwrap(), -quotient);
    assert_eq!(one / Interval::new(-2.0, 0.0).unwrap(), -quotient);
}

/// The part of a box outside the domain of a function adds nothing.
#[test]
fn domains_are_intersected() {
    let around = Interval::new(-4.0, 4.0).unwrap();
    assert!(around.sqrt().lo() == 0.0 && around.sqrt().hi() < 2.000001);
    assert!(around.ln().lo() == -INF && around.ln().hi() < 1.39);
    assert_eq!(around.asin(), Interval::new(-1.0, 1.0).unwrap().asin());
    assert_eq!(around.acos(), Interval::new(-1.0, 1.0).unwrap().acos());
    let negative = Interval::new(-4.0, -2.0).unwrap();
    assert!(
        [negative.sqrt(), negative.ln(), negative.asin(), negative.acos(), Interval::ZERO.ln()]
            .iter()
            .all(Interval::is_empty)
    );
}

#[test]
fn pi_lies_between_neighbours() {
    let pi = <Interval as Scalar>::pi();
    assert_eq!(pi.lo().next_up(), pi.hi());
    // sin changes its sign at pi: the two neighbours are on either side.
    assert!(Interval::point(pi.lo()).sin().lo() > 0.0 && Interval::point(pi.hi()).sin().hi() < 0.0);
    assert_eq!(Interval::FRAC_PI_2.scale(2.0).intersection(pi), pi);
}

#[test]
fn this_process_rounds_to_nearest() {
    assert!(fp_env_ok());
}

/// Boxes with the origin on an edge or at a corner: the angles of their other points.
#[test]
fn angles_of_boxes_at_the_origin() {
    let (up, left) = (Interval::new(0.0, 1.0).unwrap(), Interval::new(-1.0, 0.0).unwrap());
    let (pi, quarter) = (Interval::PI, Interval::FRAC_PI_2);
    let close = |angle: Interval, lo: f64, hi: f64| {
        angle.lo() <= lo && hi <= angle.hi() && angle.lo() > lo - 1e-15 && angle.hi() < hi + 1e-15
    };
    assert!(close(up.atan2(left), quarter.lo(), pi.lo()) && close(up.atan2(up), 0.0, quarter.lo()));
    assert!(close(left.atan2(up), -quarter.lo(), 0.0) && close(up.atan2(up.hull(left)), 0.0, pi.lo()));
    assert!(close(left.hull(up).atan2(up), -quarter.lo(), quarter.lo()));
    assert_eq!(left.atan2(left), pi.hull(-pi));
    assert_eq!((Interval::ZERO.atan2(up), Interval::ZERO.atan2(left)), (Interval::ZERO, pi));
    assert!(close(up.atan2(Interval::ZERO), quarter.lo(), quarter.lo()));
    assert!(Interval::ZERO.atan2(Interval::ZERO).is_empty());
}

/// An interval is not in the interior of one that shares a bound with it, unless that bound is infinite.
#[test]
fn interiors_leave_out_the_bounds() {
    let interval = |lo, hi| Interval::new(lo, hi).unwrap();
    assert!(interval(1.0, 2.0).interior_of(&interval(0.0, 3.0)) && interval(1.0, INF).interior_of(&interval(0.0, INF)));
    assert!(
        !interval(1.0, 2.0).interior_of(&interval(1.0, 3.0)) && !interval(1.0, 2.0).interior_of(&interval(0.0, 2.0))
    );
    assert!(Interval::ENTIRE.interior_of(&Interval::ENTIRE) && Interval::EMPTY.interior_of(&Interval::EMPTY));
}
