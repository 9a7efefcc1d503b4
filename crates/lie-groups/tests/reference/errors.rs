//! Every `Err` of the crate, provoked.

use lie_groups::{GroupError, LieGroup, Rn, SE2, SO2};
use nalgebra::{DMatrix, Vector1, Vector2, Vector3};
use scalars::Interval;

const PI: f64 = std::f64::consts::PI;

fn interval(lo: f64, hi: f64) -> Interval {
    Interval::new(lo, hi).unwrap()
}

/// A heading box with the position at the origin.
fn heading(lo: f64, hi: f64) -> SE2<Interval> {
    SE2::from_pose(interval(lo, hi), Interval::ZERO, Interval::ZERO)
}

#[test]
fn half_turn_has_no_single_log_over_intervals() {
    for (lo, hi) in [(3.0, 3.3), (PI, PI.next_up()), (-4.0, -3.0), (-10.0, 10.0), (PI, PI)] {
        let reaches = matches!(heading(lo, hi).log(), Err(GroupError::HalfTurn { .. }));
        // The single number PI lies below pi, but its cosine rounds to -1 and its sine is proven positive: a log exists.
        assert_eq!(reaches, lo != hi, "[{lo}, {hi}]");
    }
    assert!(heading(3.0, PI - 1e-4).log().is_ok());
    assert!(heading(1e-4 - PI, PI - 1e-4).log().is_ok());
}

#[test]
fn half_turn_over_f64_takes_the_sign_of_the_sine() {
    for sign in [1.0, -1.0] {
        let turn = SO2::from_cos_sin(-1.0, 0.0 * sign).unwrap();
        assert_eq!(turn.angle(), Ok(PI * sign));
    }
}

#[test]
fn full_turn_is_a_pole_of_the_inverse_jacobian() {
    let tau = std::f64::consts::TAU;
    for theta in [tau.next_up(), -7.0, 1e300] {
        let error = SE2::jl_inv(&Vector3::new(theta, 1.0, 0.0));
        assert_eq!(error, Err(GroupError::FullTurn { theta_lo_rad: theta, theta_hi_rad: theta }));
        assert!(SE2::jr_inv(&Vector3::new(theta, 1.0, 0.0)).is_err());
    }
    assert!(SE2::jl_inv(&Vector3::new(tau, 1.0, 0.0)).unwrap().iter().all(|x| x.is_finite()));
    let boxed = Vector3::new(interval(0.0, 6.3), Interval::ONE, Interval::ZERO);
    assert_eq!(SE2::jl_inv(&boxed), Err(GroupError::FullTurn { theta_lo_rad: 0.0, theta_hi_rad: 6.3 }));
    assert!(SE2::jl_inv(&Vector3::new(interval(-tau, tau), Interval::ONE, Interval::ZERO)).is_ok());
}

#[test]
fn not_finite_is_named_by_its_index() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(SO2::from_cos_sin(bad, 0.0), Err(GroupError::NotFinite { index: 0 }));
        assert_eq!(SO2::from_cos_sin(0.0, bad), Err(GroupError::NotFinite { index: 1 }));
        assert_eq!(SO2::from_angle(bad).angle(), Err(GroupError::NotFinite { index: 0 }));
        assert_eq!(SO2::jl_inv(&Vector1::new(bad)), Err(GroupError::NotFinite { index: 0 }));
        assert_eq!(SE2::from_pose(bad, 0.0, 0.0).log(), Err(GroupError::NotFinite { index: 0 }));
        assert_eq!(SE2::from_pose(0.0, bad, 0.0).log(), Err(GroupError::NotFinite { index: 2 }));
        assert_eq!(SE2::from_pose(0.0, 0.0, bad).log(), Err(GroupError::NotFinite { index: 3 }));
        assert_eq!(SE2::jl_inv(&Vector3::new(bad, 0.0, 0.0)), Err(GroupError::NotFinite { index: 0 }));
        assert_eq!(Rn::new(Vector2::new(0.0, bad)).log(), Err(GroupError::NotFinite { index: 1 }));
        assert_eq!(Rn::<f64, 2>::jl_inv(&Vector2::new(0.0, bad)), Err(GroupError::NotFinite { index: 1 }));
    }
    for bad in [Interval::EMPTY, Interval::ENTIRE] {
        assert_eq!(SO2::from_cos_sin(bad, Interval::ZERO), Err(GroupError::NotFinite { index: 0 }));
        assert_eq!(SE2::jl_inv(&Vector3::new(bad, bad, bad)), Err(GroupError::NotFinite { index: 0 }));
        assert!(SE2::from_pose(bad, Interval::ZERO, Interval::ZERO).log().is_err());
        assert_eq!(SE2::from_pose(Interval::ZERO, bad, Interval::ZERO).log(), Err(GroupError::NotFinite { index: 2 }));
        assert_eq!(Rn::new(Vector2::new(Interval::ZERO, bad)).log(), Err(GroupError::NotFinite { index: 1 }));
    }
}

/// Where no `Result` is returned, NaN stays NaN and unbounded boxes give enclosures.
#[test]
fn nothing_panics_without_a_result() {
    let xi = Vector3::new(f64::NAN, 1.0, 0.0);
    assert!(SE2::exp(&xi).translation()[0].is_nan());
    assert!(SE2::jl(&xi)[(1, 1)].is_nan());
    assert!(SE2::exp(&Vector3::new(f64::INFINITY, 1.0, 0.0)).rotation().unit().re.is_nan());
    let boxed = Vector3::new(Interval::ENTIRE, Interval::ONE, Interval::ZERO);
    let pose = SE2::exp(&boxed);
    assert!(interval(-1.0, 1.0).subset_of(&pose.rotation().unit().re));
    // sin t / t has the range [-0.2172.., 1].
    assert!(interval(-0.217, 1.0).subset_of(&pose.translation()[0]) && pose.translation()[0].mag() < 1.01);
    assert!(SE2::exp(&boxed.map(|_| Interval::EMPTY)).translation()[0].is_empty());
}

#[test]
fn not_a_rotation() {
    assert_eq!(SO2::from_cos_sin(0.0, -0.0), Err(GroupError::NotARotation));
    let inside = interval(-0.5, 0.5);
    assert_eq!(SO2::from_cos_sin(inside, inside), Err(GroupError::NotARotation));
    assert_eq!(SO2::from_cos_sin(Interval::ONE, interval(0.1, 0.2)), Err(GroupError::NotARotation));
}

#[test]
fn vee_checks_shape_and_pattern() {
    let wide = DMatrix::<f64>::zeros(3, 4);
    let shape = GroupError::Shape { expected: 3, found_rows: 3, found_cols: 4 };
    assert_eq!(<SE2<f64> as LieGroup<f64, 3, 2>>::vee(&wide), Err(shape));
    let mut matrix = SE2::hat(&Vector3::new(1.0, 2.0, 3.0));
    matrix[(2, 0)] = 1e-300;
    let pattern = GroupError::NotInAlgebra { row: 2, col: 0 };
    assert_eq!(<SE2<f64> as LieGroup<f64, 3, 2>>::vee(&matrix), Err(pattern));
    let nan = DMatrix::from_element(2, 2, f64::NAN);
    assert!(<SO2<f64> as LieGroup<f64, 1, 2>>::vee(&nan).is_err());
}
