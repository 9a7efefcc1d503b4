//! Sets whose volume, vertices and reductions are known by hand.

use setrep::{Matrix, Reduction, SetError, Workspace, Zonotope};

fn zonotope(rows: &[&[f64]]) -> Zonotope {
    Zonotope::new(&vec![0.0; rows.len()], &Matrix::from_rows(rows).unwrap()).unwrap()
}

#[test]
fn volumes() {
    // (generators by row, volume): box, hexagon, rhombic dodecahedron, truncated octahedron, 4-cube, segment, flat.
    let table: [(&[&[f64]], f64); 8] = [
        (&[&[2.0, 0.0], &[0.0, 3.0]], 24.0),
        (&[&[1.0, 0.0, 1.0], &[0.0, 1.0, 1.0]], 12.0),
        (&[&[1.0, 1.0, -1.0, -1.0], &[1.0, -1.0, 1.0, -1.0], &[1.0, -1.0, -1.0, 1.0]], 128.0),
        (
            &[&[1.0, 1.0, 1.0, 1.0, 0.0, 0.0], &[1.0, -1.0, 0.0, 0.0, 1.0, 1.0], &[0.0, 0.0, 1.0, -1.0, 1.0, -1.0]],
            256.0,
        ),
        (&[&[1.0, 0.0, 0.0, 0.0], &[0.0, 1.0, 0.0, 0.0], &[0.0, 0.0, 1.0, 0.0], &[0.0, 0.0, 0.0, 1.0]], 16.0),
        (&[&[1.0, -2.5]], 7.0),
        (&[&[1.0, 2.0, -3.0], &[2.0, 4.0, -6.0]], 0.0),
        (&[&[1.0, 0.0], &[0.0, 1.0], &[0.0, 0.0]], 0.0),
    ];
    for (rows, volume) in table {
        let computed = zonotope(rows).volume().unwrap();
        assert!(computed.contains(volume) && computed.width() <= 1e-11 * (1.0 + volume), "{computed} for {volume}");
    }
}

/// A regular 2m-gon of generators `(cos, sin)(pi j / m)` has area `4 sum_{i<j} sin(pi (j - i) / m) = 2 m / tan(pi / (2 m))`.
#[test]
fn regular_polygons() {
    for m in [2, 3, 5, 16, 100] {
        let columns: Vec<[f64; 2]> =
            (0..m).map(|j| std::f64::consts::PI * f64::from(j) / f64::from(m)).map(|t| [t.cos(), t.sin()]).collect();
        let set = Zonotope::new(
            &[1.0, 2.0],
            &Matrix::from_columns(&columns.iter().map(<[f64; 2]>::as_slice).collect::<Vec<_>>()).unwrap(),
        )
        .unwrap();
        let expected = 2.0 * f64::from(m) / (std::f64::consts::PI / (2.0 * f64::from(m))).tan();
        assert!((set.volume().unwrap().mid() / expected - 1.0).abs() < 1e-12);
        assert_eq!(set.vertices_2d().unwrap().len(), 2 * m as usize);
        assert_eq!(set.outline_2d(0, 1).unwrap().len(), 2 * m as usize + 1);
    }
}

#[test]
fn vertices_of_segments_and_points() {
    assert_eq!(zonotope(&[&[1.0, 2.0], &[1.0, 2.0]]).vertices_2d().unwrap(), [[-3.0, -3.0], [3.0, 3.0]]);
    assert_eq!(zonotope(&[&[0.0], &[0.0]]).vertices_2d().unwrap(), [[0.0, 0.0]]);
    assert_eq!(zonotope(&[&[1.0]]).vertices_2d(), Err(SetError::NotPlanar { dim: 1 }));
}

#[test]
fn outlines_are_projections() {
    let cube = Zonotope::from_box(&[1.0, 2.0, 3.0], &[1.0, 1.0, 1.0]).unwrap();
    assert_eq!(cube.outline_2d(2, 0).unwrap(), [[2.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0], [2.0, 0.0]]);
    assert!(cube.outline_2d(0, 3).is_err());
}

fn reduced(rows: &[&[f64]], method: Reduction, order: usize) -> Matrix {
    let mut set = zonotope(rows);
    set.reduce(method, order, &mut Workspace::new()).unwrap();
    assert!(set.remainder().iter().all(|&r| r < 1e-14));
    set.generators().clone()
}

fn assert_columns(found: &Matrix, expected: &[&[f64]]) {
    assert_eq!(found.cols(), expected.len(), "{found:?}");
    for column in expected {
        let near = |g: &&[f64]| {
            let same = |s: f64| g.iter().zip(*column).all(|(a, b)| (a - s * b).abs() < 1e-13);
            same(1.0) || same(-1.0)
        };
        assert_eq!(found.columns().filter(near).count(), 1, "{column:?} in {found:?}");
    }
}

/// The longest column stays, `|1| + |-0.5| + 0.25` and `|1| + |0.5| + 0` box the rest.
#[test]
fn combastel_by_hand() {
    let rows: [&[f64]; 2] = [&[4.0, 1.0, -0.5, 0.25], &[3.0, 1.0, 0.5, 0.0]];
    assert_columns(&reduced(&rows, Reduction::Combastel, 3), &[&[4.0, 3.0], &[1.75, 0.0], &[0.0, 1.5]]);
    assert_columns(&reduced(&rows, Reduction::Combastel, 2), &[&[5.75, 0.0], &[0.0, 4.5]]);
}

/// `|g|_1 - |g|_inf` is 1, 0, 0.5, 0: the long columns along the axes are boxed at no cost.
#[test]
fn girard_by_hand() {
    let rows: [&[f64]; 2] = [&[1.0, 4.0, 0.5, 0.0], &[1.0, 0.0, 0.5, 8.0]];
    assert_columns(&reduced(&rows, Reduction::Girard, 3), &[&[1.0, 1.0], &[4.5, 0.0], &[0.0, 8.5]]);
}

/// Along the diagonals the box is exact: the principal axes find it.
#[test]
fn pca_by_hand() {
    let rows: [&[f64]; 2] = [&[1.0, 2.0, 0.25, -0.5], &[1.0, 2.0, -0.25, 0.5]];
    assert_columns(&reduced(&rows, Reduction::Pca, 2), &[&[3.0, 3.0], &[0.75, -0.75]]);
}

/// `T = [e1 e2]`; of the columns `(0.5, 0)` (growth 0) and `(0.5, 0.5)` (growth 0.25), the first is free.
#[test]
fn method4_by_hand() {
    let rows: [&[f64]; 2] = [&[1.0, 0.0, 0.5, 0.5], &[0.0, 1.0, 0.0, 0.5]];
    assert_columns(&reduced(&rows, Reduction::Method4, 3), &[&[0.5, 0.5], &[1.5, 0.0], &[0.0, 1.0]]);
    assert_columns(&reduced(&rows, Reduction::Method4, 2), &[&[2.0, 0.0], &[0.0, 1.5]]);
}

/// Rank-deficient, zero and extreme generators go through every method.
#[test]
fn degenerate_generators() {
    let flat: [&[f64]; 3] = [&[1.0, 2.0, 3.0, 4.0, 5.0], &[0.0; 5], &[1.0, 2.0, 3.0, 4.0, 5.0]];
    let zero: [&[f64]; 3] = [&[0.0; 5], &[0.0; 5], &[0.0; 5]];
    let large: [&[f64]; 2] = [&[1e300, 1e299, 2e299, -1e300], &[1e300, -1e299, 1e200, 1e-300]];
    let small: [&[f64]; 2] = [&[1e-310, 5e-324, 1e-300, 0.0], &[1e-310, 5e-324, 0.0, 1e-320]];
    for rows in [&flat[..], &zero, &large, &small] {
        for method in [Reduction::Combastel, Reduction::Girard, Reduction::Pca, Reduction::Method4] {
            let set = zonotope(rows);
            let mut reduced = set.clone();
            reduced.reduce(method, 3, &mut Workspace::new()).unwrap();
            assert!(reduced.num_generators() <= 3);
            // Both hulls are rounded outward, so they are compared up to rounding.
            let (before, after) = (set.interval_hull(), reduced.interval_hull());
            let mut sides = before.iter().zip(after.iter());
            assert!(sides.all(|(a, b)| a.subset_of(&b.inflate(1e-13 * b.mag()))), "{method:?} {rows:?}");
        }
    }
}

#[test]
fn conversions() {
    let matrix = Matrix::from_rows(&[&[1.0, 2.0, 3.0], &[4.0, 5.0, 6.0]]).unwrap();
    assert_eq!(Matrix::from(&matrix.to_dmatrix()), matrix);
    assert_eq!(Matrix::from(&matrix.to_smatrix::<2, 3>().unwrap()), matrix);
    assert!(matrix.to_smatrix::<3, 3>().is_err());
    let mut target = Matrix::identity(5);
    target.assign(&matrix.to_smatrix::<2, 3>().unwrap());
    assert_eq!(target, matrix);
    assert_eq!(matrix.transpose().transpose(), matrix);
    assert_eq!((matrix.get(1, 2), matrix.get(2, 0)), (Some(6.0), None));
}
