//! Bad input: a typed error that says what and where, and a filter that is as it was, bit for bit.

use std::f64::consts::PI;

use estimators::{
    Estimator, EstimatorError, Gain, InZsmf, Left, Outputs, Right, Zsmf, f_radius_gain, observability_rank, place,
};
use lie_groups::{LieGroup, SE2};
use nalgebra::{Complex, DMatrix, Matrix2, Matrix3, SMatrix, Vector2, Vector3};
use setrep::{Reduction, SetError, Zonotope};

use crate::support::{Linear, boxed, increment, vehicle_inzsmf, vehicle_zsmf};

const BAD: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// All bits of the state of a filter.
trait Bits {
    fn bits(&self) -> Vec<u64>;
}

fn set_bits(set: &Zonotope) -> impl Iterator<Item = u64> {
    set.center().iter().chain(set.generators().as_slice()).chain(set.remainder()).map(|v| v.to_bits())
}

impl<S: estimators::ErrorSide> Bits for InZsmf<SE2<f64>, 3, 2, S> {
    fn bits(&self) -> Vec<u64> {
        let matrix = self.estimate().matrix();
        matrix.iter().map(|v| v.to_bits()).chain(set_bits(self.tangent_set())).collect()
    }
}

impl<Mo: estimators::Model<N, M, W>, const N: usize, const M: usize, const W: usize> Bits for Zsmf<Mo, N, M, W> {
    fn bits(&self) -> Vec<u64> {
        self.estimate().iter().map(|v| v.to_bits()).chain(set_bits(self.enclosure())).collect()
    }
}

/// Runs a call that must fail, checks that the filter is unchanged and still works, and returns the error.
fn refused<F: Bits>(filter: &mut F, call: impl FnOnce(&mut F) -> Result<(), EstimatorError>) -> EstimatorError {
    let before = filter.bits();
    let error = call(filter).unwrap_err();
    assert_eq!(before, filter.bits(), "{error}");
    error
}

fn warm_inzsmf() -> InZsmf<SE2<f64>, 3, 2, Left> {
    let mut filter = vehicle_inzsmf([0.3, 1.0, -1.0], [0.5, 1.0, 1.0]);
    for _ in 0..20 {
        filter.step(&increment(), &[0.1, -0.2]).unwrap();
    }
    filter
}

#[test]
fn measurements_that_are_not_finite() {
    for bad in BAD {
        let mut invariant = warm_inzsmf();
        for error in [
            refused(&mut invariant, |f| f.step(&increment(), &[0.0, bad])),
            refused(&mut invariant, |f| f.update(&[0.0, bad])),
        ] {
            assert!(matches!(error, EstimatorError::NotFinite { what: "output", index: 1, .. }), "{error}");
        }
        let mut euclidean = vehicle_zsmf([0.0; 3], [1.0; 3]);
        let error = refused(&mut euclidean, |f| f.step(&(), &[bad, 0.0]));
        assert!(matches!(error, EstimatorError::NotFinite { what: "output", index: 0, .. }), "{error}");
        invariant.step(&increment(), &[0.0, 0.0]).unwrap();
    }
}

#[test]
fn measurements_of_the_wrong_length() {
    let mut invariant = warm_inzsmf();
    let mut euclidean = vehicle_zsmf([0.0; 3], [1.0; 3]);
    for y in [&[][..], &[1.0], &[1.0, 2.0, 3.0]] {
        let expected = EstimatorError::Size { what: "output", expected: 2, found: y.len() };
        assert_eq!(refused(&mut invariant, |f| f.step(&increment(), y)), expected);
        assert_eq!(refused(&mut invariant, |f| f.update(y)), expected);
        assert_eq!(refused(&mut euclidean, |f| f.step(&(), y)), expected);
        assert_eq!(refused(&mut euclidean, |f| f.update(y)), expected);
    }
}

#[test]
fn inputs_that_are_not_finite() {
    for bad in BAD {
        let mut filter = warm_inzsmf();
        let input = Vector3::new(0.0, bad, 0.0);
        for error in
            [refused(&mut filter, |f| f.predict(&input)), refused(&mut filter, |f| f.step(&input, &[0.0, 0.0]))]
        {
            assert!(matches!(error, EstimatorError::NotFinite { what: "input", index: 1, .. }), "{error}");
        }
        let model = Linear { a: Matrix2::identity(), c: Matrix2::identity(), d: Matrix2::identity() };
        let mut linear = Zsmf::new(model, &boxed(&[1.0; 2]), &boxed(&[0.1; 2]), &boxed(&[0.1; 2])).unwrap();
        let error = refused(&mut linear, |f| f.predict(&Vector2::new(0.0, bad)));
        assert!(matches!(error, EstimatorError::NotFinite { what: "estimate", index: 1, .. }), "{error}");
    }
}

/// Values near the end of the range overflow somewhere inside; that is an error as well.
#[test]
fn results_that_overflow() {
    let mut filter = warm_inzsmf();
    let huge = Vector3::new(0.0, f64::MAX, f64::MAX);
    refused(&mut filter, |f| f.predict(&huge).and_then(|()| f.predict(&huge)).and_then(|()| f.predict(&huge)));
    let mut filter = warm_inzsmf();
    refused(&mut filter, |f| f.update(&[f64::MAX, -f64::MAX]));
}

/// A model whose derivatives are wrong in kind is refused like an input.
#[test]
fn models_that_are_not_finite() {
    for bad in BAD {
        let good = Linear { a: Matrix2::identity(), c: Matrix2::identity(), d: Matrix2::identity() };
        let mut broken = [good.clone(), good.clone(), good];
        broken[0].a[(0, 1)] = bad;
        broken[1].c[(1, 1)] = bad;
        broken[2].d[(0, 0)] = bad;
        for model in broken {
            let mut filter = Zsmf::new(model, &boxed(&[1.0; 2]), &boxed(&[0.1; 2]), &boxed(&[0.1; 2])).unwrap();
            refused(&mut filter, |f| f.step(&Vector2::zeros(), &[1.0, 1.0]));
        }
    }
}

/// No output noise and no spread seen: S is zero.
#[test]
fn a_singular_innovation() {
    let model = Linear { a: Matrix2::identity(), c: Matrix2::new(1.0, 0.0, 2.0, 0.0), d: Matrix2::identity() };
    let mut filter = Zsmf::new(model, &boxed(&[1.0; 2]), &boxed(&[0.1; 2]), &boxed(&[0.0, 0.0])).unwrap();
    let error = refused(&mut filter, |f| f.step(&Vector2::zeros(), &[1.0, 2.0]));
    assert!(matches!(error, EstimatorError::SingularInnovation { outputs: 2, .. }), "{error}");
    // Noise on one output is enough for the pair.
    let model = filter.model().clone();
    let mut filter = Zsmf::new(model, &boxed(&[1.0; 2]), &boxed(&[0.1; 2]), &boxed(&[0.0, 0.1])).unwrap();
    filter.step(&Vector2::zeros(), &[1.0, 2.0]).unwrap();

    let errors = boxed(&[0.5, 0.0, 0.0]);
    let mut filter: InZsmf<SE2<f64>, 3, 2, Left> =
        InZsmf::new(SE2::identity(), &errors, Outputs::position(), &boxed(&[0.1; 3]), &boxed(&[0.0; 2])).unwrap();
    let error = refused(&mut filter, |f| f.update(&[0.0, 0.0]));
    assert!(matches!(error, EstimatorError::SingularInnovation { outputs: 2, .. }), "{error}");
    // It stays usable: process noise gives spread.
    filter.predict(&increment()).unwrap();
    filter.update(&[0.0, 0.0]).unwrap();

    let nan =
        f_radius_gain(&Matrix2::identity(), &Matrix2::from_element(f64::NAN), &Matrix2::identity(), &Matrix2::zeros());
    assert!(matches!(nan, Err(EstimatorError::NotFinite { .. })));
}

/// A vehicle at rest: its heading is not observable from its position, and the error says so.
#[test]
fn an_unobservable_pair() {
    let mut filter = warm_inzsmf().with_gain(Gain::real_poles([0.95, 0.98, 0.98]));
    let expected = EstimatorError::NotObservable { rank: 2, states: 3 };
    assert_eq!(refused(&mut filter, |f| f.step(&Vector3::zeros(), &[0.0, 0.0])), expected);
    filter.step(&increment(), &[0.0, 0.0]).unwrap();
    // The right-invariant error does not move: A = I, so three poles would need three outputs.
    let mut right: InZsmf<SE2<f64>, 3, 2, Right> =
        InZsmf::new(SE2::identity(), &boxed(&[0.5; 3]), Outputs::position(), &boxed(&[0.1; 3]), &boxed(&[0.1; 2]))
            .unwrap()
            .with_gain(Gain::real_poles([0.95, 0.98, 0.98]));
    assert_eq!(refused(&mut right, |f| f.step(&increment(), &[0.0, 0.0])), expected);
}

#[test]
fn placed_poles_need_the_input() {
    let mut filter = warm_inzsmf().with_gain(Gain::real_poles([0.95, 0.98, 0.98]));
    assert_eq!(refused(&mut filter, |f| f.update(&[0.0, 0.0])), EstimatorError::GainNeedsInput);
}

#[test]
fn lists_of_poles_that_cannot_be_placed() {
    let a = DMatrix::from_row_slice(3, 3, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.004, 0.08, -0.004, 1.0]);
    let c = DMatrix::from_row_slice(2, 3, &[0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
    let of = |poles: &[(f64, f64)]| {
        let poles: Vec<_> = poles.iter().map(|&(re, im)| Complex::new(re, im)).collect();
        place(&a, &c, &poles).unwrap_err()
    };
    assert_eq!(of(&[(0.5, 0.0); 2]), EstimatorError::PoleCount { expected: 3, found: 2 });
    assert_eq!(of(&[(0.5, 0.0); 4]), EstimatorError::PoleCount { expected: 3, found: 4 });
    let thrice = EstimatorError::PoleMultiplicity { re: 0.5, im: 0.0, multiplicity: 3, rank: 2 };
    assert_eq!(of(&[(0.5, 0.0); 3]), thrice);
    let alone = EstimatorError::PoleNotConjugate { re: 0.5, im: 0.1 };
    assert_eq!(of(&[(0.5, 0.1), (0.5, 0.0), (0.6, -0.1)]), alone);
    for bad in BAD {
        let error = of(&[(0.5, 0.0), (bad, 0.0), (0.5, 0.0)]);
        assert!(matches!(error, EstimatorError::NotFinite { what: "poles", index: 1, .. }), "{error}");
        let error = of(&[(0.5, 0.0), (0.5, 0.0), (0.5, bad)]);
        assert!(matches!(error, EstimatorError::NotFinite { what: "poles", index: 2, .. }), "{error}");
    }
    // An output counted twice adds no rank: a double pole is one too many.
    let twice = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 1.0, 0.0]);
    let a = DMatrix::from_row_slice(2, 2, &[1.0, 0.1, 0.0, 1.0]);
    let error = place(&a, &twice, &[Complex::new(0.5, 0.0); 2]).unwrap_err();
    assert_eq!(error, EstimatorError::PoleMultiplicity { re: 0.5, im: 0.0, multiplicity: 2, rank: 1 });
}

#[test]
fn pairs_that_are_none() {
    let (a, c) = (DMatrix::zeros(3, 3), DMatrix::zeros(2, 3));
    let poles = [Complex::new(0.5, 0.0); 3];
    for (a, c, what, expected, found) in [
        (DMatrix::zeros(3, 2), c.clone(), "columns of A", 3, 2),
        (a.clone(), DMatrix::zeros(2, 4), "columns of C", 3, 4),
    ] {
        let error = EstimatorError::Size { what, expected, found };
        assert_eq!(place(&a, &c, &poles).unwrap_err(), error);
        assert_eq!(observability_rank(&a, &c).unwrap_err(), error);
    }
    for bad in BAD {
        let mut broken = a.clone();
        broken[(1, 0)] = bad;
        let error = place(&broken, &c, &poles).unwrap_err();
        assert!(matches!(error, EstimatorError::NotFinite { what: "A", index: 1, .. }), "{error}");
        let mut broken = c.clone();
        broken[(0, 2)] = bad;
        let error = place(&a, &broken, &poles).unwrap_err();
        assert!(matches!(error, EstimatorError::NotFinite { what: "C", index: 4, .. }), "{error}");
    }
    assert_eq!(place(&a, &c, &poles).unwrap_err(), EstimatorError::NotObservable { rank: 0, states: 3 });
    let none = place(&DMatrix::zeros(0, 0), &DMatrix::zeros(0, 0), &[]).unwrap();
    assert_eq!(none.shape(), (0, 0));
}

#[test]
fn sets_that_do_not_fit() {
    let new = |initial: &Zonotope, outputs: Outputs<2>, process: &Zonotope, noise: &Zonotope| {
        InZsmf::<SE2<f64>, 3, 2, Left>::new(SE2::identity(), initial, outputs, process, noise).unwrap_err()
    };
    let (three, two, position) = (boxed(&[1.0; 3]), boxed(&[1.0; 2]), Outputs::position);
    let size = |what, expected, found| EstimatorError::Size { what, expected, found };
    assert_eq!(new(&two, position(), &three, &two), size("initial set", 3, 2));
    assert_eq!(new(&three, position(), &two, &two), size("process noise", 3, 2));
    assert_eq!(new(&three, position(), &three, &three), size("output noise", 2, 3));
    assert_eq!(new(&three, Outputs::Left(vec![]), &three, &two), size("outputs", 2, 0));
    assert_eq!(new(&three, Outputs::Right(vec![Vector2::zeros(); 2]), &three, &two), size("outputs", 2, 4));
    let off = Zonotope::from_box(&[0.0, 0.5, 0.0], &[1.0; 3]).unwrap();
    let not_centered = |what| EstimatorError::NotCentered { what, index: 1, value: 0.5 };
    assert_eq!(new(&off, position(), &three, &two), not_centered("initial set"));
    assert_eq!(new(&three, position(), &off, &two), not_centered("process noise"));
    let nan = new(&three, Outputs::Left(vec![Vector2::new(0.0, f64::NAN)]), &three, &two);
    assert!(matches!(nan, EstimatorError::NotFinite { what: "known point", index: 1, .. }));

    let model = Linear { a: Matrix3::identity(), c: SMatrix::<f64, 2, 3>::identity(), d: Matrix3::identity() };
    let new = |initial, process, noise| Zsmf::new(model.clone(), initial, process, noise).unwrap_err();
    assert_eq!(new(&two, &three, &two), size("initial set", 3, 2));
    assert_eq!(new(&three, &two, &two), size("process noise", 3, 2));
    assert_eq!(new(&three, &three, &three), size("output noise", 2, 3));
    assert_eq!(new(&three, &off, &two), not_centered("process noise"));
}

#[test]
fn estimates_that_are_not_finite() {
    for bad in BAD {
        let start = SE2::from_pose(PI, 0.0, bad);
        let error = InZsmf::<SE2<f64>, 3, 2, Left>::new(
            start,
            &boxed(&[1.0; 3]),
            Outputs::position(),
            &boxed(&[1.0; 3]),
            &boxed(&[1.0; 2]),
        )
        .unwrap_err();
        assert!(matches!(error, EstimatorError::NotFinite { what: "estimate", index: 1, .. }), "{error}");
    }
}

/// Negative radii and entries that are not finite are refused where the set is built, and convert to the filter's error.
#[test]
fn negative_radii() {
    let build = |radii: [f64; 3]| -> Result<InZsmf<SE2<f64>, 3, 2, Left>, EstimatorError> {
        let process = Zonotope::from_box(&[0.0; 3], &radii)?;
        InZsmf::new(SE2::identity(), &boxed(&[1.0; 3]), Outputs::position(), &process, &boxed(&[1.0; 2]))
    };
    let error = build([0.1, -0.1, 0.1]).unwrap_err();
    assert!(matches!(error, EstimatorError::Set(SetError::Negative { row: 1, .. })), "{error}");
    let error = build([0.1, 0.1, f64::NAN]).unwrap_err();
    assert!(matches!(error, EstimatorError::Set(SetError::NonFinite { row: 2, .. })), "{error}");
}

#[test]
fn orders_below_the_dimension() {
    let error = warm_inzsmf().with_reduction(Reduction::Girard, 2).unwrap_err();
    assert_eq!(error, EstimatorError::Set(SetError::TooFewGenerators { max_generators: 2, dim: 3 }));
    let error = vehicle_zsmf([0.0; 3], [1.0; 3]).with_reduction(Reduction::Girard, 0).unwrap_err();
    assert_eq!(error, EstimatorError::Set(SetError::TooFewGenerators { max_generators: 0, dim: 3 }));
}

/// Inputs of any finite size give a gain or a typed error, and observability does not depend on scale.
#[test]
fn huge_and_tiny_pairs_are_placed_or_refused() {
    let c = DMatrix::from_row_slice(2, 3, &[0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
    let poles = [0.95, 0.98, 0.98];
    for s in [1e-300, 1e-160, 1e100, 1e154, 1e160, 1e200, 1e300] {
        // Without scale, A and the poles scale together: so does the gain.
        let a = DMatrix::from_row_slice(3, 3, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.004, 0.08, -0.004, 1.0]);
        let gain = place(&a, &c, &poles.map(|re| Complex::new(re, 0.0))).unwrap();
        let scaled = place(&(&a * s), &c, &poles.map(|re| Complex::new(re * s, 0.0))).unwrap();
        assert!((scaled / s - &gain).norm() < 1e-9 * gain.norm(), "{s:e}");
        // One huge or tiny entry among ordinary ones: either answer is fine, a panic is not.
        let mut lopsided = a.clone();
        lopsided[(2, 0)] = s;
        let _ = place(&lopsided, &c, &poles.map(|re| Complex::new(re, 0.0)));
        let one = DMatrix::identity(1, 1);
        assert_eq!(observability_rank(&one, &(&one * s)).unwrap(), 1, "{s:e}");
    }
}

/// A step of 1e154 m with placed poles: typed error or result, and after an error the filter is as it was.
#[test]
fn a_huge_increment_does_not_panic() {
    for advance in [1e100, 1e153, 1e154, 1e160, 1e300] {
        let mut filter =
            vehicle_inzsmf([0.3, 1.0, 0.0], [0.5, 2.0, 2.0]).with_gain(Gain::real_poles([0.95, 0.98, 0.98]));
        let before = filter.bits();
        if filter.step(&Vector3::new(0.004, advance, 0.0), &[1.0, 0.0]).is_err() {
            assert_eq!(filter.bits(), before, "{advance:e}");
        }
    }
}

/// "Practically no reduction" reserves no memory for it.
#[test]
fn an_order_beyond_all_memory_is_fine() {
    for order in [1 << 40, usize::MAX] {
        let mut filter =
            vehicle_inzsmf([0.3, 1.0, 0.0], [0.5, 2.0, 2.0]).with_reduction(Reduction::Combastel, order).unwrap();
        filter.step(&increment(), &[0.0, 0.0]).unwrap();
    }
}

/// The culprit is named: a gain that is not finite, and a set so large that its covariation overflows.
#[test]
fn errors_name_the_culprit() {
    let mut fixed =
        vehicle_inzsmf([0.3, 1.0, 0.0], [0.5, 2.0, 2.0]).with_gain(Gain::Fixed(SMatrix::from_element(f64::NAN)));
    let error = fixed.step(&increment(), &[0.0, 0.0]).unwrap_err();
    assert!(matches!(error, EstimatorError::NotFinite { what: "fixed gain", .. }), "{error}");
    let huge = SMatrix::<f64, 1, 1>::new(1e300);
    let error = f_radius_gain(&huge, &huge, &huge, &huge).unwrap_err();
    assert!(matches!(error, EstimatorError::NotFinite { .. }), "{error}");
}
