//! Operations on constrained zonotopes against the floor of their arithmetic: faer's product of the same size.

use std::hint::black_box;

use scalars::Interval;
use setrep::{Complexity, Matrix, Reduction, Workspace, Zonotope};

use crate::cz_sets::{SIZES, Size, random};
use crate::draw::Draw;
use crate::sets::FaerProduct;
use crate::timing::Bench;

/// The rows `cz/*`.
pub fn benches() -> Vec<Bench> {
    SIZES[1..3].iter().flat_map(|&size| [map(size), sum(size), intersection(size), reduction(size)]).collect()
}

/// A map by a square matrix, rounding included. A fresh source each time, as for zonotopes.
fn map(size: Size) -> Bench {
    let matrix = square(size.n);
    row("map", size, move |set, workspace| set.linear_map_in_place(&matrix, workspace).expect("sizes agree"))
}

/// A sum with a box.
fn sum(size: Size) -> Bench {
    let noise = Zonotope::from_box(&vec![0.0; size.n], &vec![0.1; size.n]).expect("a box").into();
    row("sum", size, move |set, _| set.add_assign(&noise).expect("sizes agree"))
}

/// An intersection with two strips.
fn intersection(size: Size) -> Bench {
    let entries = Draw::new(3).normals(2 * size.n);
    let rows = Matrix::from_column_slice(2, size.n, &entries).expect("the sizes agree");
    let bands = [Interval::point(0.0).inflate(1.0); 2];
    row("intersect", size, move |set, workspace| set.intersect_rows(&rows, &bands, workspace).expect("sizes agree"))
}

/// Half of the constraints eliminated and half of the generators reduced.
fn reduction(size: Size) -> Bench {
    let limit = Complexity { generators: size.ng / 2 + size.n, constraints: size.nc / 2 };
    row("reduce", size, move |set, workspace| set.reduce(limit, Reduction::Method4, workspace).expect("within reach"))
}

fn row(
    name: &str,
    size: Size,
    operation: impl Fn(&mut setrep::ConstrainedZonotope, &mut Workspace) + 'static,
) -> Bench {
    let source = random(size, 1);
    let (mut set, mut workspace, mut product) =
        (source.clone(), Workspace::new(), FaerProduct::new(size.n, size.ng + size.nc));
    let ours = move || {
        set.clone_from(black_box(&source));
        operation(&mut set, &mut workspace);
        black_box(&set);
    };
    Bench::new(format!("cz/{name}-{size}"), "faer-product", ours, move || product.run())
}

fn square(n: usize) -> Matrix {
    Matrix::from_column_slice(n, n, &Draw::new(2).normals(n * n)).expect("the sizes agree")
}
