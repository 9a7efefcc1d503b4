//! Zonotope operations against the floor of their arithmetic: faer's product of the same size.

use std::hint::black_box;

use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};
use setrep::{Matrix, Reduction, Workspace, Zonotope};

use crate::timing::Bench;

/// faer's product of a square matrix and a wide one on slices, nothing allocated: the unit in which our operations are counted
/// (`3x3` times `3x33` for steps of planar filters).
pub struct FaerProduct {
    rows: usize,
    map: Vec<f64>,
    columns: Vec<f64>,
    product: Vec<f64>,
}

impl FaerProduct {
    /// The product `rows x rows` times `rows x columns`.
    pub fn new(rows: usize, columns: usize) -> Self {
        let [map, columns] = [rows, columns].map(|cols| entries(rows * cols));
        Self { rows, map, product: vec![0.0; columns.len()], columns }
    }

    /// One product.
    pub fn run(&mut self) {
        let (rows, cols) = (self.rows, self.columns.len() / self.rows);
        matmul(
            MatMut::from_column_major_slice_mut(&mut self.product, rows, cols),
            Accum::Replace,
            MatRef::from_column_major_slice(black_box(&self.map), rows, rows),
            MatRef::from_column_major_slice(black_box(&self.columns), rows, cols),
            1.0,
            Par::Seq,
        );
        black_box(&self.product);
    }
}

/// Entries of mixed sizes.
fn entries(count: usize) -> Vec<f64> {
    (0..count).map(|k| (k as f64 * 0.7).sin() / (1.0 + 0.05 * k as f64)).collect()
}

/// A set in 3-D.
fn set(columns: usize) -> Zonotope {
    let matrix = Matrix::from_column_slice(3, columns, &entries(3 * columns)).expect("the sizes agree");
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
        let (mut reduced, mut workspace, mut product) = (source.clone(), Workspace::new(), FaerProduct::new(3, 33));
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
    let (source, mut workspace, mut product) = (set(33), Workspace::new(), FaerProduct::new(3, 33));
    let mut image = source.clone();
    let ours = move || {
        image.clone_from(black_box(&source));
        image.linear_map_in_place(&rotation, &mut workspace).expect("sizes agree");
        black_box(&image);
    };
    Bench::new("zonotope/map-3x33", "faer-product", ours, move || product.run())
}
