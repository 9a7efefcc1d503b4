//! Criterion benches of the steps and of the operations they consist of, for statistics and for regressions over time.

use criterion::{Criterion, criterion_group, criterion_main};

/// Hands every comparison of the table to criterion: our side only.
fn hot_paths(criterion: &mut Criterion) {
    let mut benches = benches::all();
    // Rows against several peers share our side.
    benches.dedup_by(|a, b| a.name == b.name);
    for mut bench in benches {
        let name = bench.name.clone();
        criterion.bench_function(&name, |bencher| bencher.iter_custom(|iterations| bench.time_ours(iterations)));
    }
}

criterion_group!(group, hot_paths);
criterion_main!(group);
