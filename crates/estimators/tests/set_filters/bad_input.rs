//! What `Rcz` refuses, and what it makes of options and sets at the edge of sense; a filter that refuses is as it was.

use estimators::{Culprit, Estimator, EstimatorError, FilterState, Rcz, RczOptions, Relation, System, Tier};
use nonlin_bounds::{BoundError, DynFunction, Function, Jet, Order, Smoothness};
use scalars::{Interval, Scalar};
use setrep::{ConstrainedZonotope, Matrix, TemplateWidths, Zonotope};

use crate::plants::{
    AttitudeOutput, Draw, PlanarOutput, PlanarStep, attitude, attitude_run, attitude_start, cube, planar, planar_run,
    planar_start, radius, value,
};
use crate::support::Random;

fn rcz() -> Rcz {
    Rcz::new(attitude(0.15), attitude_start(), RczOptions::fast(4)).unwrap()
}

/// Every call with a number that is none or a wrong length is refused by name, and changes nothing.
#[test]
fn wrong_lengths_and_numbers_are_named_and_change_nothing() {
    let mut filter = rcz();
    let y = value(&AttitudeOutput, &[0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], &[]);
    filter.step(&[0.0; 3], &y).unwrap();
    let before = filter.state().clone();
    for (index, bad) in [(0, f64::NAN), (3, f64::INFINITY), (5, f64::NEG_INFINITY)] {
        let mut wrong = y.clone();
        wrong[index] = bad;
        let refused = |error: EstimatorError| match error {
            EstimatorError::NotFinite { what: "measurement", index: found, value } => {
                found == index && (value == bad || bad.is_nan())
            }
            _ => false,
        };
        assert!(refused(filter.update(&wrong).unwrap_err()));
        assert!(refused(filter.step(&[0.0; 3], &wrong).unwrap_err()));
        let some: Vec<Option<f64>> = wrong.into_iter().map(Some).collect();
        assert!(refused(filter.update_some(&some, &[]).unwrap_err()));
        let mut input = [0.0; 3];
        input[index % 3] = bad;
        let error = filter.predict(&input).unwrap_err();
        assert!(matches!(error, EstimatorError::NotFinite { what: "input", .. }), "{error}");
        // The measurement is good, the input is not: the whole step is undone.
        assert!(filter.step(&input, &y).is_err());
        assert_eq!(filter.state(), &before);
    }
    let size = |error: EstimatorError, name: &str, sizes: (usize, usize)| match error {
        EstimatorError::Size { what, expected, found } => (what, (expected, found)) == (name, sizes),
        _ => false,
    };
    assert!(size(filter.update(&y[..5]).unwrap_err(), "measurement", (6, 5)));
    assert!(size(filter.update_some(&[None; 7], &[]).unwrap_err(), "measurement", (6, 7)));
    assert!(size(filter.update_some(&[None; 6], &[1.0]).unwrap_err(), "parameters of the measurement", (0, 1)));
    assert!(size(filter.predict(&[0.0; 2]).unwrap_err(), "input", (3, 2)));
    assert!(size(filter.step(&[], &y).unwrap_err(), "input", (3, 0)));
    assert_eq!(filter.state(), &before);
    filter.step(&[0.0; 3], &y).unwrap();
}

/// Saved states that do not fit are refused.
#[test]
fn states_that_do_not_fit_are_refused() {
    let mut filter = rcz();
    let before = filter.state().clone();
    let plane = Rcz::new(planar(), planar_start(), RczOptions::fast(2)).unwrap();
    assert!(matches!(filter.restore(plane.state()), Err(EstimatorError::Size { what: "saved set", .. })));
    let with_side = |side: Interval| {
        let mut state: FilterState<_, _> = before.clone();
        state.hull[2] = side;
        state
    };
    let error = filter.restore(&with_side(Interval::EMPTY)).unwrap_err();
    assert_eq!(error, EstimatorError::EmptyRange { what: "saved hull", index: 2 });
    let error = filter.restore(&with_side(Interval::ENTIRE)).unwrap_err();
    assert!(matches!(error, EstimatorError::NotFinite { what: "saved hull", index: 2, .. }));
    let mut short = before.clone();
    short.hull.pop();
    assert!(matches!(filter.restore(&short), Err(EstimatorError::Size { what: "saved hull", .. })));
    assert_eq!(filter.state(), &before);
    let wrong = Rcz::new(attitude(0.15), planar_start(), RczOptions::fast(4)).unwrap_err();
    assert_eq!(wrong, EstimatorError::Size { what: "initial set", expected: 4, found: 2 });
}

/// A first set that the invariant excludes is a proven contradiction, of an update and of the invariant alone.
#[test]
fn a_first_set_outside_the_invariant_is_a_contradiction() {
    let far = Zonotope::new(&[0.0, 2.0, 0.0, 0.0], &Matrix::from_diagonal(&[0.18; 4])).unwrap();
    for tier in [Tier::LinearPrograms, Tier::Rescaling] {
        let options = RczOptions { tier, ..RczOptions::fast(4) };
        let mut filter = Rcz::new(attitude(0.15), far.clone().into(), options).unwrap();
        let before = filter.state().clone();
        let Err(EstimatorError::Inconsistent(proof)) = filter.consistency() else { panic!("no contradiction") };
        assert_eq!(proof.culprits, [Culprit::Invariant(0), Culprit::Prediction]);
        let y = value(&AttitudeOutput, &[0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], &[]);
        let Err(EstimatorError::Inconsistent(proof)) = filter.update(&y) else { panic!("no contradiction") };
        assert!(proof.culprits.contains(&Culprit::Invariant(0)), "{proof}");
        assert_eq!(filter.state(), &before);
    }
}

/// Budgets of nothing still give enclosures; sizes and the number of passes keep to them.
#[test]
fn budgets_of_nothing_still_enclose() {
    let mut random = Random::new(91);
    let run = attitude_run(0.15, Draw::Uniform, 20, &mut random);
    let planar_run = planar_run(Draw::Uniform, 20, &mut random);
    for tier in [Tier::LinearPrograms, Tier::Rescaling] {
        for widths in [TemplateWidths::SingleRows, TemplateWidths::LinearPrograms] {
            let zero = RczOptions {
                constraints: 0,
                passes: 0,
                reduce_every: 0,
                least_shrink: 0.0,
                widths,
                tier,
                ..RczOptions::fast(4)
            };
            for options in [
                zero,
                RczOptions { constraints: 0, ..RczOptions::fast(4) },
                RczOptions { passes: 0, tier, ..RczOptions::fast(4) },
                RczOptions { reduce_every: 0, tier, ..RczOptions::fast(4) },
                RczOptions { least_shrink: f64::NAN, passes: 50, ..RczOptions::fast(4) },
                RczOptions { constraints: 1000, reduce_every: 3, ..zero },
            ] {
                let mut filter = Rcz::new(attitude(0.15), attitude_start(), options).unwrap();
                for (x, y, u) in &run {
                    filter.update(y).unwrap();
                    assert!(
                        filter.hull().iter().zip(x).all(|(side, &x)| side.inflate(1e-12).contains(x)),
                        "{options:?}"
                    );
                    filter.predict(u).unwrap();
                }
                assert!(radius(filter.hull()) < 1.0, "{options:?}");
                let mut filter = Rcz::new(planar(), planar_start(), options).unwrap();
                for (x, y) in &planar_run {
                    filter.update(y).unwrap();
                    assert!(
                        filter.hull().iter().zip(x).all(|(side, &x)| side.inflate(1e-12).contains(x)),
                        "{options:?}"
                    );
                    filter.reduce().unwrap();
                    if options.tier == Tier::LinearPrograms {
                        assert!(filter.enclosure().num_constraints() <= options.constraints, "{options:?}");
                        assert!(filter.enclosure().num_generators() <= 2, "{options:?}");
                    }
                    filter.predict(&[]).unwrap();
                }
            }
        }
    }
}

/// Dynamics whose values leave the finite numbers: an error, not a set, and the filter can go on with other dynamics.
#[test]
fn dynamics_without_bounds_are_an_error() {
    struct Pole;
    impl Function for Pole {
        const VARIABLES: Option<usize> = Some(4);
        fn outputs(&self) -> usize {
            2
        }
        fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
            y[0] = x[2] / x[0];
            y[1] = x[1] + x[3];
        }
    }
    let start = ConstrainedZonotope::from_box(&[0.0; 2], &[1.0; 2]).unwrap();
    let system = |step| System::new(step, cube(2, 0.1), Relation::new(PlanarOutput), cube(2, 0.4)).unwrap();
    let mut filter = Rcz::new(system(Relation::new(Pole)), start, RczOptions::fast(2)).unwrap();
    let before = filter.state().clone();
    assert!(filter.predict(&[]).is_err());
    assert!(filter.step(&[], &[0.0, 0.0]).is_err());
    assert_eq!(filter.state(), &before);
    filter.system_mut().set_dynamics(Relation::new(PlanarStep), cube(2, 0.1)).unwrap();
    filter.predict(&[]).unwrap();
}

/// Functions by hand: bounds of values and Jacobians are enough; what they say wrong is found.
#[test]
fn hand_written_models_need_no_hessian() {
    /// `x^2 / 4 + w` in one dimension, by hand.
    struct Quarter;
    impl DynFunction for Quarter {
        fn variables(&self) -> usize {
            2
        }
        fn parameters(&self) -> usize {
            0
        }
        fn outputs(&self) -> usize {
            1
        }
        fn value(&self, x: &[f64], _: &[f64], y: &mut [f64]) -> Result<(), BoundError> {
            y[0] = 0.25 * x[0] * x[0] + x[1];
            Ok(())
        }
        fn enclose(&self, order: Order, x: &[Interval], _: &[Interval], jet: &mut Jet) -> Result<(), BoundError> {
            if order == Order::Hessian {
                return Err(BoundError::OrderNotAvailable { order: 2 });
            }
            jet.reset(order, 2, 1);
            let (values, jacobian, _, smoothness) = jet.parts_mut();
            values[0] = x[0].sqr().scale(0.25) + x[1];
            if order == Order::Jacobian {
                jacobian.copy_from_slice(&[x[0].scale(0.5), Interval::ONE]);
            }
            smoothness[0] = Smoothness::C1;
            Ok(())
        }
    }
    let noise = cube(1, 0.01);
    let relation = || Relation::from_bounds(Quarter);
    let system = System::new(relation(), noise.clone(), relation(), noise).unwrap();
    let start = ConstrainedZonotope::from_box(&[1.0], &[0.5]).unwrap();
    let mut filter = Rcz::new(system, start, RczOptions::fast(1)).unwrap();
    let mut x = 1.2_f64;
    for _ in 0..10 {
        filter.step(&[], &[0.25 * x * x]).unwrap();
        x = 0.25 * x * x;
        assert!(filter.hull()[0].contains(x) && filter.hull()[0].rad() < 0.2);
    }
}
