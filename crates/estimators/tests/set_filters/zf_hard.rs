//! The zonotopic filter where things are degenerate: noises of width 0, sets without an interior, one state, no outputs, any scale.

use estimators::{Culprit, Estimator, EstimatorError, LinearizedZf, Relation, System, Zf, ZfOptions};
use nonlin_bounds::{Form, function};
use scalars::Interval;
use setrep::{Matrix, Membership, StripRule, Zonotope};

use crate::support::boxed;

const RULES: [StripRule; 3] = [StripRule::Volume, StripRule::Segments, StripRule::Determinant];

/// Every rule, with strips tightened and whole.
fn all_options(generators: usize) -> impl Iterator<Item = ZfOptions> {
    RULES.into_iter().flat_map(move |rule| {
        let options = ZfOptions::new(generators).with_rule(rule);
        [options, options.with_whole_strips()]
    })
}

/// `x+ = (x1 + x2 / 2, x2) + (0, w)`; `x1` is measured.
fn cart(push: f64, noise: f64) -> System {
    let rows = |rows: &[&[f64]]| Matrix::from_rows(rows).unwrap();
    let (a, b) = (rows(&[&[1.0, 0.5], &[0.0, 1.0]]), rows(&[&[0.0], &[1.0]]));
    let (c, d) = (rows(&[&[1.0, 0.0]]), Matrix::identity(1));
    System::linear(&a, &b, boxed(&[push]), &c, &d, boxed(&[noise])).unwrap()
}

fn holds(filter: &Zf, x: &[f64]) -> bool {
    let point: Vec<Interval> = x.iter().map(|&x| Interval::point(x)).collect();
    filter.hull().iter().zip(x).all(|(side, &x)| side.contains(x))
        && filter.enclosure().membership(&point).unwrap() != Membership::ProvenOutside
}

#[test]
fn outputs_that_are_no_numbers_are_refused() {
    for options in all_options(8) {
        let mut filter = Zf::new(cart(0.1, 0.1), boxed(&[1.0, 1.0]), options).unwrap();
        let before = filter.state().clone();
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(matches!(
                filter.update(&[wrong]),
                Err(EstimatorError::NotFinite { what: "measurement", index: 0, .. })
            ));
            assert!(matches!(filter.step(&[], &[wrong]), Err(EstimatorError::NotFinite { .. })));
        }
        assert!(matches!(filter.update(&[]), Err(EstimatorError::Size { .. })));
        assert!(matches!(filter.update(&[0.0, 0.0]), Err(EstimatorError::Size { .. })));
        assert_eq!(filter.state(), &before);
    }
}

/// Nothing is unknown but rounding: the exact state stays inside, what it does not fulfil is refuted with proof.
#[test]
fn a_point_without_noises_is_followed() {
    for options in all_options(4) {
        let mut filter = Zf::new(cart(0.0, 0.0), Zonotope::point(&[1.0, 0.25]).unwrap(), options).unwrap();
        for k in 1..=20 {
            filter.step(&[], &[1.0 + 0.125 * f64::from(k - 1)]).unwrap();
            assert!(holds(&filter, &[1.0 + 0.125 * f64::from(k), 0.25]), "{options:?}, step {k}: {:?}", filter.hull());
        }
        assert!(filter.hull()[0].rad() < 1e-12);
        let before = filter.state().clone();
        let Err(EstimatorError::Inconsistent(found)) = filter.update(&[4.0]) else { panic!("{options:?}") };
        assert!(found.verify() && (found.margin() - 0.5).abs() < 1e-9);
        assert_eq!(
            (found.culprits.as_slice(), filter.state()),
            (&[Culprit::Measurement(0), Culprit::Prediction][..], &before)
        );
    }
}

/// One generator: strips across it, along it, and past it.
#[test]
fn strips_meet_a_flat_set() {
    for options in all_options(6) {
        // A segment along x1: x1 is measured across it.
        let segment = Zonotope::new(&[0.0, 0.0], &Matrix::from_rows(&[&[2.0], &[0.0]]).unwrap()).unwrap();
        let mut across = Zf::new(cart(0.0, 0.5), segment, options).unwrap();
        across.update(&[1.5]).unwrap();
        assert!(holds(&across, &[1.0, 0.0]) && holds(&across, &[2.0, 0.0]));
        // A segment along x2: x1 is 0 without width.
        let segment = Zonotope::new(&[0.0, 0.0], &Matrix::from_rows(&[&[0.0], &[2.0]]).unwrap()).unwrap();
        let mut along = Zf::new(cart(0.0, 0.5), segment, options).unwrap();
        along.update(&[0.4]).unwrap();
        assert!(holds(&along, &[0.0, -2.0]) && holds(&along, &[0.0, 2.0]), "{options:?}: {:?}", along.hull());
        let before = along.state().clone();
        let Err(EstimatorError::Inconsistent(found)) = along.update(&[0.75]) else { panic!("{options:?}") };
        assert!(found.verify() && along.state() == &before);
    }
}

/// Nothing measured, and no outputs at all.
#[test]
fn updates_without_outputs_change_no_bounds() {
    let mut filter = Zf::new(cart(0.1, 0.1), boxed(&[1.0, 1.0]), ZfOptions::new(8)).unwrap();
    let hull = filter.hull().to_vec();
    filter.update_some(&[None], &[]).unwrap();
    assert_eq!(filter.hull(), hull);
    let still = function!(|[x, w]: 2| -> 1 { [x + w] });
    let blind = function!(|[_x, _v]: 2| -> 0 { [] });
    if let Ok(system) = System::new(Relation::new(still), boxed(&[0.1]), Relation::new(blind), boxed(&[0.1])) {
        let mut filter = Zf::new(system, boxed(&[1.0]), ZfOptions::new(1)).unwrap();
        for _ in 0..10 {
            filter.step(&[], &[]).unwrap();
        }
        assert!(filter.hull()[0].contains(1.99) && filter.hull()[0].rad() < 2.0 + 1e-9);
    }
}

/// One state, and units from the smallest to the largest: a result that holds the truth, or an error that says why; never a panic.
#[test]
fn one_state_at_any_scale() {
    let still = function!(|[x, w]: 2| -> 1 { [x + w] });
    let seen = function!(|[x, v]: 2| -> 1 { [x + v] });
    for unit in [1e-320, 1e-300, 1e-150, 1e-20, 1.0, 1e20, 1e150, 1e300] {
        for options in all_options(2) {
            let scaled = |size: f64| Zonotope::from_box(&[0.0], &[size * unit]).unwrap();
            let system = System::new(Relation::new(still), scaled(0.125), Relation::new(seen), scaled(0.5)).unwrap();
            let mut filter = Zf::new(system, scaled(2.0), options).unwrap();
            for k in 0..6 {
                let before = filter.state().clone();
                match filter.step(&[], &[unit]) {
                    Ok(()) => assert!(holds(&filter, &[unit]), "{unit:e}, {options:?}, step {k}: {:?}", filter.hull()),
                    Err(error) => {
                        assert!(!(1e-140..1e140).contains(&unit), "{unit:e}, {options:?}: {error}");
                        assert_eq!(filter.state(), &before);
                    }
                }
            }
            // Least segments go by squares, which have to be numbers.
            if (1e-140..1e140).contains(&unit) && options.tighten {
                assert!(filter.hull()[0].rad() < unit, "{unit:e}, {options:?}: {:?}", filter.hull());
            }
        }
    }
}

/// Outputs that are not measured may be anything: without derivative, without bounds, defined nowhere. Who has no value is named.
#[test]
fn only_outputs_that_are_measured_have_to_be_enclosed() {
    let still = function!(|[x, y, w]: 3| -> 2 { [x + w, y] });
    // A root over a box that holds 0, a pole, a logarithm of what is negative, and x itself.
    let seen = function!(|[x, y, v]: 3| -> 4 { [y.sqrt() + v, y.recip() + v, (y - S::from_f64(3.0)).ln() + v, x + v] });
    let system = || System::new(Relation::new(still), boxed(&[0.1]), Relation::new(seen), boxed(&[0.1])).unwrap();
    let start = Zonotope::from_box(&[0.0, 1.0], &[1.0, 1.0]).unwrap();
    for strips in [Form::Natural, Form::MeanValue, Form::Taylor] {
        let options = ZfOptions { strips, ..ZfOptions::new(8) };
        let mut filter = Zf::new(system(), start.clone(), options).unwrap();
        filter.update_some(&[None, None, None, Some(0.5)], &[]).unwrap();
        let cut = filter.hull()[0].rad() < 0.5 || strips == Form::Natural;
        assert!(holds(&filter, &[0.5, 1.0]) && cut, "{strips:?}: {:?}", filter.hull());
        // Measured, they go by their ranges: sqrt(y) up to 1/2, a pole that says nothing.
        filter.update_some(&[Some(0.25), Some(9.0), None, None], &[]).unwrap();
        assert!(holds(&filter, &[0.5, 0.111]), "{strips:?}: {:?}", filter.hull());
        let before = filter.state().clone();
        let Err(EstimatorError::Inconsistent(found)) = filter.update_some(&[None, None, Some(0.0), Some(0.5)], &[])
        else {
            panic!("{strips:?}")
        };
        assert_eq!(found.culprits, [Culprit::Measurement(2), Culprit::Prediction]);
        assert!(found.verify_with(filter.system()));
        assert_eq!(filter.state(), &before);
    }
}

/// The linearised filter promises nothing, but it does not fall over either.
#[test]
fn the_linearised_filter_stays_upright() {
    let motion = function!(|[x, y, w]: 3| -> 2 { [x / y + w, y] });
    let sensor = function!(|[x, y, v]: 3| -> 1 { [(x.sqr() + y.sqr()).sqrt() + v] });
    let system = System::new(Relation::new(motion), boxed(&[0.1]), Relation::new(sensor), boxed(&[0.0])).unwrap();
    for options in all_options(8) {
        // Center at the pole of both functions' derivatives.
        let mut filter = LinearizedZf::new(system.clone(), boxed(&[1.0, 1.0]), options).unwrap();
        let before = filter.state().clone();
        assert!(matches!(filter.update(&[1.0]), Err(EstimatorError::Bound(_))));
        assert!(matches!(filter.predict(&[]), Err(EstimatorError::Bound(_))));
        assert_eq!(filter.state(), &before);
        let mut filter =
            LinearizedZf::new(system.clone(), Zonotope::from_box(&[3.0, 4.0], &[1.0, 1.0]).unwrap(), options).unwrap();
        filter.update(&[5.0]).unwrap();
        match filter.update(&[50.0]) {
            Ok(()) => assert!(!options.tighten),
            Err(EstimatorError::Inconsistent(found)) => assert!(options.tighten && !found.verify()),
            Err(error) => panic!("{error}"),
        }
    }
}
