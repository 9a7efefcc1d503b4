//! The interval hull of a set, proven: 2 n linear programs over one tableau.
//!
//! Run with `cargo run --release -p boxlp --example hull`.

use boxlp::{Emptiness, LpError, Problem, Solver};

fn main() -> Result<(), LpError> {
    // Positions x in the unit square, measured along two directions with errors of at most 0.1 and 0.05.
    let mut problem = Problem::new(2)?;
    problem.push_row(&[1.0, 0.5], 0.3 - 0.1, 0.3 + 0.1)?;
    problem.push_row(&[-0.25, 1.0], 0.6 - 0.05, 0.6 + 0.05)?;
    let mut solver = Solver::new(problem);

    for axis in 0..2 {
        let mut direction = [0.0; 2];
        direction[axis] = 1.0;
        let upper = solver.maximize(&direction)?.bound;
        direction[axis] = -1.0;
        let lower = -solver.maximize(&direction)?.bound;
        println!("x_{axis} lies in [{lower}, {upper}]");
    }

    if let Emptiness::NonEmpty(witness) = solver.emptiness() {
        println!(
            "for instance x = {:?}, within {:e}",
            witness.point(),
            witness.radius()
        );
    }

    // A third measurement contradicts the others: the certificate names the rows and how far they are off.
    solver.push_row(&[1.0, 1.0], 1.2, f64::INFINITY)?;
    let problem = solver.problem().clone();
    if let Emptiness::Empty(certificate) = solver.emptiness() {
        let rows: Vec<usize> = certificate
            .multipliers()
            .iter()
            .map(|&(row, _)| row)
            .collect();
        let miss = certificate.miss(&problem);
        println!("rows {rows:?} contradict each other, by {miss:.3} of their 1-norms");
    }
    Ok(())
}
