//! A pendulum whose measurements come two steps late, and once in a while are wrong: what is late is used where it belongs, what is proven
//! wrong is dropped.
//!
//! Run with `cargo run --release -p estimators --example late_and_faulty`.

use estimators::{DelayedFilter, Estimator, EstimatorError, FaultPolicy, Rcz, RczOptions, Relation, System};
use nonlin_bounds::function;
use setrep::{ConstrainedZonotope, Zonotope};

/// Steps by which a measurement is late.
const DELAY: usize = 2;

fn main() -> Result<(), EstimatorError> {
    // Angle and rate, pushed by the wind; steps last as long as the parameter says.
    let swing = function!(|[angle, rate, wind]: 3, [dt]: 1| -> 2 {
        [angle + dt * rate, rate - dt * (angle.sin().scale(4.0) + rate.scale(0.5)) + dt * wind]
    });
    let seen = function!(|[angle, _rate, error]: 3| -> 1 { [angle + error] });
    let wind = Zonotope::from_box(&[0.0], &[0.01])?;
    let error = Zonotope::from_box(&[0.0], &[0.02])?;
    let system = System::new(Relation::new(swing), wind, Relation::new(seen), error)?;
    let start = ConstrainedZonotope::from_box(&[0.5, 0.0], &[0.3, 0.3])?;

    let mut in_time = Rcz::new(system.clone(), start.clone(), RczOptions::fast(2))?;
    let mut late = DelayedFilter::new(Rcz::new(system, start, RczOptions::fast(2))?, DELAY);

    let (mut angle, mut rate) = (0.6_f64, 0.1_f64);
    let mut measured = Vec::new();
    println!("  k   in time: angle           late: angle              truth");
    for k in 0..40_usize {
        let dt = if k % 3 == 0 { 0.08 } else { 0.03 };
        // A wrong measurement at every tenth step.
        let y = angle + 0.015 * (7.0 * k as f64).sin() + if k % 10 == 9 { 0.5 } else { 0.0 };
        measured.push(y);

        // In time: a contradiction drops the measurement, with its proof at hand.
        if let Some(fault) = in_time.update_or_recover(&[Some(y)], &[], &FaultPolicy::KeepPrediction)? {
            println!("{k:3}   {}", fault.inconsistency);
        }
        // Late: what was measured two steps ago; a contradiction leaves everything as it was.
        if let Some(step) = k.checked_sub(DELAY) {
            match late.update_at(step as u64, &[Some(measured[step])], &[]) {
                Ok(()) => {}
                Err(EstimatorError::Inconsistent(proof)) => println!("{k:3}   late, {proof}"),
                Err(error) => return Err(error),
            }
        }
        if k % 5 == 0 {
            let (a, b) = (in_time.hull()[0], late.filter().hull()[0]);
            println!("{k:3}   [{:.4}, {:.4}]   [{:.4}, {:.4}]   {angle:.4}", a.lo(), a.hi(), b.lo(), b.hi());
            assert!(a.contains(angle) && b.contains(angle));
        }
        in_time.predict(&[dt])?;
        late.predict(&[dt])?;
        (angle, rate) = (angle + dt * rate, rate - dt * (4.0 * angle.sin() + 0.5 * rate));
    }
    Ok(())
}
