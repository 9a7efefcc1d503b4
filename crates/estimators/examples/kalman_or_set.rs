//! One model, written once, in an unscented Kalman filter and in a zonotopic filter: what each of them states, and what it rests on.
//!
//! `cargo run --release -p estimators --example kalman_or_set`

use estimators::kalman::{ByFunction, Flat, Gaussian, Ukf};
use estimators::{Estimator, Relation, System, Zf, ZfOptions};
use nalgebra::{Matrix1, Matrix2, Vector2};
use nonlin_bounds::function;
use setrep::Zonotope;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // A falling ball with drag: height in m and rate of climb in m/s, steps of 0.1 s. Its height is measured.
    let ball = function!(|[height, speed, w]: 3| -> 2 {
        let fall = S::decimal("9.81") - S::decimal("0.02") * speed.sqr() + w;
        [height + speed * S::decimal("0.1"), speed - fall * S::decimal("0.1")]
    });
    let sonar = function!(|[height, _speed, v]: 3| -> 1 { [height + v] });

    // The set: noises and the first state have bounds.
    let (wind, echo) = (Zonotope::from_box(&[0.0], &[0.3])?, Zonotope::from_box(&[0.0], &[0.15])?);
    let system = System::new(Relation::new(ball), wind, Relation::new(sonar), echo)?;
    let mut set = Zf::new(system, Zonotope::from_box(&[50.0, -3.0], &[3.0, 3.0])?, ZfOptions::new(12))?;

    // The belief: they have variances; here the bounds are three standard deviations.
    let start = Gaussian::new(Vector2::new(50.0, -3.0), &Matrix2::identity())?;
    let (q, r) = (Matrix1::new(0.01), Matrix1::new(0.0025));
    let model = (ByFunction::new(ball), ByFunction::new(sonar));
    let mut belief: Ukf<_, Flat, 2, 1, 1, 1> = Ukf::new(model, start, &q, &r)?;

    println!("  t s  true speed   UKF +- 3 sigma      ZF center +- hull");
    let (mut height, mut speed) = (51.0, -2.0);
    for k in 0..30 {
        let (wind, echo) = (0.29 * f64::from(k).sin(), 0.14 * (1.7 * f64::from(k)).cos());
        belief.update(&[height + echo])?;
        set.update(&[height + echo])?;
        if k % 5 == 0 {
            let (mean, sigma) = (belief.belief().mean()[1], belief.belief().standard_deviations()[1]);
            let side = set.hull()[1];
            let t = 0.1 * f64::from(k);
            println!("{t:5.1} {speed:11.3} {mean:11.3} {:6.3} {:14.3} {:6.3}", 3.0 * sigma, side.mid(), side.rad());
            assert!(side.contains(speed));
        }
        (height, speed) = (height + 0.1 * speed, speed - 0.1 * (9.81 - 0.02 * speed * speed + wind));
        belief.predict(&[])?;
        set.predict(&[])?;
    }
    // What no ball of this kind can have done is refuted by the set with proof, and averaged away by the belief.
    println!("a jump of 2 m: {}", set.update(&[height + 2.0]).err().map_or("accepted".to_owned(), |e| e.to_string()));
    belief.update(&[height + 2.0])?;
    println!(
        "the belief takes it, its NIS is {:.0}",
        belief.innovation().map_or(0.0, estimators::kalman::Innovation::nis)
    );
    Ok(())
}
