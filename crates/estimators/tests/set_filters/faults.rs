//! Fault policies: what is kept, what is gone on from, and what is refused.

use estimators::{
    DZb, DZbOptions, Estimator, EstimatorError, FaultPolicy, Inflate, Method, Rcz, RczOptions, Recovery, Relation,
    SetFilter, System, Vh, VhOptions, ZonotopeFilter, ZonotopeOptions,
};
use nonlin_bounds::function;
use scalars::Interval;
use setrep::{ConstrainedZonotope, SetError, VPolytope, Zonotope, ZonotopeBundle};

use crate::plants::{Draw, attitude, attitude_run, attitude_start, cube, holds, planar, planar_run, planar_start};
use crate::support::Random;

fn some(y: &[f64]) -> Vec<Option<f64>> {
    y.iter().map(|&y| Some(y)).collect()
}

/// A filter that has converged, the measurement it is to get and the state behind that.
fn converged(random: &mut Random) -> (Rcz, Vec<f64>, Vec<Interval>) {
    let run = attitude_run(0.15, Draw::Uniform, 10, random);
    let mut filter = Rcz::new(attitude(0.15), attitude_start(), RczOptions::fast(4)).unwrap();
    for (_, y, u) in &run[..10] {
        filter.step(u, y).unwrap();
    }
    (filter, run[10].1.clone(), run[10].0.clone())
}

#[test]
fn an_outlier_is_dropped_and_the_prediction_kept() {
    let mut random = Random::new(81);
    for _ in 0..5 {
        let (mut filter, y, x) = converged(&mut random);
        let before = filter.state().clone();
        let mut wrong = some(&y);
        wrong[2] = Some(y[2] + 2.0);
        let fault = filter.update_or_recover(&wrong, &[], &FaultPolicy::KeepPrediction).unwrap().unwrap();
        assert_eq!((fault.recovery, fault.inconsistency.step), (Recovery::Dropped, 10));
        assert_eq!(filter.state(), &before);
        // Without fault a policy does nothing: the update is the plain one.
        let mut plain = filter.clone();
        plain.update(&y).unwrap();
        let policy = FaultPolicy::Reset(attitude_start());
        assert_eq!(filter.update_or_recover(&some(&y), &[], &policy).unwrap(), None);
        assert_eq!(filter.state(), plain.state());
        assert!(holds(filter.hull(), &x));
    }
}

/// After a jump of the state, a reset to a set that holds it is right, with the measurement if that agrees.
#[test]
fn a_reset_goes_on_from_the_set_given() {
    let mut random = Random::new(82);
    let run = planar_run(Draw::Uniform, 3, &mut random);
    let (x, y) = &run[3];
    let mut filter =
        Rcz::new(planar(), ConstrainedZonotope::from_box(&[50.0, 3.0], &[0.5, 0.5]).unwrap(), RczOptions::fast(2))
            .unwrap();
    let around = ConstrainedZonotope::from_box(x, &[0.5, 0.5]).unwrap();
    let mut expected = Rcz::new(planar(), around.clone(), RczOptions::fast(2)).unwrap();
    expected.update(y).unwrap();
    let fault = filter.update_or_recover(&some(y), &[], &FaultPolicy::Reset(around)).unwrap().unwrap();
    assert_eq!(fault.recovery, Recovery::Reset { measurement_used: true });
    assert_eq!(filter.state().set, expected.state().set);
    assert_eq!(filter.hull(), expected.hull());

    // A set that the measurement contradicts as well stays as it is given; the number of steps goes on.
    filter.predict(&[]).unwrap();
    let far = planar_start();
    let fault = filter.update_or_recover(&[Some(900.0), None], &[], &FaultPolicy::Reset(far.clone())).unwrap().unwrap();
    assert_eq!(fault.recovery, Recovery::Reset { measurement_used: false });
    assert_eq!((&filter.state().set, filter.step_index()), (&far, 1));
}

/// A set that misses the state by less than the box: one box is enough, and the state is in what is left.
#[test]
fn inflation_finds_back_to_the_state() {
    let mut random = Random::new(83);
    let mut faults = 0;
    for _ in 0..20 {
        let run = planar_run(Draw::Uniform, 0, &mut random);
        let (x, y) = &run[0];
        let away: Vec<f64> = x.iter().map(|x| x + 1.5 * random.sign()).collect();
        let beside = ConstrainedZonotope::from_box(&away, &[0.25, 0.25]).unwrap();
        let mut filter = Rcz::new(planar(), beside, RczOptions::fast(2)).unwrap();
        let policy = FaultPolicy::Inflate { radii: vec![1.25 + 1e-9; 2], attempts: 3 };
        if let Some(fault) = filter.update_or_recover(&some(y), &[], &policy).unwrap() {
            assert_eq!(fault.recovery, Recovery::Inflated { times: 1 });
            assert!(filter.hull().iter().zip(x).all(|(side, &x)| side.contains(x)), "{:?} {x:?}", filter.hull());
            faults += 1;
        }
    }
    println!("{faults} of 20 contradictions");
    assert!(faults > 10);

    // Sets for which the sizes can be told: the box [-1, 1]^2 misses 1.5 +- 0.1 by 0.4.
    let system = crate::linear::resting(0.1);
    let mut filter = ZonotopeFilter::new(system, cube(2, 1.0), ZonotopeOptions::zmv(6).with_rows()).unwrap();
    let before = filter.state().clone();
    let policy = |attempts| FaultPolicy::Inflate { radii: vec![0.25, 0.0], attempts };
    let fault = filter.update_or_recover(&[Some(1.5), None], &[], &policy(1)).unwrap().unwrap();
    assert_eq!(fault.recovery, Recovery::Dropped);
    assert!(fault.inconsistency.verify());
    assert_eq!(filter.state(), &before);
    let fault = filter.update_or_recover(&[Some(1.5), None], &[], &policy(2)).unwrap().unwrap();
    assert_eq!(fault.recovery, Recovery::Inflated { times: 2 });
    let hull = filter.hull();
    assert!(
        hull[0].contains(1.5) && hull[0].lo() > 1.2 && hull[1].subset_of(&Interval::ZERO.inflate(1.0 + 1e-14)),
        "{hull:?}"
    );
}

#[test]
fn invariants_have_policies_too() {
    let off = ConstrainedZonotope::from_box(&[0.0; 4], &[0.1; 4]).unwrap();
    let mut filter = Rcz::new(attitude(0.15), off, RczOptions::fast(4)).unwrap();
    let fault = filter.consistency_or_recover(&FaultPolicy::Reset(attitude_start())).unwrap().unwrap();
    assert_eq!(fault.recovery, Recovery::Reset { measurement_used: true });
    assert!(filter.hull()[1].contains(1.0));
    assert_eq!(filter.consistency_or_recover(&FaultPolicy::KeepPrediction).unwrap(), None);
}

#[test]
fn bad_policies_and_bad_input_change_nothing() {
    let mut random = Random::new(84);
    let (mut filter, y, _) = converged(&mut random);
    let before = filter.state().clone();
    let mut wrong = some(&y);
    wrong[0] = Some(9.0);
    let inflate = |radii: &[f64]| FaultPolicy::Inflate { radii: radii.to_vec(), attempts: 2 };
    let what = "radii of a fault policy";
    assert_eq!(
        filter.update_or_recover(&wrong, &[], &inflate(&[1.0; 3])),
        Err(EstimatorError::Size { what, expected: 4, found: 3 })
    );
    assert!(matches!(
        filter.update_or_recover(&wrong, &[], &inflate(&[0.0, f64::NAN, 0.0, 0.0])),
        Err(EstimatorError::NotFinite { index: 1, .. })
    ));
    assert!(matches!(
        filter.update_or_recover(&wrong, &[], &inflate(&[0.0, 0.0, -1.0, 0.0])),
        Err(EstimatorError::Set(SetError::Negative { row: 2, .. }))
    ));
    let flat = ConstrainedZonotope::from_box(&[0.0; 3], &[1.0; 3]).unwrap();
    assert!(filter.update_or_recover(&wrong, &[], &FaultPolicy::Reset(flat.clone())).is_err());
    assert!(filter.reset(flat).is_err());
    wrong[0] = Some(f64::NAN);
    assert!(matches!(
        filter.update_or_recover(&wrong, &[], &FaultPolicy::Reset(attitude_start())),
        Err(EstimatorError::NotFinite { what: "measurement", .. })
    ));
    // Radii that overflow.
    let mut wrong = some(&y);
    wrong[0] = Some(9.0);
    assert!(filter.update_or_recover(&wrong, &[], &inflate(&[f64::MAX; 4])).is_err());
    assert_eq!(filter.state(), &before);

    let mut set = Zonotope::from_box(&[0.0], &[1.0]).unwrap();
    set.inflate(&[0.5]).unwrap();
    assert!(set.interval_hull()[0].contains(1.5));
}

/// Polytopes and bundles are inflated as well: every filter has every policy.
#[test]
fn every_form_of_sets_is_inflated() {
    fn inflated<M: Method<Set: Inflate>>(mut filter: SetFilter<M>) {
        let before = filter.hull().to_vec();
        let fault = filter.update_or_recover(&[Some(2.0)], &[], &FaultPolicy::KeepPrediction).unwrap().unwrap();
        assert_eq!((fault.recovery, filter.hull()), (Recovery::Dropped, &*before));
        // Only two boxes hold a state that was measured so.
        let policy = FaultPolicy::Inflate { radii: vec![0.3, 0.1], attempts: 3 };
        let fault = filter.update_or_recover(&[Some(2.0)], &[], &policy).unwrap().unwrap();
        assert_eq!(fault.recovery, Recovery::Inflated { times: 2 });
        assert!(filter.hull()[0].contains(1.5) && filter.hull()[1].contains(1.0), "{:?}", filter.hull());
        assert!(filter.hull()[0].lo() > 1.3 && filter.hull()[0].hi() < 1.7, "{:?}", filter.hull());
    }
    let noise = || cube(1, 0.01);
    let walk = Relation::new(function!(|[x, y, w]: 3| -> 2 { [x + w, y] }));
    let seen = Relation::new(function!(|[x, y, v]: 3| -> 1 { [x + y.scale(0.5) + v] }));
    let system = || System::new(walk.clone(), noise(), seen.clone(), noise()).unwrap();
    let sides = [Interval::ZERO.inflate(1.0); 2];
    inflated(Vh::new(system(), VPolytope::from_intervals(&sides).unwrap(), VhOptions::tight()).unwrap());
    let bundle = ZonotopeBundle::new(vec![cube(2, 1.0)]).unwrap();
    inflated(DZb::new(system(), bundle, DZbOptions::new(2)).unwrap());
    inflated(Rcz::new(system(), cube(2, 1.0).into(), RczOptions::fast(2)).unwrap());
}
