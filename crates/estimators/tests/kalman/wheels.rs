//! The wheeled robot of paper 002: Jacobians, autonomous errors, misprints.

use estimators::kalman::wheels::{
    Drivable, ImperfectError, ImperfectIekf, InvariantWheels, PlainError, TfgIekf, TwoFrameError, WheelEkf, WheelError,
    WheelState, WheelStep, Wheels,
};
use estimators::kalman::{Chart, Ekf, Gaussian, Motion, OnGroup, SmoothMotion, SmoothSensor};
use estimators::{ErrorSide, Estimator, Left, Right};
use lie_groups::{LieGroup, RPlus, SE2, ScaledSO2, Sim2, TfgLever2, TfgScaleLever2};
use nalgebra::{Matrix2, Matrix3, Matrix6, SMatrix, SVector, Vector2, Vector3, Vector6};

use crate::support::{Random, cases};

/// Central differences of `f` at 0.
fn slopes<const M: usize, const N: usize>(f: impl Fn(&SVector<f64, N>) -> SVector<f64, M>) -> SMatrix<f64, M, N> {
    let (mut m, h) = (SMatrix::<f64, M, N>::zeros(), 2e-6);
    for k in 0..N {
        let step = SVector::from_fn(|i, _| if i == k { h } else { 0.0 });
        m.set_column(k, &((f(&step) - f(&-step)) / (2.0 * h)));
    }
    m
}

fn state(random: &mut Random) -> WheelState {
    let (x, l) = (random.matrix::<2, 1>() * 3.0, random.matrix::<2, 1>() * 2.0);
    WheelState::new(3.0 * random.unit(), 1.1 + 0.8 * random.unit(), x, l)
}

fn step(random: &mut Random) -> WheelStep {
    WheelStep::new(random.unit(), random.matrix::<2, 1>() * 2.0)
}

/// Jacobians of one error against central differences, and its coordinates against themselves.
fn check_jacobians<C: WheelError>() {
    let mut random = Random::new(21);
    for _ in 0..cases(50) {
        let (x, u) = (state(&mut random), step(&mut random));
        let near = |name: &str, miss: f64| assert!(miss < 1e-8, "{name} of {:?}: {miss:e}", C::check(&x));
        let moved = |e: &Vector6<f64>, w: &Vector3<f64>| {
            let from = |x: &WheelState, w: &Vector3<f64>| Motion::<C, 6, 3>::transition(&Wheels, x, &u, w);
            C::difference(&from(&C::shift(&x, e), w), &from(&x, &Vector3::zeros())).unwrap()
        };
        let (a, g) = SmoothMotion::<C, 6, 3>::motion_jacobians(&Wheels, &x, &u);
        near("A", (slopes(|e| moved(e, &Vector3::zeros())) - a).norm());
        near("G", (slopes(|w| moved(&Vector6::zeros(), w)) - g).norm());
        let h = C::innovation_jacobian(&x);
        near("H", (slopes(|e| C::innovation(&x, &C::shift(&x, e).antenna())) - h).norm());
        let n = slopes(|v| C::innovation(&x, &(x.antenna() + v)));
        near("N", (n * C::frame(&x) - Matrix2::identity()).norm());
        let (hy, d) = SmoothSensor::<C, 6, 2, 2>::output_jacobians(&Wheels, &x);
        near("D H", (hy - C::frame(&x) * h).norm() + (d - Matrix2::identity()).norm());

        let e = Vector6::from_fn(|i, _| if i == 1 { 0.5 } else { 2.0 } * random.unit());
        near("log exp", (C::difference(&C::shift(&x, &e), &x).unwrap() - e).norm());
        let around = |d: &Vector6<f64>| C::difference(&C::shift(&x, &(e + d)), &C::shift(&x, &e)).unwrap();
        near("transport", (slopes(around) - C::transport(&e)).norm());
        let plain = |e: &Vector6<f64>| PlainError::difference(&C::shift(&x, e), &x).unwrap();
        near("to plain", (slopes(plain) - C::to_plain(&x)).norm());
        near("from plain", (C::from_plain(&x) * C::to_plain(&x) - Matrix6::identity()).norm());
        let sigma = Vector6::new(0.1, 0.2, 0.3, 0.4, 0.5, 0.6);
        near("deviations", (C::deviations(&C::belief(x, &sigma).unwrap()) - sigma).norm());
    }
}

#[test]
fn jacobians_are_derivatives() {
    check_jacobians::<PlainError>();
    check_jacobians::<ImperfectError>();
    check_jacobians::<TwoFrameError>();
}

/// Spread of the error after a step, of the innovation, and of the error after an update by a fixed gain, over 20 estimates with the same
/// error.
fn spreads<C: WheelError>() -> [f64; 3] {
    let mut random = Random::new(8);
    let e = Vector6::new(0.8, -0.3, 1.0, -0.5, 0.4, 0.7);
    let (u, gain) = (step(&mut random), random.matrix::<6, 2>() * 0.3);
    let mut seen: [Vec<Vector6<f64>>; 3] = Default::default();
    for _ in 0..20 {
        let x = state(&mut random);
        let truth = C::shift(&x, &e);
        seen[0].push(C::difference(&truth.moved(&u), &x.moved(&u)).unwrap());
        let z = C::innovation(&x, &truth.antenna());
        seen[1].push(Vector6::new(z[0], z[1], 0.0, 0.0, 0.0, 0.0));
        seen[2].push(C::difference(&truth, &C::shift(&x, &(gain * z))).unwrap());
    }
    seen.map(|all| all.iter().flat_map(|a| all.iter().map(move |b| (a - b).amax())).fold(0.0, f64::max))
}

/// Propositions 3 and 4: the error of paper 002 after a step, its innovation and its update are functions of the error, whatever the
/// estimate; those of the other filters are not. And a step is linear in the error of paper 002, of any size.
#[test]
fn the_error_moves_by_itself() {
    for (part, spread) in spreads::<TwoFrameError>().iter().enumerate() {
        assert!(*spread <= 1e-13, "{part}: {spread:e}");
    }
    for spread in spreads::<ImperfectError>().iter().chain(&spreads::<PlainError>()) {
        assert!(*spread > 0.1, "{spread}");
    }
    let mut random = Random::new(9);
    for _ in 0..cases(50) {
        let (x, u, e) = (state(&mut random), step(&mut random), random.matrix::<6, 1>() * 2.0);
        let after = TwoFrameError::difference(&TwoFrameError::shift(&x, &e).moved(&u), &x.moved(&u)).unwrap();
        assert!((after - TwoFrameError::jacobians(&x, &u).0 * e).norm() < 1e-12);
    }
}

/// `(E^R, E^s, E^x, E^X)` of (27) as rotation matrix, number and vectors.
fn error(truth: &WheelState, estimate: &WheelState) -> (Matrix2<f64>, f64, Vector2<f64>, Vector2<f64>) {
    let back = estimate.heading.inverse();
    let turn = back.compose(&truth.heading);
    (
        turn.act_linear(),
        truth.scale / estimate.scale,
        back.act(&(truth.position - estimate.position)) / estimate.scale,
        (truth.lever - turn.inverse().act(&estimate.lever)) / truth.scale,
    )
}

/// Paper 002, (28): the innovation is `E^x + E^s E^R E^X = E^x - (E^-1)^X`; the second brace is not `E^X`, as printed, but to first order.
#[test]
fn erratum_28_the_innovation() {
    let mut random = Random::new(5);
    for _ in 0..cases(20) {
        let (x, size) = (state(&mut random), 1e-4);
        let truth = state(&mut random);
        let (e_r, e_s, e_x, e_l) = error(&truth, &x);
        let brace = TwoFrameError::innovation(&x, &truth.antenna()) - e_x;
        let (_, _, _, inverse) = error(&x, &truth);
        assert!((brace - e_r * e_l * e_s).norm() < 1e-13 && (brace + inverse).norm() < 1e-13);
        assert!((brace - e_l).norm() > 1e-2, "{}", (brace - e_l).norm());
        let truth = TwoFrameError::shift(&x, &(random.matrix::<6, 1>() * size));
        let (_, _, e_x, e_l) = error(&truth, &x);
        assert!((TwoFrameError::innovation(&x, &truth.antenna()) - e_x - e_l).norm() < 10.0 * size * size);
    }
}

/// Paper 002, (30): an update by `(L_g, L_x, L_X')` takes `E^X` to `E^X - ((E^g)^-1 L_g) * L_X'`; the sign and the inverse printed there are
/// wrong. And section VI-A, second bullet: with the scale left out of the position's move, `E^x` is not updated by itself.
#[test]
fn errata_30_and_second_bullet_the_update() {
    let mut random = Random::new(6);
    for _ in 0..cases(20) {
        let (x, truth) = (state(&mut random), state(&mut random));
        let xi = random.matrix::<6, 1>();
        let after = TwoFrameError::shift(&x, &xi);
        let (e_r, e_s, e_x, e_l) = error(&truth, &x);
        let (after_r, after_s, after_x, after_l) = error(&truth, &after);
        // L = exp(xi) is the error of the corrected estimate about the predicted one.
        let (l_r, l_s, l_x, l_l) = error(&after, &x);
        let turn = e_r.transpose() * l_r * (l_s / e_s);
        assert!((after_l - (e_l - turn * l_l)).norm() < 1e-12);
        let printed = e_l + e_r.transpose() * l_r.transpose() * l_l / (e_s * l_s);
        assert!((after_l - printed).norm() > 1e-2);
        // E^+ = L^-1 E in the other components.
        assert!((after_r - l_r.transpose() * e_r).norm() + (after_s - e_s / l_s).abs() < 1e-13);
        assert!((after_x - l_r.transpose() * (e_x - l_x) / l_s).norm() < 1e-12);
        let bullet = WheelState { position: x.position + x.heading.act(&l_x), ..after };
        let (_, _, bullet_x, _) = error(&truth, &bullet);
        let of_scale = (l_r.transpose() * (e_x - l_x / x.scale) / l_s - bullet_x).norm();
        assert!(of_scale < 1e-12 && (bullet_x - after_x).norm() > 1e-3 * (x.scale - 1.0).abs());
    }
}

/// The frame of a state.
fn frame(x: &WheelState) -> ScaledSO2<f64> {
    ScaledSO2::new(x.heading, RPlus::from_scale(x.scale).unwrap())
}

/// A state with `X' = X / s` on the two-frame group.
fn element(x: &WheelState) -> TfgScaleLever2<f64> {
    TfgScaleLever2::new(frame(x), [x.position], [x.lever / x.scale])
}

/// Jacobians of the model on a group, either error, against central differences; `A` holds for errors of any size.
fn check_group<G: Drivable<N>, Side: ErrorSide + PartialEq, const N: usize>(of: impl Fn(&WheelState) -> G) {
    let mut random = Random::new(22);
    for _ in 0..cases(20) {
        let (state, u) = (state(&mut random), step(&mut random));
        let x = of(&state);
        let shift = |e: &SVector<f64, N>| <OnGroup<G, Side, 2> as Chart<N>>::shift(&x, e);
        let moved =
            |x: &G, w: &Vector3<f64>| Motion::<OnGroup<G, Side, 2>, N, 3>::transition(&InvariantWheels, x, &u, w);
        let still = Vector3::zeros();
        let after = |y: &G| <OnGroup<G, Side, 2> as Chart<N>>::difference(y, &moved(&x, &still)).unwrap();
        let (a, g) = SmoothMotion::<OnGroup<G, Side, 2>, N, 3>::motion_jacobians(&InvariantWheels, &x, &u);
        let (h, d) = SmoothSensor::<OnGroup<G, Side, 2>, N, 2, 2>::output_jacobians(&InvariantWheels, &x);
        let near = |name: &str, miss: f64| assert!(miss < 1e-8, "{name}, left {}: {miss:e}", Side::IS_LEFT);
        near("A", (slopes(|e| after(&moved(&shift(e), &still))) - a).norm());
        near("G", (slopes(|w| after(&moved(&x, w))) - g).norm());
        near("H", (slopes(|e| shift(e).antenna()) - h).norm() + (d - Matrix2::identity()).norm());
        let e = random.matrix::<N, 1>();
        let miss = (after(&moved(&shift(&e), &still)) - a * e).norm();
        assert!(miss < 1e-11, "a large error is not moved by A: {miss:e}");
    }
}

#[test]
fn jacobians_on_groups_are_derivatives() {
    let (pose, scaled) =
        (|x: &WheelState| SE2::new(x.heading, &x.position), |x: &WheelState| Sim2::new(frame(x), [x.position], []));
    let lever = |x: &WheelState| TfgLever2::new(x.heading, [x.position], [x.lever]);
    check_group::<SE2<f64>, Left, 3>(pose);
    check_group::<SE2<f64>, Right, 3>(pose);
    check_group::<Sim2<f64>, Left, 4>(scaled);
    check_group::<TfgLever2<f64>, Left, 5>(lever);
    check_group::<TfgLever2<f64>, Right, 5>(lever);
    check_group::<TfgScaleLever2<f64>, Left, 6>(element);
    check_group::<TfgScaleLever2<f64>, Right, 6>(element);
}

/// (29): the update in the variables of the robot is that on the group of `X' = X / s`, and so are the filters.
#[test]
fn the_filter_in_its_own_variables_is_the_one_on_the_group() {
    type Group = OnGroup<TfgScaleLever2<f64>, Left, 2>;
    let mut random = Random::new(23);
    for _ in 0..cases(20) {
        let (x, xi) = (state(&mut random), random.matrix::<6, 1>());
        let apart = element(&TwoFrameError::shift(&x, &xi)).inverse().compose(&Group::shift(&element(&x), &xi));
        assert!(apart.log().unwrap().norm() < 1e-13);
    }
    let x = state(&mut random);
    let own = TwoFrameError::belief(x, &Vector6::new(0.5, 0.2, 1.0, 1.0, 0.5, 0.5)).unwrap();
    let start = Gaussian::new(element(&x), &own.covariance()).unwrap();
    let (q, r) = (Matrix3::identity() * 1e-3, Matrix2::identity() * 0.04);
    for reset in [false, true] {
        let mut own = TfgIekf::new(Wheels, own, &q, &r).unwrap().with_reset(reset);
        let mut group: Ekf<_, Group, 6, 2, 3, 2> = Ekf::new(InvariantWheels, start, &q, &r).unwrap().with_reset(reset);
        for _ in 0..20 {
            let (u, y) = (step(&mut random), own.belief().mean().antenna() + random.matrix::<2, 1>() * 0.5);
            own.step(&u, y.as_slice()).unwrap();
            group.step(&u, y.as_slice()).unwrap();
            let apart = element(own.belief().mean()).inverse().compose(group.belief().mean());
            assert!(apart.log().unwrap().norm() < 1e-9);
            let (p, expected) = (own.belief().covariance(), group.belief().covariance());
            assert!((p - expected).norm() < 1e-9 * expected.norm());
        }
    }
}

/// Only the two-frame filter keeps the scale positive, whatever is measured.
#[test]
fn the_scale_stays_positive() {
    let sigma = Vector6::new(3.0, 0.5, 1.0, 1.0, 1.0, 1.0);
    let guess = WheelState::new(0.0, 1.0, Vector2::zeros(), Vector2::zeros());
    let (q, r) = (Matrix3::identity() * 1e-6, Matrix2::identity() * 1e-4);
    let u = WheelStep::new(0.05, Vector2::new(0.5, 0.0));
    // The robot drives backwards, as far as the filters can tell.
    let drive = |filter: &mut dyn FnMut(&WheelStep, [f64; 2])| {
        for k in 1..=20 {
            filter(&u, [-0.5 * f64::from(k), 0.0]);
        }
    };
    let mut tfg = TfgIekf::new(Wheels, TwoFrameError::belief(guess, &sigma).unwrap(), &q, &r).unwrap();
    let mut least = f64::INFINITY;
    drive(&mut |u, y| {
        tfg.predict(u).unwrap();
        tfg.update(&y).unwrap();
        least = least.min(tfg.belief().mean().scale);
    });
    assert!(least > 0.0);
    let known = Vector6::new(1e-3, 0.5, 0.1, 0.1, 0.1, 0.1);
    let mut ekf = WheelEkf::new(Wheels, PlainError::belief(guess, &known).unwrap(), &q, &r).unwrap();
    let mut imperfect = ImperfectIekf::new(Wheels, ImperfectError::belief(guess, &known).unwrap(), &q, &r).unwrap();
    let mut tfg = TfgIekf::new(Wheels, TwoFrameError::belief(guess, &known).unwrap(), &q, &r).unwrap();
    drive(&mut |u, y| {
        ekf.step(u, &y).unwrap();
        imperfect.step(u, &y).unwrap();
        tfg.step(u, &y).unwrap();
    });
    assert!(
        ekf.belief().mean().scale < 0.0 && imperfect.belief().mean().scale < 0.0 && tfg.belief().mean().scale > 0.0
    );
}

/// What is refused leaves the filter as it was: inputs, outputs, scales that are not positive, measurements beyond the gate.
#[test]
fn refusals_change_nothing() {
    let guess = WheelState::new(0.0, 1.0, Vector2::zeros(), Vector2::zeros());
    let start = TwoFrameError::belief(guess, &Vector6::repeat(0.1)).unwrap();
    let (q, r) = (Matrix3::identity() * 1e-6, Matrix2::identity() * 0.01);
    let filter = || TfgIekf::new(Wheels, start, &q, &r).unwrap();
    let mut gated = filter().with_gate(9.21).unwrap();
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(gated.predict(&WheelStep::new(bad, Vector2::zeros())).is_err());
        assert!(gated.predict(&WheelStep::new(0.0, Vector2::new(0.0, bad))).is_err());
        assert!(gated.update(&[bad, 0.0]).is_err());
    }
    let far = [1.0, 1.0];
    let wrong = gated.update(&far).unwrap_err();
    let mut open = filter();
    open.update(&far).unwrap();
    let nis = open.innovation().unwrap().nis();
    assert_eq!(wrong, estimators::EstimatorError::Gated { nis, limit: 9.21 });
    assert!(nis > 9.21 && gated.step(&WheelStep::new(0.1, Vector2::zeros()), &far).is_err());
    assert_eq!((gated.belief(), gated.innovation()), (&start, None));
    gated.update(&[0.1, 0.1]).unwrap();
    assert!(gated.innovation().unwrap().nis() < 9.21);
    for bad in [f64::NAN, 0.0, -1.0] {
        assert!(filter().with_gate(bad).is_err());
        let backwards = WheelState { scale: bad, ..guess };
        assert!(TwoFrameError::belief(backwards, &Vector6::repeat(0.1)).is_err());
    }
    let negative = WheelState { scale: -1.0, ..guess };
    assert!(PlainError::belief(negative, &Vector6::repeat(0.1)).is_ok());
    assert!(TwoFrameError::difference(&negative, &guess).is_err());
    assert!(Gaussian::<TwoFrameError, 6>::new(negative, &Matrix6::identity()).is_err());
}
