//! The checks of models, the mean and the conversions.

use lie_groups::{
    ErrorKind, GroupError, LieGroup, RPlus, SE2, SE3, SO2, SO3, ScaledSO2, Sim3, TfgLever2, TfgLever3, TfgScaleLever2,
    check_autonomous, check_compatible_output, check_group_affine, mean,
};
use nalgebra::{Isometry2, Isometry3, SVector, Vector2, Vector3};

use crate::support::random::Random;

fn states<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(stream: &str, count: usize) -> Vec<G> {
    let mut random = Random::new(stream);
    (0..count).map(|_| G::exp(&SVector::from_fn(|_, _| random.uniform(-1.0, 1.0)))).collect()
}

/// Odometry in the plane with a constant lever arm: group affine, its error autonomous on both sides, its position output compatible.
#[test]
fn a_constant_lever_arm_is_group_affine_in_the_plane() {
    let step = |x: &TfgLever2<f64>| {
        let ahead = x.frame().act(&Vector2::new(0.5, 0.1));
        TfgLever2::new(x.frame().compose(&SO2::from_angle(0.3)), [x.fixed()[0] + ahead], *x.body())
    };
    let samples: Vec<TfgLever2<f64>> = states("lever 2", 8);
    let residual = check_group_affine(step, &samples).unwrap();
    println!("constant lever arm in the plane: {residual:.1e}");
    assert!(residual < 1e-14, "{residual:e}");
    let errors = [SVector::from([0.4, -0.2, 0.3, 0.5, 0.1]), SVector::from([-2.0, 1.0, 3.0, -1.0, 0.2])];
    for kind in [ErrorKind::Left, ErrorKind::Right] {
        let spread = check_autonomous(step, kind, &errors, &samples).unwrap();
        assert!(spread < 1e-13, "{kind:?}: {spread:e}");
    }
    // The antenna at x + R l; a state moves it as R (l + y) + x.
    let antenna = |x: &TfgLever2<f64>| x.act(&x.body()[0]);
    let moved = |x: &TfgLever2<f64>, y: &Vector2<f64>| x.act(&(x.body()[0] + y));
    assert!(check_compatible_output(antenna, moved, &samples) < 1e-14);
    // The lever arm by itself is no compatible output of this action.
    assert!(check_compatible_output(|x: &TfgLever2<f64>| x.body()[0], moved, &samples) > 0.1);
}

/// In space a constant body vector is not group affine, one that turns with the body is.
#[test]
fn a_constant_lever_arm_is_not_group_affine_in_space() {
    let turn = SO3::exp(&Vector3::new(0.2, -0.1, 0.3));
    let step = |x: &TfgLever3<f64>, lever: Vector3<f64>| {
        let ahead = x.frame().act(&Vector3::new(0.5, 0.1, 0.0));
        TfgLever3::new(x.frame().compose(&turn), [x.fixed()[0] + ahead], [lever])
    };
    let samples: Vec<TfgLever3<f64>> = states("lever 3", 8);
    let constant = check_group_affine(|x| step(x, x.body()[0]), &samples).unwrap();
    let turning = check_group_affine(|x| step(x, turn.inverse().act(&x.body()[0])), &samples).unwrap();
    println!("lever arm in space: constant {constant:.2}, turning {turning:.1e}");
    assert!(constant > 0.1, "{constant}");
    assert!(turning < 1e-14, "{turning:e}");
    let error = [SVector::<f64, 9>::from_fn(|k, _| 0.1 * (k as f64 - 4.0))];
    assert!(check_autonomous(|x| step(x, x.body()[0]), ErrorKind::Left, &error, &samples).unwrap() > 0.05);
}

/// The position scaled by the wheel, with an unknown scale, is group affine in the variables divided by the scale (paper 002, section V-C).
#[test]
fn an_unknown_wheel_scale_needs_the_change_of_variables() {
    let forward = Vector2::new(0.5, 0.0);
    let turn = ScaledSO2::new(SO2::from_angle(0.3), RPlus::from_log(0.0));
    let samples: Vec<TfgScaleLever2<f64>> = states("scale", 8);
    let transformed = |x: &TfgScaleLever2<f64>| {
        TfgScaleLever2::new(x.frame().compose(&turn), [x.fixed()[0] + x.frame().act(&forward)], *x.body())
    };
    assert!(check_group_affine(transformed, &samples).unwrap() < 1e-14);
    // Kept as a length, the lever arm is not multiplied by the scale: the output is then not compatible.
    let plain = |x: &TfgScaleLever2<f64>| x.fixed()[0] + x.frame().rotation().act(&x.body()[0]);
    let moved = |x: &TfgScaleLever2<f64>, y: &Vector2<f64>| x.act(&(x.body()[0] + y));
    assert!(check_compatible_output(plain, moved, &samples) > 0.1);
    let scaled = |x: &TfgScaleLever2<f64>| x.act(&x.body()[0]);
    assert!(check_compatible_output(scaled, moved, &samples) < 1e-13);
}

/// The mean of `A X_i B` is `A M B`, the weighted logs at the mean cancel.
#[test]
fn means_do_not_depend_on_the_frame() {
    let mut random = Random::new("mean");
    let elements: Vec<Sim3<f64>> = (0..7)
        .map(|_| Sim3::exp(&SVector::from_fn(|k, _| random.uniform(-0.5, 0.5) + if k == 0 { 2.0 } else { 0.0 })))
        .collect();
    let weights: Vec<f64> = (1..8).map(f64::from).collect();
    let middle = mean(&elements, Some(&weights)).unwrap();
    let rest = elements
        .iter()
        .zip(&weights)
        .fold(SVector::<f64, 7>::zeros(), |sum, (x, w)| sum + middle.inverse().compose(x).log().unwrap() * *w);
    assert!(rest.norm() < 1e-12, "{rest:?}");
    let (a, b): (Sim3<f64>, Sim3<f64>) = (states("mean a", 1)[0], states("mean b", 1)[0]);
    let moved: Vec<Sim3<f64>> = elements.iter().map(|x| a.compose(x).compose(&b)).collect();
    let expected = a.compose(&middle).compose(&b);
    assert!(expected.inverse().compose(&mean(&moved, Some(&weights)).unwrap()).log().unwrap().norm() < 1e-12);
    assert!(matches!(mean::<Sim3<f64>, 7, 3>(&[], None), Err(GroupError::NoMean { .. })));
    assert!(mean(&elements, Some(&weights[1..])).is_err());
    assert!(mean(&elements, Some(&[0.0; 7])).is_err());
}

/// nalgebra's isometries act as ours do, forth and back.
#[test]
fn conversions_keep_the_action() {
    let (p2, p3) = (Vector2::new(0.3, -0.7), Vector3::new(0.3, -0.7, 1.1));
    for pose in states::<SE2<f64>, 3, 2>("isometry 2", 5) {
        let isometry: Isometry2<f64> = pose.into();
        assert!((isometry * nalgebra::Point2::from(p2) - nalgebra::Point2::from(pose.act(&p2))).norm() < 1e-15);
        assert_eq!(SE2::from(isometry), pose);
    }
    for pose in states::<SE3<f64>, 6, 3>("isometry 3", 5) {
        let isometry: Isometry3<f64> = pose.into();
        assert!((isometry * nalgebra::Point3::from(p3) - nalgebra::Point3::from(pose.act(&p3))).norm() < 1e-15);
        assert_eq!(SE3::from(isometry), pose);
        let rotation = pose.frame();
        let again = SO3::from_matrix(&rotation.rotation_matrix()).unwrap();
        assert!(again.inverse().compose(&rotation).log().unwrap().norm() < 1e-15);
        let [w, x, y, z] = rotation.quaternion();
        // Any length and sign of the quaternion.
        let scaled = SO3::from_quaternion(-3.0 * w, -3.0 * x, -3.0 * y, -3.0 * z).unwrap();
        assert!(scaled.inverse().compose(&rotation).log().unwrap().norm() < 1e-15);
    }
    assert_eq!(SO3::from_quaternion(0.0, 0.0, 0.0, 0.0), Err(GroupError::NotARotation));
    assert_eq!(SO3::from_quaternion(1.0, f64::NAN, 0.0, 0.0), Err(GroupError::NotFinite { index: 1 }));
    assert!(matches!(RPlus::from_scale(-0.5), Err(GroupError::NotAScale { .. })));
}

/// Over half a turn, where the trace gives no quaternion: every choice of the largest entry.
#[test]
fn half_turns_have_quaternions() {
    let angle = std::f64::consts::PI - 1e-3;
    for axis in [Vector3::x(), Vector3::y(), Vector3::z(), Vector3::new(0.6, -0.8, 0.0)] {
        let turn = SO3::exp(&(axis * angle));
        let again = SO3::from_matrix(&turn.rotation_matrix()).unwrap();
        assert!((again.log().unwrap() - axis * angle).norm() < 1e-12);
    }
}
