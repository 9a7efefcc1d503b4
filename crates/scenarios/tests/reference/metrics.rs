//! Metrics by hand.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use scenarios::metrics::{RunSums, wrap_angle};

#[test]
fn two_steps_by_hand() {
    let mut sums = RunSums::default();
    // A heading error of a full turn is none.
    sums.add_step(TAU, [3.0, 4.0], [0.5, 2.0, 3.0]);
    sums.add_step(-FRAC_PI_2, [0.0, 0.0], [1.5, 1.0, 4.0]);
    let metrics = sums.metrics();
    assert!((metrics.rmse_heading - FRAC_PI_2 / 2.0_f64.sqrt()).abs() < 1e-15);
    assert!((metrics.rmse_position - 12.5_f64.sqrt()).abs() < 1e-15);
    assert_eq!((metrics.aar_heading, metrics.aar_position), (1.0, 5.0));
    assert_eq!(metrics.values(), [metrics.rmse_heading, metrics.rmse_position, 1.0, 5.0]);
}

#[test]
fn angles_are_wrapped_into_half_open_turns() {
    for (angle, wrapped) in
        [(0.0, 0.0), (3.0, 3.0), (-3.0, -3.0), (PI, PI), (-PI, PI), (3.0 * PI, PI), (-7.0, TAU - 7.0)]
    {
        assert!((wrap_angle(angle) - wrapped).abs() < 1e-14, "{angle}: {}", wrap_angle(angle));
    }
}
