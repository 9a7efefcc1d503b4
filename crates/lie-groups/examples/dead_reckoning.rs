//! Dead reckoning with bounded odometry errors: every pose the vehicle can have is inside the printed bounds.
//!
//! A vehicle drives a quarter of a circle in 9 steps. Each step is known up to 1 mm and 0.1 degrees. The same code runs once
//! over `f64`, with errors drawn at the corners of their bounds, and once over `Interval`, for all errors at once.
//!
//! Run: `cargo run --release -p lie-groups --example dead_reckoning`

use lie_groups::{GroupError, LieGroup, SE2};
use nalgebra::Vector3;
use scalars::Interval;

/// Product of the exponentials of the steps: the pose after them, in the frame of the start.
fn drive<G: LieGroup<S, 3, 2>, S: lie_groups::Coeff>(steps: &[Vector3<S>]) -> G {
    steps.iter().fold(G::identity(), |pose, step| pose.compose(&G::exp(step)))
}

fn main() -> Result<(), GroupError> {
    const STEPS: usize = 9;
    let nominal = Vector3::new(10.0_f64.to_radians(), 0.2, 0.0);
    let error = Vector3::new(0.1_f64.to_radians(), 1e-3, 1e-3);

    let bounds = nominal.zip_map(&error, |value, radius| Interval::point(value).inflate(radius));
    println!("step   heading (deg)          x (m)                y (m)");
    for count in (3..=STEPS).step_by(3) {
        let pose: SE2<Interval> = drive(&vec![bounds; count]);
        let heading = pose.rotation().angle()?;
        let position = pose.translation();
        println!(
            "{count:4}   [{:8.4}, {:8.4}]   [{:7.4}, {:7.4}]   [{:7.4}, {:7.4}]",
            heading.lo().to_degrees(),
            heading.hi().to_degrees(),
            position[0].lo(),
            position[0].hi(),
            position[1].lo(),
            position[1].hi(),
        );
    }

    // Any errors within the bounds: here all combinations of signs, the same in each step.
    let all: SE2<Interval> = drive(&[bounds; STEPS]);
    let contained = (0..8).all(|corner| {
        let signs = Vector3::from_fn(|row, _| if corner >> row & 1 == 0 { -1.0 } else { 1.0 });
        let pose: SE2<f64> = drive(&[nominal + error.component_mul(&signs); STEPS]);
        pose.translation().iter().zip(all.translation().iter()).all(|(&x, range)| range.contains(x))
    });
    println!("all corner drives inside the bounds: {contained}");
    Ok(())
}
