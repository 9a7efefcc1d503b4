//! The left and the right filter are one filter in two coordinate systems, `H_R = Ad_Xhat H_L`.

use estimators::{ErrorSide, Estimator, InZsmf, Left, Outputs, Right};
use lie_groups::{LieGroup, SE2};
use nalgebra::{Matrix3, SMatrix, SVector, Vector2, Vector3};
use setrep::{Matrix, Zonotope};

use crate::support::{Random, boxed, increment};

type Filter<Side, const M: usize> = InZsmf<SE2<f64>, 3, 2, Side, M>;

/// The two filters of one situation: the right one starts with the image of the left one's set.
fn both<const M: usize>(outputs: &Outputs<2>, transport: bool) -> (Filter<Left, M>, Filter<Right, M>) {
    let start = SE2::from_pose(0.7, 3.0, -2.0);
    let spread = Matrix3::from_diagonal(&Vector3::new(0.3, 1.0, 2.0));
    let set = |generators: Matrix3<f64>| Zonotope::new(&[0.0; 3], &Matrix::from(&generators)).unwrap();
    let (left, right) = (set(spread), set(start.adjoint() * spread));
    (filter(start, &left, outputs, transport), filter(start, &right, outputs, transport))
}

fn filter<Side: ErrorSide, const M: usize>(
    start: SE2<f64>,
    errors: &Zonotope,
    outputs: &Outputs<2>,
    transport: bool,
) -> Filter<Side, M> {
    InZsmf::new(start, errors, outputs.clone(), &boxed(&[0.01, 0.1, 0.2]), &boxed(&[0.5; M]))
        .unwrap()
        .with_transport(transport)
}

/// Largest entry of `Ad H_L - H_R` over the largest entry of `H_R`.
fn mismatch(adjoint: &Matrix3<f64>, left: &Zonotope, right: &Zonotope) -> f64 {
    assert_eq!(left.num_generators(), right.num_generators());
    let (mut worst, mut size) = (0.0f64, 0.0f64);
    for (l, r) in left.generators().columns().zip(right.generators().columns()) {
        let (l, r) = (Vector3::from_column_slice(l), Vector3::from_column_slice(r));
        worst = worst.max((adjoint * l - r).amax());
        size = size.max(r.amax());
    }
    worst / size
}

fn gap(a: &SE2<f64>, b: &SE2<f64>) -> f64 {
    a.inverse().compose(b).log().unwrap().amax()
}

/// Measurements far from the estimate, so that corrections are not small.
fn measurement<const M: usize>(random: &mut Random) -> SVector<f64, M> {
    let noise: SMatrix<f64, M, 1> = random.matrix();
    noise * 4.0
}

/// With transport: the same estimates and the same sets over many steps, whatever the outputs and however large the corrections.
fn transported_sides_agree<const M: usize>(outputs: &Outputs<2>, seed: u64) {
    let mut random = Random::new(seed);
    let (mut left, mut right) = both::<M>(outputs, true);
    for k in 0..30 {
        let (xi, y) = (increment() * 10.0 + random.matrix::<3, 1>() * 0.1, measurement::<M>(&mut random));
        match k % 3 {
            0 => {
                left.update(y.as_slice()).unwrap();
                right.update(y.as_slice()).unwrap();
            }
            1 => {
                left.predict(&xi).unwrap();
                right.predict(&xi).unwrap();
            }
            _ => {
                left.step(&xi, y.as_slice()).unwrap();
                right.step(&xi, y.as_slice()).unwrap();
            }
        }
        assert!(gap(left.estimate(), right.estimate()) < 1e-11, "step {k}");
        let off = mismatch(&left.estimate().adjoint(), left.tangent_set(), right.tangent_set());
        assert!(off < 1e-10, "step {k}: {off:e}");
    }
}

#[test]
fn transported_sides_agree_on_the_position() {
    transported_sides_agree::<2>(&Outputs::position(), 31);
}

#[test]
fn transported_sides_agree_on_two_body_points() {
    transported_sides_agree::<4>(&Outputs::Left(vec![Vector2::new(1.0, 0.5), Vector2::new(-2.0, 0.0)]), 32);
}

#[test]
fn transported_sides_agree_on_a_landmark() {
    transported_sides_agree::<2>(&Outputs::Right(vec![Vector2::new(5.0, -1.0)]), 33);
}

#[test]
fn transported_sides_agree_on_three_landmarks() {
    let landmarks = vec![Vector2::new(5.0, -1.0), Vector2::new(0.0, 7.0), Vector2::new(-3.0, -3.0)];
    transported_sides_agree::<6>(&Outputs::Right(landmarks), 34);
}

/// As published: a step gives the same estimate, and the sets agree through the adjoint of the prediction, about which both are written.
#[test]
fn published_sides_agree_for_a_step() {
    let mut random = Random::new(35);
    for outputs in [Outputs::position(), Outputs::Right(vec![Vector2::new(5.0, -1.0)])] {
        let (mut left, mut right) = both::<2>(&outputs, false);
        let y = measurement::<2>(&mut random);
        let predicted = left.estimate().compose(&SE2::exp(&increment()));
        left.step(&increment(), y.as_slice()).unwrap();
        right.step(&increment(), y.as_slice()).unwrap();
        assert!(gap(left.estimate(), right.estimate()) < 1e-13);
        assert!(mismatch(&predicted.adjoint(), left.tangent_set(), right.tangent_set()) < 1e-13);
    }
}

/// Predictions alone agree, with and without transport.
#[test]
fn predicted_sides_agree() {
    let mut random = Random::new(36);
    let (mut left, mut right) = both::<2>(&Outputs::position(), false);
    for _ in 0..20 {
        let xi = random.matrix::<3, 1>();
        left.predict(&xi).unwrap();
        right.predict(&xi).unwrap();
    }
    assert_eq!(left.estimate(), right.estimate());
    assert!(mismatch(&left.estimate().adjoint(), left.tangent_set(), right.tangent_set()) < 1e-11);
}

/// Both kinds of innovation vanish where the measurement is exact.
#[test]
fn an_exact_measurement_moves_nothing() {
    let pose = SE2::from_pose(0.7, 3.0, -2.0);
    let (body, world) = (Vector2::new(0.3, -0.4), Vector2::new(5.0, -1.0));
    for (outputs, y) in
        [(Outputs::Left(vec![body]), pose.act(&body)), (Outputs::Right(vec![world]), pose.inverse().act(&world))]
    {
        let (mut left, mut right) = both::<2>(&outputs, false);
        left.update(y.as_slice()).unwrap();
        right.update(y.as_slice()).unwrap();
        assert!(gap(left.estimate(), &pose) < 1e-14);
        assert!(gap(right.estimate(), &pose) < 1e-14);
        assert!(left.tangent_set().f_radius() < boxed(&[0.3, 1.0, 2.0]).f_radius());
    }
}
