//! Where is a robot that hears three beacons? Distances known to 2 cm shrink a hall to a spot.
//!
//! `cargo run --release --example contraction -p nonlin-bounds`

use nonlin_bounds::{Contraction, ForwardBackward, Function, IntervalNewton, Tape, Workspace};
use scalars::{Interval, Scalar};

/// Distances of `(x, y)` from beacons at `(0, 0)`, `(10, 0)` and `(0, 8)` metres.
struct Distances;

impl Function for Distances {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        3
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        for (distance, (east, north)) in y.iter_mut().zip([(0.0, 0.0), (10.0, 0.0), (0.0, 8.0)]) {
            *distance = (x[0].add_f64(-east).sqr() + x[1].add_f64(-north).sqr()).sqrt();
        }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let tape = Tape::record(&Distances);
    print!("{tape}");
    let mut workspace = Workspace::new();
    let measured = ["5.01", "8.05", "4.99"].map(|text| Interval::decimal(text).inflate(0.02));

    let mut hall = [Interval::new(0.0, 10.0)?, Interval::new(0.0, 8.0)?];
    println!("\nthe hall               {:.3} x {:.3}", hall[0], hall[1]);
    let outcome = ForwardBackward::default().contract(&tape, &mut hall, &[], &measured, &mut workspace)?;
    println!("forward and backward   {:.3} x {:.3}, {outcome:?}", hall[0], hall[1]);
    let outcome = IntervalNewton::default().contract(&Distances, &mut hall, &[], &measured, &mut workspace)?;
    println!("interval Newton        {:.3} x {:.3}, {outcome:?}", hall[0], hall[1]);

    // The third beacon is heard over a reflection: no place fits, and that is proven.
    let mut hall = [Interval::new(0.0, 10.0)?, Interval::new(0.0, 8.0)?];
    let reflected = [measured[0], measured[1], Interval::decimal("10.5").inflate(0.02)];
    let outcome = ForwardBackward::default().contract(&tape, &mut hall, &[], &reflected, &mut workspace)?;
    if let Contraction::ProvenEmpty(conflict) = outcome {
        println!("with a reflection      no place: {conflict:?}");
    }
    Ok(())
}
