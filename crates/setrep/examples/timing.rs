//! Times of the operations of a filter step on this machine, beside faer's product of the same size.
//!
//! `cargo run --release -p setrep --example timing`

use std::hint::black_box;
use std::time::Instant;

use faer::{Accum, MatMut, MatRef, Par, linalg::matmul::matmul};
use setrep::{IntervalVector, Matrix, Reduction, SetError, Workspace, Zonotope};

/// The least of many means, in nanoseconds.
fn time(mut f: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..200 {
        let start = Instant::now();
        for _ in 0..500 {
            f();
        }
        best = best.min(start.elapsed().as_secs_f64() * 1e9 / 500.0);
    }
    best
}

/// Entries in `(-1, 1)` of very different columns, reproducible.
fn sample(rows: usize, cols: usize) -> Matrix {
    let mut state = 1_u64;
    let mut matrix = Matrix::zeros(rows, cols);
    for x in matrix.as_mut_slice() {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        *x = (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0;
    }
    matrix
}

fn report(name: &str, nanoseconds: f64, floor: f64) {
    println!("{name:<44} {nanoseconds:9.1} ns  {:6.2} x", nanoseconds / floor);
}

fn main() -> Result<(), SetError> {
    let mut workspace = Workspace::new();
    for (n, m, order) in [(3, 35, 30), (4, 12, 10), (10, 40, 30)] {
        println!("n = {n}");
        let map = sample(n, n);
        let map = Matrix::from_column_slice(n, n, &map.as_slice().iter().map(|x| x * 0.5).collect::<Vec<_>>())?;
        let generators = sample(n, m);
        let set = Zonotope::new(&vec![1.0; n], &generators)?;
        let columns = order + 3;
        let small = Zonotope::new(&vec![1.0; n], &sample(n, columns))?;

        let mut product = vec![0.0; n * columns];
        let floor = time(|| {
            matmul(
                MatMut::from_column_major_slice_mut(black_box(&mut product), n, columns),
                Accum::Replace,
                MatRef::from_column_major_slice(black_box(map.as_slice()), n, n),
                MatRef::from_column_major_slice(black_box(small.generators().as_slice()), n, columns),
                1.0,
                Par::Seq,
            );
        });
        report(&format!("faer product {n}x{n} times {n}x{columns}"), floor, floor);

        let mut target = small.clone();
        let copy = time(|| target.clone_from(black_box(&small)));
        report("copy of the set (subtracted below)", copy, floor);
        let linear = time(|| {
            target.clone_from(black_box(&small));
            let _ = target.linear_map_in_place(black_box(&map), &mut workspace);
        });
        report("linear_map_in_place", linear - copy, floor);
        for method in [Reduction::Combastel, Reduction::Girard, Reduction::Pca, Reduction::Method4] {
            let reduce = time(|| {
                target.clone_from(black_box(&set));
                let _ = target.reduce(method, order, &mut workspace);
            });
            report(&format!("reduce {method:?} {m} -> {order}"), reduce - copy, floor);
        }
        let mut covariation = Matrix::zeros(n, n);
        report("covariation_into", time(|| black_box(&small).covariation_into(black_box(&mut covariation))), floor);
        let direction = vec![1.0; n];
        report(
            "support",
            time(|| {
                let _ = black_box(black_box(&small).support(black_box(&direction)));
            }),
            floor,
        );
        let mut hull = small.interval_hull();
        report(
            "interval_hull_into",
            time(|| {
                let _ = black_box(black_box(&small).interval_hull_into(&mut hull));
            }),
            floor,
        );
        for t in [0.3, 0.9, 0.99] {
            // A point at gauge t along the first axis.
            let Ok(gauge) = small.gauge_approx(&shifted(&small, 1.0)) else { continue };
            let point = IntervalVector::point(&shifted(&small, t / gauge));
            let membership = small.membership(&point)?;
            let calls = time_few(|| {
                let _ = black_box(small.membership(black_box(&point)));
            });
            report(&format!("membership at gauge {t}: {membership:?}"), calls, floor);
        }
    }
    Ok(())
}

/// The center moved along the first axis.
fn shifted(set: &Zonotope, by: f64) -> Vec<f64> {
    let mut point = set.center().to_vec();
    point[0] += by;
    point
}

/// As [`time`], for operations of microseconds and more.
fn time_few(mut f: impl FnMut()) -> f64 {
    let start = Instant::now();
    for _ in 0..200 {
        f();
    }
    start.elapsed().as_secs_f64() * 1e9 / 200.0
}
