//! A vehicle on a circle, its heading off by 60 degrees at first: the invariant filter with its order reductions.
//!
//! `cargo run --release -p estimators --example vehicle`

use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};

use estimators::{Estimator, EstimatorError, InZsmf, Left, Outputs};
use lie_groups::{LieGroup, SE2};
use nalgebra::{Vector2, Vector3};
use scalars::Interval;
use setrep::{Membership, Reduction, Zonotope};

/// Uniform noise in `[-1, 1)` from a fixed linear congruence.
struct Noise(u64);

impl Noise {
    fn draw(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

fn main() -> Result<(), EstimatorError> {
    let around_zero = |radii: &[f64]| Zonotope::from_box(&vec![0.0; radii.len()], radii);
    // Every 0.01 s: a turn of 0.004 rad, 0.08 m ahead; both off by up to 0.001; the position is measured to 1 m.
    let increment = Vector3::new(0.004, 0.08, 0.0);
    let (first, odometry, receiver) =
        (around_zero(&[1.2, 1.0, 1.0])?, around_zero(&[0.001; 3])?, around_zero(&[1.0; 2])?);

    println!(
        "{:<22}{:>8}{:>16}{:>16}{:>18}{:>10}",
        "reduction", "time s", "error rad", "error m", "heading +- rad", "inside"
    );
    let variants = [("none", None), ("Combastel to 30", Some((Reduction::Combastel, 30)))];
    let more = [("Girard to 30", Some((Reduction::Girard, 30))), ("Girard to 150", Some((Reduction::Girard, 150)))];
    for (name, reduction) in variants.into_iter().chain(more) {
        let mut filter: InZsmf<SE2<f64>, 3, 2, Left> =
            InZsmf::new(SE2::from_pose(FRAC_PI_6, 0.0, 0.0), &first, Outputs::position(), &odometry, &receiver)?;
        if let Some((method, order)) = reduction {
            filter = filter.with_reduction(method, order)?;
        }
        let (mut noise, mut truth) = (Noise(1), SE2::from_pose(FRAC_PI_2, 0.0, 0.0));
        for k in 1..=400 {
            let y = truth.translation() + Vector2::new(noise.draw(), noise.draw());
            filter.step(&increment, y.as_slice())?;
            let odometry_error = Vector3::new(noise.draw(), noise.draw(), noise.draw()) * 0.001;
            truth = truth.compose(&SE2::exp(&increment)).compose(&SE2::exp(&odometry_error));
            if k % 200 == 0 {
                report(name, k, &filter, &truth)?;
            }
        }
    }
    Ok(())
}

fn report(name: &str, k: u32, filter: &InZsmf<SE2<f64>, 3, 2, Left>, truth: &SE2<f64>) -> Result<(), EstimatorError> {
    let Ok(error) = filter.estimate().inverse().compose(truth).log() else { return Ok(()) };
    let heading = filter.tangent_set().interval_hull()[0];
    let point: Vec<Interval> = error.iter().map(|e| Interval::point(*e)).collect();
    let inside = match filter.tangent_set().membership(&point)? {
        Membership::ProvenInside => "yes",
        Membership::ProvenOutside => "no",
        Membership::Undecided => "open",
    };
    let position = (truth.translation() - filter.estimate().translation()).norm();
    let time = f64::from(k) * 0.01;
    println!("{name:<22}{time:>8.1}{:>16.4}{position:>16.4}{:>18.3}{inside:>10}", error[0].abs(), heading.rad());
    Ok(())
}
