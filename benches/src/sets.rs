//! Zonotope operations against the floor of their arithmetic: faer's product of the same size.

use std::hint::black_box;

use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};
use setrep::{Matrix, Reduction, Workspace, Zonotope};

use crate::timing::Bench;

/// faer's `3x3` times `3x33` product on slices, nothing allocated: the unit in which steps of planar filters are counted.
pub struct FaerProduct {
    map: [f64; 9],
    columns: Vec<f64>,
    product: Vec<f64>,
}

impl FaerProduct {
    /// A product of the given number of columns.
    pub fn new(columns: usize) -> Self {
        let (sin, cos) = 0.3_f64.sin_cos();
        let map = [1.0, 0.01, -0.02, 0.0, cos, sin, 0.0, -sin, cos];
        Self { map, columns: generators(columns), product: vec![0.0; 3 * columns] }
    }

    /// One product.
    pub fn run(&mut self) {
        let cols = self.columns.len() / 3;
        matmul(
            MatMut::from_column_major_slice_mut(&mut self.product, 3, cols),
            Accum::Replace,
            MatRef::from_column_major_slice(black_box(&self.map), 3, 3),
            MatRef::from_column_major_slice(black_box(&self.columns), 3, cols),
            1.0,
            Par::Seq,
        );
        black_box(&self.product);
    }
}

/// `3 x columns` generators of mixed lengths.
pub fn generators(columns: usize) -> Vec<f64> {
    (0..3 * columns).map(|k| (k as f64 * 0.7).sin() / (1.0 + 0.05 * k as f64)).collect()
}

/// A set in 3-D.
fn set(columns: usize) -> Zonotope {
    let matrix = Matrix::from_column_slice(3, columns, &generators(columns)).expect("the sizes agree");
    Zonotope::new(&[0.5, -1.0, 2.0], &matrix).expect("all entries are finite")
}

/// The rows `zonotope/*`.
pub fn benches() -> Vec<Bench> {
    let mut benches = vec![map()];
    for (name, method) in [
        ("zonotope/combastel-35-to-30", Reduction::Combastel),
        ("zonotope/girard-35-to-30", Reduction::Girard),
        ("zonotope/pca-35-to-30", Reduction::Pca),
        ("zonotope/method4-35-to-30", Reduction::Method4),
    ] {
        let source = set(35);
        let (mut reduced, mut workspace, mut product) = (source.clone(), Workspace::new(), FaerProduct::new(33));
        let ours = move || {
            reduced.clone_from(black_box(&source));
            reduced.reduce(method, 30, &mut workspace).expect("30 columns suffice in 3-D");
            black_box(&reduced);
        };
        benches.push(Bench::new(name, "faer-product", ours, move || product.run()));
    }
    benches
}

/// A rotation of a set of 33 generators, rounding included. A fresh source each time: the rounding of a million maps of
/// one set would grow to model size.
fn map() -> Bench {
    let (sin, cos) = 0.3_f64.sin_cos();
    let rotation = Matrix::from_rows(&[&[1.0, 0.0, 0.0], &[0.0, cos, -sin], &[0.0, sin, cos]]).expect("three rows");
    let (source, mut workspace, mut product) = (set(33), Workspace::new(), FaerProduct::new(33));
    let mut image = source.clone();
    let ours = move || {
        image.clone_from(black_box(&source));
        image.linear_map_in_place(&rotation, &mut workspace).expect("sizes agree");
        black_box(&image);
    };
    Bench::new("zonotope/map-3x33", "faer-product", ours, move || product.run())
}
