//! A guaranteed filter on a pendulum whose height is seen: bounds of angle and rate over time, then a sensor that lies.
//!
//! `cargo run --release -p estimators --example pendulum`

use estimators::{Estimator, EstimatorError, Rcz, RczOptions, Relation, System};
use nonlin_bounds::{Function, function};
use setrep::{ConstrainedZonotope, Zonotope};

fn main() -> Result<(), EstimatorError> {
    // Angle (rad) and rate (rad/s) over 50 ms, with a disturbance of the acceleration as third variable.
    let swing = function!(|x: 3| -> 2 {
        let dt = S::decimal("0.05");
        [x[0] + dt * x[1], x[1] - dt * (x[0].sin().scale(4.0) + x[1].scale(0.5)) + dt * x[2]]
    });
    // The height of the bob (m), with an error as third variable.
    let height = function!(|x: 3| -> 1 { [S::one() - x[0].cos() + x[2]] });

    let (wind, error) = (Zonotope::from_box(&[0.0], &[0.01])?, Zonotope::from_box(&[0.0], &[0.01])?);
    let system = System::new(Relation::new(swing), wind, Relation::new(height), error)?;
    let start = ConstrainedZonotope::from_box(&[0.5, 0.0], &[0.4, 0.4])?;
    let mut filter = Rcz::new(system, start, RczOptions::fast(2))?;

    let mut truth = [0.7, -0.2];
    println!("  time     angle        bounds            rate         bounds");
    for k in 0..=60_u32 {
        let mut seen = [0.0];
        height.eval(&[truth[0], truth[1], 0.006 * f64::from(k % 3) - 0.006], &[], &mut seen);
        filter.update(&seen)?;
        if k.is_multiple_of(10) {
            let [angle, rate] = [filter.hull()[0], filter.hull()[1]];
            println!(
                "{:4.1} s {:8.3} [{:6.3}, {:6.3}] {:11.3} [{:6.3}, {:6.3}]",
                0.05 * f64::from(k),
                truth[0],
                angle.lo(),
                angle.hi(),
                truth[1],
                rate.lo(),
                rate.hi()
            );
        }
        filter.predict(&[])?;
        let mut next = [0.0; 2];
        swing.eval(&[truth[0], truth[1], 0.008], &[], &mut next);
        truth = next;
    }
    match filter.update(&[0.9]) {
        Err(EstimatorError::Inconsistent(proof)) => {
            println!("a height of 0.9 m: {proof}; the set of the prediction is kept");
        }
        other => println!("a height of 0.9 m is possible: {other:?}"),
    }
    Ok(())
}
