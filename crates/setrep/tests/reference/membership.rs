//! Membership where it is decided by hand: vertices, facets, flat sets, many generators.

use scalars::Interval;
use setrep::{IntervalVector, Matrix, Membership, SetError, Zonotope};

use crate::common::random::Random;

fn verdict(set: &Zonotope, x: &[f64]) -> Membership {
    set.membership(&IntervalVector::point(x)).unwrap()
}

/// Just inside, at and just outside of every vertex and every facet of the rhombic dodecahedron.
#[test]
fn vertices_and_facets() {
    let rows: [&[f64]; 3] = [&[1.0, 1.0, -1.0, -1.0], &[1.0, -1.0, 1.0, -1.0], &[1.0, -1.0, -1.0, 1.0]];
    let set = Zonotope::new(&[0.0; 3], &Matrix::from_rows(&rows).unwrap()).unwrap();
    let vertices = [[4.0, 0.0, 0.0], [0.0, -4.0, 0.0], [2.0, 2.0, 2.0], [-2.0, 2.0, -2.0]];
    let facets = [[2.0, 2.0, 0.0], [0.0, -2.0, 2.0]];
    for point in vertices.into_iter().chain(facets) {
        let at = |t: f64| verdict(&set, &point.map(|x| x * t));
        assert_eq!(at(1.0 - 1e-10), Membership::ProvenInside, "{point:?}");
        assert_ne!(at(1.0), Membership::ProvenOutside, "{point:?}");
        assert_eq!(at(1.0 + 1e-10), Membership::ProvenOutside, "{point:?}");
        assert!((set.gauge_approx(&point).unwrap() - 1.0).abs() < 1e-12);
    }
}

#[test]
fn flat_sets() {
    let segment = Zonotope::new(&[1.0, 1.0], &Matrix::from_rows(&[&[2.0], &[1.0]]).unwrap()).unwrap();
    assert_eq!(verdict(&segment, &[3.5, 2.25]), Membership::ProvenOutside);
    assert_eq!(verdict(&segment, &[2.0, 1.6]), Membership::ProvenOutside);
    assert_ne!(verdict(&segment, &[2.0, 1.5]), Membership::ProvenOutside);
    assert_eq!(segment.gauge_approx(&[2.0, 1.6]).unwrap(), f64::INFINITY);
    // In a coordinate plane, the points of the plane are decided.
    let plate =
        Zonotope::new(&[0.0; 3], &Matrix::from_rows(&[&[1.0, 1.0], &[1.0, -1.0], &[0.0, 0.0]]).unwrap()).unwrap();
    assert_eq!(verdict(&plate, &[0.5, 0.5, 0.0]), Membership::ProvenInside);
    assert_eq!(verdict(&plate, &[0.5, 0.5, 1e-300]), Membership::ProvenOutside);
    // One point.
    let point = Zonotope::point(&[1.0, 2.0]).unwrap();
    assert_eq!(verdict(&point, &[1.0, 2.0]), Membership::ProvenInside);
    assert_eq!(verdict(&point, &[1.0, 2.0 + 1e-15]), Membership::ProvenOutside);
}

/// Opposite and duplicate generators, whose exterior products vanish, do not stand in the way.
#[test]
fn parallel_generators() {
    let rows: [&[f64]; 3] = [&[1.0, 2.0, -1.0, 0.0, 0.3], &[1.0, 2.0, -1.0, 0.0, 0.7], &[0.0, 0.0, 0.0, 1.0, 0.1]];
    let set = Zonotope::new(&[0.0; 3], &Matrix::from_rows(&rows).unwrap()).unwrap();
    let boundary = 1.0 / set.gauge_approx(&[1.0, 0.8, 0.2]).unwrap();
    assert_eq!(
        verdict(&set, &[boundary, 0.8 * boundary, 0.2 * boundary].map(|x| x * (1.0 - 1e-9))),
        Membership::ProvenInside
    );
    assert_eq!(
        verdict(&set, &[boundary, 0.8 * boundary, 0.2 * boundary].map(|x| x * (1.0 + 1e-9))),
        Membership::ProvenOutside
    );
}

/// The size of a filter's sets: 30 generators in space, all but the boundary decided.
#[test]
fn thirty_generators_in_space() {
    let mut random = Random::new(3, 0);
    let data: Vec<f64> = (0..90).map(|_| random.moderate()).collect();
    let set =
        Zonotope::with_remainder(&[1.0, 2.0, 3.0], &Matrix::from_column_slice(3, 30, &data).unwrap(), &[1e-15; 3])
            .unwrap();
    for _ in 0..300 {
        let direction = [random.moderate(), random.moderate(), random.moderate()];
        let gauge = set.gauge_approx(&[1.0 + direction[0], 2.0 + direction[1], 3.0 + direction[2]]).unwrap();
        let at = |t: f64| {
            verdict(
                &set,
                &[1.0 + t / gauge * direction[0], 2.0 + t / gauge * direction[1], 3.0 + t / gauge * direction[2]],
            )
        };
        for t in [0.1, 0.9, 0.999, 1.0 - 1e-11] {
            assert_eq!(at(t), Membership::ProvenInside, "gauge {t} along {direction:?}");
        }
        for t in [1.0 + 1e-11, 1.001, 5.0] {
            assert_eq!(at(t), Membership::ProvenOutside, "gauge {t} along {direction:?}");
        }
    }
}

/// In many dimensions the witness still decides what is clearly inside; beyond the limit the rest is undecided or refused.
#[test]
fn beyond_the_facet_limit() {
    let mut random = Random::new(4, 0);
    let (n, m) = (10, 40);
    let data: Vec<f64> = (0..n * m).map(|_| random.moderate()).collect();
    let set = Zonotope::new(&vec![0.0; n], &Matrix::from_column_slice(n, m, &data).unwrap()).unwrap();
    assert_eq!(verdict(&set, &vec![0.5; n]), Membership::ProvenInside);
    assert_eq!(verdict(&set, &vec![100.0; n]), Membership::ProvenOutside);
    assert!(matches!(set.gauge_approx(&vec![1.0; n]), Err(SetError::TooManySubsets { .. })));
    assert!(matches!(set.volume(), Err(SetError::TooManySubsets { .. })));
}

#[test]
fn bad_points() {
    let set = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    assert!(matches!(set.membership(&[Interval::ONE]), Err(SetError::Dimension { expected: 2, found: 1, .. })));
    assert!(matches!(
        set.membership(&[Interval::ONE, Interval::EMPTY]),
        Err(SetError::UnboundedInterval { row: 1, .. })
    ));
    assert!(matches!(
        set.membership(&[Interval::ENTIRE, Interval::ONE]),
        Err(SetError::UnboundedInterval { row: 0, .. })
    ));
    assert!(matches!(set.gauge_approx(&[0.0, f64::NAN]), Err(SetError::NonFinite { row: 1, .. })));
}

/// Scaled far down or up, where products of entries under- and overflow, the gauge stays what it is.
#[test]
fn the_gauge_does_not_depend_on_scale() {
    for s in [1.0, 1e-200, 1e160, 1e-300, 1e300] {
        let generators = Matrix::from_rows(&[&[s, 0.0, 0.0, s], &[0.0, s, 0.0, s], &[0.0, 0.0, s, s]]).unwrap();
        let set = Zonotope::new(&[0.0; 3], &generators).unwrap();
        let gauge = set.gauge_approx(&[1.9 * s, -1.9 * s, 0.0]).unwrap();
        assert!((gauge - 1.9).abs() < 1e-12, "{s:e}: {gauge}");
    }
}

/// Many dependent generators leave nearly every facet to interval arithmetic: the query ends all the same.
#[test]
fn dependent_generators_do_not_hang() {
    let n = 12;
    let columns: Vec<Vec<f64>> = (0..8)
        .map(|j| {
            let mut column = vec![0.0; n];
            (column[0], column[1]) = (1.0 + f64::from(j), 1.0 + f64::from(j * j));
            column
        })
        .collect();
    let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
    let set = Zonotope::new(&vec![0.0; n], &Matrix::from_columns(&columns).unwrap()).unwrap();
    let corner: Vec<f64> = (0..n).map(|i| columns.iter().map(|g| g[i]).sum()).collect();
    assert_ne!(verdict(&set, &corner), Membership::ProvenOutside);
}

#[test]
fn too_many_dimensions_are_named() {
    let n = 15;
    let set = Zonotope::new(&vec![0.0; n], &Matrix::identity(n)).unwrap();
    assert!(matches!(set.volume(), Err(SetError::TooManyDimensions { dim: 15, .. })));
    assert!(matches!(set.gauge_approx(&vec![2.0; n]), Err(SetError::TooManyDimensions { dim: 15, .. })));
    assert_eq!(Zonotope::point(&vec![1.0; n]).unwrap().volume().unwrap().hi(), 0.0);
}
