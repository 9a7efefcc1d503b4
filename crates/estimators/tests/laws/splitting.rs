//! A step is an update followed by a prediction.

use estimators::{Estimator, InZsmf, Outputs, Right, Zsmf};
use lie_groups::{LieGroup, SE2};
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use setrep::{Reduction, Zonotope};

use crate::support::{Linear, Random, boxed, increment, vehicle_inzsmf};

/// `G G'` and the sum of `|G|` over columns: what two sets with the same generators in another order have in common.
fn invariants(set: &Zonotope) -> (Matrix3<f64>, Vector3<f64>) {
    let (mut gram, mut sum) = (Matrix3::zeros(), Vector3::zeros());
    for column in set.generators().columns() {
        let g = Vector3::from_column_slice(column);
        gram += g * g.transpose();
        sum += g.abs();
    }
    (gram, sum)
}

fn assert_same(a: &Zonotope, b: &Zonotope) {
    assert_eq!(a.num_generators(), b.num_generators());
    let ((gram_a, sum_a), (gram_b, sum_b)) = (invariants(a), invariants(b));
    assert!((gram_a - gram_b).amax() < 1e-10 * gram_a.amax());
    assert!((sum_a - sum_b).amax() < 1e-10 * sum_a.amax());
}

#[test]
fn of_a_linear_model() {
    let mut random = Random::new(41);
    let model = Linear { a: random.matrix(), c: random.matrix::<2, 3>(), d: random.matrix::<3, 1>() };
    let start = boxed(&[1.0, 2.0, 3.0]);
    let mut whole = Zsmf::new(model, &start, &boxed(&[0.1]), &boxed(&[0.2, 0.3])).unwrap();
    let mut split = whole.clone();
    for _ in 0..20 {
        let (u, y) = (random.matrix::<3, 1>(), random.matrix::<2, 1>());
        whole.step(&u, y.as_slice()).unwrap();
        split.update(y.as_slice()).unwrap();
        split.predict(&u).unwrap();
        assert!((whole.estimate() - split.estimate()).amax() < 1e-11);
        assert_same(whole.enclosure(), split.enclosure());
    }
}

/// On a group too: for the left error as published and with transport, for the right error with transport.
#[test]
fn on_a_group() {
    let mut random = Random::new(42);
    let fresh = || {
        let (start, errors) = (SE2::from_pose(0.7, 3.0, -2.0), boxed(&[0.3, 1.0, 2.0]));
        let outputs = Outputs::Right(vec![Vector2::new(5.0, -1.0)]);
        InZsmf::<SE2<f64>, 3, 2, Right>::new(start, &errors, outputs, &boxed(&[0.01; 3]), &boxed(&[0.5; 2])).unwrap()
    };
    let mut right = (fresh().with_transport(true), fresh().with_transport(true));
    let unreduced = |transport| {
        let filter = vehicle_inzsmf([0.7, 3.0, -2.0], [0.3, 1.0, 2.0]).with_transport(transport);
        filter.with_reduction(Reduction::Combastel, 1000).unwrap()
    };
    let mut left = [(unreduced(false), unreduced(false)), (unreduced(true), unreduced(true))];
    for _ in 0..20 {
        let (xi, y) = (increment() * 20.0, random.matrix::<2, 1>() * 5.0);
        right.0.step(&xi, y.as_slice()).unwrap();
        right.1.update(y.as_slice()).unwrap();
        right.1.predict(&xi).unwrap();
        assert_same(right.0.tangent_set(), right.1.tangent_set());
        for (whole, split) in &mut left {
            whole.step(&xi, y.as_slice()).unwrap();
            split.update(y.as_slice()).unwrap();
            split.predict(&xi).unwrap();
            assert!(whole.estimate().inverse().compose(split.estimate()).log().unwrap().amax() < 1e-11);
            assert_same(whole.tangent_set(), split.tangent_set());
        }
    }
}

/// A missed measurement is a prediction; the set then grows by the noise alone.
#[test]
fn a_prediction_grows_the_set_by_the_noise() {
    let model = Linear { a: Matrix2::identity(), c: Matrix2::identity(), d: Matrix2::identity() };
    let mut filter = Zsmf::new(model, &boxed(&[1.0, 1.0]), &boxed(&[0.25, 0.5]), &boxed(&[1.0, 1.0])).unwrap();
    filter.predict(&Vector2::new(10.0, 0.0)).unwrap();
    let hull = filter.enclosure().interval_hull();
    for (side, (lo, hi)) in hull.iter().zip([(8.75, 11.25), (-1.5, 1.5)]) {
        assert!((side.lo() - lo).abs() < 1e-13 && (side.hi() - hi).abs() < 1e-13, "{side:?}");
    }
}
