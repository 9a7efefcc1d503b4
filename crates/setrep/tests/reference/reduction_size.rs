//! How much larger the reductions make a set: bounds on a fixed corpus, so that a reduction that is valid but poor is seen.

use setrep::{Matrix, Reduction, Workspace, Zonotope};

use crate::common::random::Random;

/// Mean over the corpus of (volume after / volume before)^(1/n) and of the ratio of the largest half-widths.
fn growth(method: Reduction, n: usize, m: usize, order: usize) -> (f64, f64) {
    let mut workspace = Workspace::new();
    let (mut volume, mut radius) = (0.0, 0.0);
    let corpus = 60;
    for case in 0..corpus {
        let mut random = Random::new(11, case);
        // Lengths from 0.05 to 1, as in a filter where old noise has shrunk.
        let columns: Vec<Vec<f64>> = (0..m)
            .map(|_| {
                let length = 20f64.powf(-random.moderate().abs() / 2.0);
                (0..n).map(|_| length * random.moderate()).collect()
            })
            .collect();
        let generators = Matrix::from_columns(&columns.iter().map(Vec::as_slice).collect::<Vec<_>>()).unwrap();
        let set = Zonotope::new(&vec![0.0; n], &generators).unwrap();
        let mut reduced = set.clone();
        reduced.reduce(method, order, &mut workspace).unwrap();
        volume += (reduced.volume().unwrap().mid() / set.volume().unwrap().mid()).powf(1.0 / n as f64);
        radius += reduced.radius() / set.radius();
    }
    (volume / corpus as f64, radius / corpus as f64)
}

#[test]
fn growth_is_bounded() {
    use Reduction::{Combastel, Girard, Method4, Pca};
    // (method, n, m, order, most growth in volume^(1/n), most growth of the hull)
    let table = [
        (Combastel, 3, 35, 30, 1.031, 1.0 + 1e-14),
        (Girard, 3, 35, 30, 1.028, 1.0 + 1e-14),
        (Pca, 3, 35, 30, 1.026, 1.020),
        (Method4, 3, 35, 30, 1.012, 1.015),
        (Combastel, 2, 12, 6, 1.12, 1.0 + 1e-14),
        (Girard, 2, 12, 6, 1.116, 1.0 + 1e-14),
        (Pca, 2, 12, 6, 1.078, 1.074),
        (Method4, 2, 12, 6, 1.043, 1.087),
    ];
    for (method, n, m, order, most_volume, most_radius) in table {
        let (volume, radius) = growth(method, n, m, order);
        println!("{method:?} n {n} {m} -> {order}: volume^(1/n) x {volume:.5}, hull x {radius:.5}");
        assert!((1.0..=most_volume).contains(&volume), "{method:?} {n} {m} {order}: volume^(1/n) grew by {volume}");
        assert!((1.0 - 1e-14..=most_radius).contains(&radius), "{method:?} {n} {m} {order}: hull grew by {radius}");
    }
}

/// On random generators, method 4 makes the smallest sets and Combastel's boxes larger ones than Girard's.
#[test]
fn order_of_the_methods() {
    let volume = |method| growth(method, 2, 12, 6).0;
    assert!(volume(Reduction::Method4) < volume(Reduction::Girard));
    assert!(volume(Reduction::Girard) < volume(Reduction::Combastel));
}
