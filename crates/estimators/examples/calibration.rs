//! Heading, wheel scale and antenna arm of a robot from nothing: wheels and gyro once a second, a receiver good to 5 cm.
//!
//! The errors of wheels and gyro do not add up: over ten seconds they are hardly larger than over one. Telling the filter so makes
//! all the difference.

use estimators::{Estimator, InvariantStrips, PlanarBox, PlanarIncrement, PlanarMeasurement, StripsOptions};
use scalars::Interval;

const SCALE: f64 = 0.96;
const ARM: [f64; 2] = [0.5, 0.3];
/// Seconds of a longer motion.
const SPAN: usize = 10;

fn within(radius: f64) -> Interval {
    Interval::point(-radius).hull(Interval::point(radius))
}

/// `a` turned by an angle.
fn turned(angle: f64, a: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos * a[0] - sin * a[1], sin * a[0] + cos * a[1]]
}

/// Turn and way between two seconds as the wheels see it.
fn odometry(k: usize) -> (f64, [f64; 2]) {
    let t = k as f64;
    (0.25 * (0.15 * t).cos(), [0.5, 0.0])
}

/// The same over several seconds.
fn reckoned(from: usize, to: usize) -> (f64, [f64; 2]) {
    (from..to).fold((0.0, [0.0; 2]), |(heading, at), k| {
        let (turn, way) = odometry(k);
        let [x, y] = turned(heading, way);
        (heading + turn, [at[0] + x, at[1] + y])
    })
}

/// Runs the robot; prints what is known, with or without bounds on the longer motions.
fn run(spans: usize) -> Result<(), Box<dyn std::error::Error>> {
    let prior =
        PlanarBox::scale_and_lever_arm(Interval::ENTIRE, Interval::new(0.8, 1.25)?, [within(5.0); 2], [within(2.0); 2]);
    let mut filter = InvariantStrips::new(&prior, StripsOptions { spans, ..StripsOptions::calibration() })?;
    let (mut heading, mut position) = (2.0, [0.0; 2]);
    for k in 0..100 {
        let (t, (turn, [forward, left])) = (k as f64, odometry(k));
        // Errors that come and go: within 0.008 rad and 0.02 m a second, and within 0.02 rad and 0.05 m over ten.
        let slip = |phase: f64| (1.3 * (t + 1.0) + phase).sin() - (1.3 * t + phase).sin();
        let [x, y] = turned(heading, [forward + 0.015 * slip(0.0), left + 0.015 * slip(2.0)].map(|u| SCALE * u));
        position = [position[0] + x, position[1] + y];
        heading += turn + 0.006 * slip(4.0);

        let known = |(turn, way): (f64, [f64; 2])| (Interval::point(turn), way.map(Interval::point));
        let (measured, way) = known(odometry(k));
        filter.predict(&PlanarIncrement::odometry(measured, way, within(0.008), [within(0.02); 2]))?;
        if spans > 0 && k + 1 >= SPAN {
            let (turn, way) = known(reckoned(k + 1 - SPAN, k + 1));
            filter.bound_span(SPAN, &PlanarIncrement::chord(turn, way, within(0.02), [within(0.05); 2]))?;
        }
        let [x, y] = turned(heading, ARM);
        let fix = [position[0] + x + 0.045 * (2.1 * t).sin(), position[1] + y + 0.045 * (1.7 * t).cos()];
        filter.update(&[PlanarMeasurement::position(fix, [within(0.05); 2]).with_unknown_arm(0)])?;
        if [9, 29, 99].contains(&k) {
            let set = filter.enclosure();
            println!(
                "{:4} s   heading to {:.3} rad   scale [{:.3}, {:.3}]   arm [{:.2}, {:.2}] x [{:.2}, {:.2}] m",
                k + 1,
                set.heading_width_rad(),
                set.scale.lo(),
                set.scale.hi(),
                set.body[0][0].lo(),
                set.body[0][0].hi(),
                set.body[0][1].lo(),
                set.body[0][1].hi(),
            );
        }
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("scale {SCALE}, arm {ARM:?} m; bounds of each second alone:");
    run(0)?;
    println!("and of ten seconds at a time:");
    run(SPAN)
}
