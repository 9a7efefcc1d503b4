//! A robot between two landmarks, followed by polytopes: `cargo run --release -p estimators --example robot`.

use estimators::{Estimator, EstimatorError, Relation, System, Vh, VhOptions};
use nonlin_bounds::function;
use setrep::{IntervalVector, VPolytope, Zonotope};

fn main() -> Result<(), EstimatorError> {
    // Variables (x, y, heading, three disturbances): 0.3 m and 0.15 rad a step.
    let drive = function!(|[x, y, heading, a, b, c]: 6| -> 3 {
        let (sin, cos) = heading.sin_cos();
        [x + S::decimal("0.3") * cos + a, y + S::decimal("0.3") * sin + b, heading + S::decimal("0.15") + c]
    });
    // Variables (x, y, heading, two errors): distance and bearing of a landmark at (5, 15).
    let see = function!(|[x, y, heading, e, f]: 5| -> 2 {
        let (east, north) = (-x.add_f64(-5.0), -y.add_f64(-15.0));
        [(east.sqr() + north.sqr()).sqrt() + e, heading - (north / east).atan() + f]
    });
    let disturbance = Zonotope::from_box(&[0.0; 3], &[0.05, 0.03, 0.06])?;
    let error = Zonotope::from_box(&[0.0; 2], &[0.01, 0.02])?;
    let system = System::new(Relation::new(drive), disturbance, Relation::new(see), error)?;
    let start = VPolytope::from_intervals(&IntervalVector::from_center(&[0.1, 0.2, 1.0], &[0.05, 0.1, 0.2])?)?;
    let mut filter = Vh::new(system, start, VhOptions::tight())?;

    let (mut x, mut y, mut heading) = (0.1_f64, 0.2_f64, 1.0_f64);
    println!("{:>4} {:>9} {:>12}   heading", "step", "vertices", "volume");
    for step in 0..8 {
        let (east, north) = (5.0 - x, 15.0 - y);
        filter.update(&[east.hypot(north), heading - (north / east).atan()])?;
        let (count, volume) = (filter.enclosure().num_vertices(), filter.enclosure().volume()?.mid());
        println!("{step:>4} {count:>9} {volume:>12.3e}   {}", filter.hull()[2]);
        filter.predict(&[])?;
        (x, y, heading) = (x + 0.3 * heading.cos(), y + 0.3 * heading.sin(), heading + 0.15);
    }
    Ok(())
}
