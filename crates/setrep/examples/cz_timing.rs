//! Time of a constrained zonotope's hull, support and reduction: `cargo run --release -p setrep --example cz_timing`.

use std::time::Instant;

use setrep::{Complexity, ConstrainedZonotope, Directions, Matrix, Reduction, Reencoding, SetError, Workspace};

/// Entries in `[-1, 1]`, the same in every run.
fn entries(count: usize, seed: &mut u64) -> Vec<f64> {
    let mut next = || {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    (0..count).map(|_| next()).collect()
}

/// Least time of one run in microseconds.
fn least_us(runs: usize, mut run: impl FnMut() -> Result<(), SetError>) -> Result<f64, SetError> {
    let mut least = f64::INFINITY;
    for _ in 0..runs {
        let start = Instant::now();
        run()?;
        least = least.min(start.elapsed().as_secs_f64());
    }
    Ok(1e6 * least)
}

fn main() -> Result<(), SetError> {
    println!("    n   ng   nc    hull us  support us   reduce us  reencode us");
    for (n, ng, nc) in [(2, 8, 3), (4, 12, 5), (10, 40, 10), (20, 200, 40)] {
        let mut seed = 7;
        let g = Matrix::from_column_slice(n, ng, &entries(n * ng, &mut seed))?;
        let a = Matrix::from_column_slice(nc, ng, &entries(nc * ng, &mut seed))?;
        let b: Vec<f64> = entries(nc, &mut seed).iter().map(|b| 0.5 * b).collect();
        let set = ConstrainedZonotope::from_cg_rep(&vec![0.0; n], &g, &a, &b)?;
        let (mut workspace, mut hull) = (Workspace::new(), set.unconstrained().interval_hull());
        let limit = Complexity { generators: ng / 2 + n, constraints: nc / 2 };
        let mut reduced = set.clone();
        let hull_us = least_us(200, || set.interval_hull_into(&mut hull, &mut workspace))?;
        let support_us = least_us(200, || set.support(&vec![1.0; n], &mut workspace).map(|_| ()))?;
        let reduce_us = least_us(20, || {
            reduced.clone_from(&set);
            reduced.reduce(limit, Reduction::Method4, &mut workspace)
        })?;
        let mut directions = Directions::new(n);
        let reencode_us = least_us(20, || {
            reduced.clone_from(&set);
            reduced.reencode(Reencoding::new(n + 1), &mut directions, &mut workspace)
        })?;
        println!("{n:>5}{ng:>5}{nc:>5}{hull_us:>11.1}{support_us:>12.1}{reduce_us:>12.1}{reencode_us:>13.1}");
    }
    Ok(())
}
