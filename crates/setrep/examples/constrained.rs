//! A prior set, two measurements: what they leave, its certified hull, a proof of emptiness, and a re-encoding.
//!
//! `cargo run --release -p setrep --example constrained`

use scalars::Interval;
use setrep::{Directions, Emptiness, Matrix, Reencoding, SetError, Strip, Workspace, Zonotope};

fn main() -> Result<(), SetError> {
    let mut workspace = Workspace::new();
    let generators = Matrix::from_columns(&[&[1.0, 0.5], &[0.5, -1.0], &[0.25, 0.75]])?;
    let prior = Zonotope::new(&[2.0, 1.0], &generators)?;
    println!("prior:      hull {:?}, area {:.4}", prior.interval_hull(), prior.volume()?.mid());

    // Two measurements a'x = y, each known to its noise bound.
    let strips = [
        Strip::new(&[1.0, 1.0], Interval::point(3.5).inflate(0.25))?,
        Strip::new(&[1.0, -0.5], Interval::point(2.0).inflate(0.5))?,
    ];
    let set = prior.intersection(&strips, &mut workspace)?;
    println!("posterior:  {} generators, {} constraints", set.num_generators(), set.num_constraints());
    println!(
        "            hull {:?}, area {:.4}",
        set.interval_hull(&mut workspace)?,
        set.to_h_polytope()?.volume()?.mid()
    );
    let reach = set.support(&[1.0, 2.0], &mut workspace)?;
    println!("            x_1 + 2 x_2 <= {reach} for every member, rounding included");
    if let Emptiness::ProvenNonEmpty(_) = set.emptiness(&mut workspace)? {
        println!("            proven to have a member");
    }

    // A third measurement that contradicts them: a multiplier a row proves that nothing is left, and is checked without the solver.
    let mut wrong = set.clone();
    wrong.intersect_strips(&[Strip::new(&[0.0, 1.0], Interval::point(2.5).inflate(0.25))?], &mut workspace)?;
    if let Emptiness::ProvenEmpty(proof) = wrong.emptiness(&mut workspace)? {
        println!("with x_2 in 2.5 +- 0.25: proven empty by the multipliers {:?}", proof.multipliers());
        println!("            verified: {}, missed by {:.4}", proof.verify(&wrong), proof.miss(&wrong));
    }

    // The same set in n generators and at most two constraints, along the directions that were measured.
    let mut small = set.clone();
    let mut directions = Directions::new(2);
    strips.iter().try_for_each(|strip| directions.push(strip.direction()))?;
    small.reencode(Reencoding::new(2), &mut directions, &mut workspace)?;
    println!("re-encoded: {} generators, {} constraints", small.num_generators(), small.num_constraints());
    println!(
        "            hull {:?}, area {:.4}",
        small.interval_hull(&mut workspace)?,
        small.to_h_polytope()?.volume()?.mid()
    );
    Ok(())
}
