//! The README's example: bounds of a pendulum's angle and rate from its height, and a measurement that can not be.
//!
//! `cargo run --release -p estimators --example bound`

use estimators::{Estimator, EstimatorError, Rcz, RczOptions, Relation, System};
use nonlin_bounds::{Function, function};
use setrep::{ConstrainedZonotope, Zonotope};

fn main() -> Result<(), EstimatorError> {
    // Angle [rad], rate [rad/s] and a disturbance w; what is seen is the height of the bob [m], with an error e.
    let swing = function!(|[angle, rate, w]: 3| -> 2 {
        let step = S::decimal("0.05");
        [angle + step * rate, rate - step * (angle.sin().scale(4.0) + rate.scale(0.5) - w)]
    });
    let height = function!(|[angle, _, e]: 3| -> 1 { [S::one() - angle.cos() + e] });
    let small = Zonotope::from_box(&[0.0], &[0.01])?;
    let system = System::new(Relation::new(swing), small.clone(), Relation::new(height), small)?;
    let start = ConstrainedZonotope::from_box(&[0.5, 0.0], &[0.4, 0.4])?;
    let mut filter = Rcz::new(system, start, RczOptions::fast(2))?;

    let (mut truth, mut next, mut seen) = ([0.7, -0.2], [0.0; 2], [0.0]);
    for _ in 0..40 {
        height.eval(&[truth[0], truth[1], 0.004], &[], &mut seen);
        filter.update(&seen)?;
        filter.predict(&[])?;
        swing.eval(&[truth[0], truth[1], 0.008], &[], &mut next);
        truth = next;
    }
    println!("angle {:.4} in {:.4}", truth[0], filter.hull()[0]);
    println!("rate  {:.4} in {:.4}", truth[1], filter.hull()[1]);
    if let Err(contradiction) = filter.update(&[0.9]) {
        println!("a height of 0.9 m: {contradiction}");
    }
    Ok(())
}
