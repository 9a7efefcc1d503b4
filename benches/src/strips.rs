//! Intersections of zonotopes with strips: all candidates by shared minors against the sum of determinants of each.

use std::hint::black_box;

use nalgebra::{DMatrix, Matrix2, Matrix3, Matrix4, Matrix5};
use setrep::{Matrix, Workspace, Zonotope};

use crate::draw::Draw;
use crate::timing::Bench;

/// The rows `strip/*`: `n` dimensions, `ng` generators; 2 x 18 is a step of the batch reactor.
pub fn benches() -> Vec<Bench> {
    vec![candidates::<2>(18), candidates::<2>(40), candidates::<3>(20), candidates::<4>(20), candidates::<5>(15)]
}

/// The volumes of the `ng + 1` candidates of a strip.
fn candidates<const N: usize>(columns: usize) -> Bench {
    let entries = Draw::new(8).normals(N * columns);
    let matrix = Matrix::from_column_slice(N, columns, &entries).expect("the sizes agree");
    let set = Zonotope::new(&[0.0; N], &matrix).expect("all entries are finite");
    let generators: Vec<[f64; N]> = entries.as_chunks::<N>().0.to_vec();
    let (mut workspace, mut volumes, mut candidate) = (Workspace::new(), Vec::new(), Vec::new());
    let a = [1.0; N];
    let ours = move || {
        let volumes = set.approx_candidate_volumes(black_box(&a), 0.3, &mut workspace).expect("few minors");
        black_box(volumes);
    };
    let theirs = move || {
        direct(black_box(&generators), &a, 0.3, &mut candidate, &mut volumes);
        black_box(&volumes);
    };
    Bench::new(format!("strip/candidates-{N}x{columns}"), "direct-sum", ours, theirs)
}

/// (35)-(37) as they stand: the generators of each candidate, then all its determinants, in nalgebra's closed forms up to 4 x 4.
fn direct<const N: usize>(
    generators: &[[f64; N]],
    a: &[f64; N],
    half_width: f64,
    candidate: &mut Vec<[f64; N]>,
    volumes: &mut Vec<f64>,
) {
    let along = |g: &[f64; N]| a.iter().zip(g).map(|(a, g)| a * g).sum::<f64>();
    volumes.clear();
    candidate.clear();
    candidate.extend_from_slice(generators);
    volumes.push(minor_sum(candidate));
    for (j, pivot) in generators.iter().enumerate() {
        let scale = along(pivot);
        candidate.clear();
        candidate.extend(generators.iter().enumerate().map(|(i, g)| {
            let (kept, share) = if i == j { (0.0, half_width / scale) } else { (1.0, -along(g) / scale) };
            core::array::from_fn(|k| kept * g[k] + share * pivot[k])
        }));
        volumes.push(minor_sum(candidate));
    }
}

/// The sum of the absolute determinants of all subsets of `N` columns.
fn minor_sum<const N: usize>(columns: &[[f64; N]]) -> f64 {
    let mut subset: [usize; N] = core::array::from_fn(|i| i);
    let mut sum = 0.0;
    loop {
        sum += determinant(N, |i, k| columns[subset[k]][i]).abs();
        let Some(last) = (0..N).rev().find(|&i| subset[i] < columns.len() - N + i) else { return sum };
        subset[last] += 1;
        for i in last + 1..N {
            subset[i] = subset[i - 1] + 1;
        }
    }
}

fn determinant(n: usize, entry: impl Fn(usize, usize) -> f64) -> f64 {
    match n {
        2 => Matrix2::from_fn(entry).determinant(),
        3 => Matrix3::from_fn(entry).determinant(),
        4 => Matrix4::from_fn(entry).determinant(),
        5 => Matrix5::from_fn(entry).determinant(),
        _ => DMatrix::from_fn(n, n, entry).determinant(),
    }
}
