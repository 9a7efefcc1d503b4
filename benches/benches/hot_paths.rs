//! Criterion benches of the steps and of the operations they consist of, for statistics and for regressions over time.

use criterion::{Criterion, criterion_group, criterion_main};

/// Hands every comparison of the table to criterion: our side only.
fn hot_paths(criterion: &mut Criterion) {
    for mut bench in benches::all() {
        let name = bench.name;
        criterion.bench_function(name, |bencher| bencher.iter_custom(|iterations| bench.time_ours(iterations)));
    }
}

criterion_group!(group, hot_paths);
criterion_main!(group);
