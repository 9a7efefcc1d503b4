//! A flight with unknown attitude, found by two antennas and the vertical: `cargo run --release -p estimators --example attitude`.

use estimators::{Estimator, SpatialBox, SpatialIncrement, SpatialMeasurement, SpatialStrips, StripsOptions};
use lie_groups::{LieGroup, SO3};
use nalgebra::Vector3;
use scalars::Interval;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let within = |radius: f64| [Interval::ZERO.inflate(radius); 3];
    // Nothing is known of the attitude, the position to 5 m.
    let prior = SpatialBox::new(SO3::identity(), [Interval::ENTIRE; 3], &[within(5.0)]);
    let mut filter = SpatialStrips::new(&prior, StripsOptions::pose())?;

    let mut attitude = SO3::exp(&Vector3::new(0.4, -0.3, 2.0));
    let mut position = Vector3::new(1.0, 2.0, 0.0);
    let (turn, shift) = ([0.01, 0.02, 0.05], [0.5, 0.0, 0.0]);
    let step = SpatialIncrement::odometry(turn, shift.map(Interval::point), within(1e-3), within(5e-3));
    println!("{:>4} {:>6} {:>28}   position, m", "step", "cells", "attitude, rad");
    for k in 0..20 {
        // Errors of the antennas and of the accelerometer that keep their bounds, 0.1 m and 0.5 m/s^2.
        let error = |i: f64| Vector3::from_fn(|row, _| 0.09 * (f64::from(k) * 1.7 + i + 2.3 * row as f64).sin());
        let antennas = [[1.0, 0.0, 0.2], [-0.5, 0.8, 0.0]].map(|arm| {
            let place = position + attitude.act(&Vector3::from(arm)) + error(arm[0]);
            SpatialMeasurement::vector(place.into(), within(0.1)).with_arm(arm)
        });
        let gravity = [0.0, 0.0, -9.81];
        let seen = attitude.inverse().act(&Vector3::from(gravity)) + 5.0 * error(0.3);
        let vertical = SpatialMeasurement::direction(gravity.map(Interval::point), seen.into(), within(0.5));
        filter.update(&[antennas[0], antennas[1], vertical])?;

        let set = filter.enclosure();
        let [a, b, c] = set.turn_rad.map(|side| side.rad());
        let [x, y, z] = set.vectors[0].map(|side| side.rad());
        if k < 4 || k % 4 == 3 {
            println!("{k:>4} {:>6} {a:>9.3} {b:>9.3} {c:>8.3}   {x:.3} {y:.3} {z:.3}", filter.cells());
        }
        filter.predict(&step)?;
        position += attitude.act(&Vector3::from(shift));
        attitude = attitude.compose(&SO3::exp(&Vector3::from(turn)));
    }
    Ok(())
}
