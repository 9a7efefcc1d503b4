//! `Rcz`: containment with uniform and vertex noise, radii against the best that is possible, proofs of faults.

use estimators::{Culprit, Estimator, EstimatorError, Guarantee, Rcz, RczOptions, Relation, System, Tier};
use nonlin_bounds::{Function, function};
use scalars::{Interval, Scalar};
use setrep::{ConstrainedZonotope, Membership, Zonotope};

use crate::plants::{
    Draw, PlanarStep, attitude, attitude_run, attitude_start, cube, exactly, holds, planar, planar_run, planar_start,
    radius,
};
use crate::support::{Random, cases};

/// The state lies in the hull, and is not proven to lie outside the set.
fn check(filter: &Rcz, x: &[Interval], what: &str) {
    assert!(holds(filter.hull(), x), "{what}: {:?} {x:?}", filter.hull());
    let member = filter.enclosure().membership(x, &mut setrep::Workspace::new()).unwrap();
    assert_ne!(member, Membership::ProvenOutside, "{what}");
}

/// Mean radius over the steps of example 5.1.
fn planar_radius(options: RczOptions, draw: Draw, random: &mut Random) -> f64 {
    let mut filter = Rcz::new(planar(), planar_start(), options).unwrap();
    let run = planar_run(draw, 10, random);
    let mut sum = 0.0;
    for (k, (x, y)) in run.iter().enumerate() {
        if k > 0 {
            filter.predict(&[]).unwrap();
        }
        filter.update(y).unwrap();
        check(&filter, &exactly(x), "planar");
        sum += radius(filter.hull());
    }
    sum / run.len() as f64
}

#[test]
fn planar_example_is_as_tight_as_the_linearised_optimum() {
    let mut random = Random::new(51);
    let radii: Vec<f64> = (0..6).map(|_| planar_radius(RczOptions::fast(2), Draw::Uniform, &mut random)).collect();
    let mean = radii.iter().sum::<f64>() / 6.0;
    println!("mean radius {mean:.4}, runs {radii:.3?}");
    // The notes' prototype reached .3952, the linearised optimum over the whole history .3932; bar .415.
    assert!(mean <= 0.415, "{mean}");
    assert!(radii.iter().all(|&r| r <= 0.45), "{radii:?}");
    assert!(mean >= 0.36, "below what any filter can know: {mean}");
}

/// Radii of the hulls of example 5.2.
fn attitude_radii(noise: f64, draw: Draw, steps: usize, options: RczOptions, random: &mut Random) -> Vec<f64> {
    let mut filter = Rcz::new(attitude(noise), attitude_start(), options).unwrap();
    assert_eq!(filter.guarantee(), Guarantee::Rigorous);
    let run = attitude_run(noise, draw, steps, random);
    let mut radii = Vec::new();
    for (k, (x, y, _)) in run.iter().enumerate() {
        if k > 0 {
            filter.predict(&run[k - 1].2).unwrap();
        }
        filter.update(y).unwrap();
        check(&filter, x, "attitude");
        radii.push(radius(filter.hull()));
    }
    radii
}

#[test]
fn attitude_example_converges_in_every_run() {
    let mut random = Random::new(52);
    let runs: Vec<Vec<f64>> =
        (0..30 * cases(1)).map(|_| attitude_radii(0.15, Draw::Uniform, 40, RczOptions::fast(4), &mut random)).collect();
    let mean = |k: usize| runs.iter().map(|run| run[k]).sum::<f64>() / runs.len() as f64;
    let average = (0..41).map(mean).sum::<f64>() / 41.0;
    let worst = runs.iter().map(|run| run[20]).fold(0.0, f64::max);
    println!(
        "average {average:.4}, k=0 {:.4}, k=10 {:.4}, k=20 {:.4}, k=40 {:.4}, worst at 20 {worst:.4}",
        mean(0),
        mean(10),
        mean(20),
        mean(40)
    );
    assert!(average <= 0.0245, "{average}");
    assert!(mean(40) <= 0.018, "{}", mean(40));
    assert!(worst <= 0.035, "{worst}");
}

#[test]
fn noise_at_its_bounds_is_never_a_contradiction() {
    let mut random = Random::new(53);
    for run in 0..20 * cases(1) {
        let tier = if run % 4 == 3 { Tier::Rescaling } else { Tier::LinearPrograms };
        let options = |n| RczOptions { tier, ..RczOptions::fast(n) };
        planar_radius(options(2), Draw::Vertex, &mut random);
        attitude_radii(0.15, Draw::Vertex, 40, options(4), &mut random);
    }
}

#[test]
fn an_outlier_is_a_proven_contradiction_and_leaves_the_filter_as_it_was() {
    let mut random = Random::new(54);
    let (mut proven, mut total) = (0, 0);
    for _ in 0..10 {
        let mut filter = Rcz::new(attitude(0.15), attitude_start(), RczOptions::fast(4)).unwrap();
        let run = attitude_run(0.15, Draw::Uniform, 12, &mut random);
        for (k, (_, y, _)) in run.iter().enumerate() {
            if k > 0 {
                filter.predict(&run[k - 1].2).unwrap();
            }
            let mut wrong = y.clone();
            let i = random.below(6);
            wrong[i] += 5.0 * 0.15 * random.sign();
            if k > 3 {
                total += 1;
                let before = filter.state().clone();
                if let Err(error) = filter.update(&wrong) {
                    let EstimatorError::Inconsistent(proof) = error else { panic!("{error}") };
                    assert!(proof.verify() || proof.margin() == 0.0, "{proof}");
                    assert!(!proof.culprits.is_empty());
                    assert_eq!(filter.state(), &before);
                    proven += 1;
                } else {
                    filter.restore(&before).unwrap();
                }
            }
            filter.update(y).unwrap();
        }
    }
    println!("{proven} of {total} outliers proven");
    assert!(proven * 20 >= total * 19);
}

/// The square root of the first of two states, with noise: variables `(x, v)`.
struct Root;

impl Function for Root {
    const VARIABLES: Option<usize> = Some(3);
    fn outputs(&self) -> usize {
        1
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0].sqrt() + x[2];
    }
}

/// A measurement that is defined nowhere in the set refutes it: with a tape and without one.
#[test]
fn a_measurement_of_what_is_undefined_is_a_contradiction() {
    let start = || ConstrainedZonotope::from_box(&[-1.5, 0.0], &[0.5, 1.0]).unwrap();
    for relation in [Relation::new(Root), Relation::from_bounds(Root)] {
        let system = System::new(Relation::new(PlanarStep), cube(2, 0.1), relation, cube(1, 0.1)).unwrap();
        let mut filter = Rcz::new(system, start(), RczOptions::fast(2)).unwrap();
        let before = filter.state().clone();
        let Err(EstimatorError::Inconsistent(proof)) = filter.update(&[1.0]) else { panic!("no contradiction") };
        assert_eq!(proof.culprits, [Culprit::Measurement(0), Culprit::Prediction]);
        assert!(proof.verify_with(filter.system()));
        assert_eq!(filter.state(), &before);
    }
}

/// An empty first set is refused, missing outputs are no constraints, and many updates do not grow the set without bound.
#[test]
fn bad_starts_missing_outputs_and_many_updates() {
    let mut empty = ConstrainedZonotope::from_box(&[0.0; 2], &[1.0; 2]).unwrap();
    empty.intersect_half_space(&[1.0, 1.0], -3.0, &mut setrep::Workspace::new()).unwrap();
    assert!(matches!(Rcz::new(planar(), empty, RczOptions::fast(2)), Err(EstimatorError::Set(_))));

    let mut random = Random::new(55);
    for tier in [Tier::LinearPrograms, Tier::Rescaling] {
        let options = RczOptions { tier, ..RczOptions::fast(2) };
        let mut filter = Rcz::new(planar(), planar_start(), options).unwrap();
        let hull: Vec<Interval> = filter.hull().to_vec();
        filter.update_some(&[None, None], &[]).unwrap();
        assert!(
            filter.hull().iter().zip(&hull).all(|(new, old)| new.subset_of(old) && new.width() > 0.999 * old.width())
        );
        let run = planar_run(Draw::Uniform, 0, &mut random);
        let (x, y) = &run[0];
        for k in 0..50 {
            filter.update_some(&[Some(y[0]), (k % 2 == 0).then_some(y[1])], &[]).unwrap();
            check(&filter, &exactly(x), "the same measurement again and again");
            assert!(filter.enclosure().num_constraints() <= 3 + 4 * 2, "{}", filter.enclosure().num_constraints());
        }
    }
}

/// Steady state allocates nothing: predictions, updates and reductions of a warm filter.
#[test]
fn a_step_in_steady_state_allocates_nothing() {
    let mut random = Random::new(56);
    for options in [RczOptions::fast(4), RczOptions::slow(4), RczOptions::cheap(4)] {
        let run = attitude_run(0.15, Draw::Uniform, 60, &mut random);
        let mut filter = Rcz::new(attitude(0.15), attitude_start(), options).unwrap();
        let step = |filter: &mut Rcz, k: usize| {
            filter.update(&run[k].1).unwrap();
            filter.predict(&run[k].2).unwrap();
        };
        // The same run again and again: sets change places, so each buffer has to have been the largest once.
        let start = filter.state().clone();
        for _ in 0..6 {
            (0..60).for_each(|k| step(&mut filter, k));
            filter.restore(&start).unwrap();
        }
        let info = allocation_counter::measure(|| (0..60).for_each(|k| step(&mut filter, k)));
        assert_eq!(info.count_total, 0, "{:?}", options.tier);
    }
}

/// A sensor that sees nothing need not be defined where the state is.
#[test]
fn a_missing_measurement_may_be_undefined() {
    let still = function!(|[x, w]: 2| -> 1 { [x + w] });
    let sees = function!(|[x, e, d]: 3| -> 2 { [x + e, x.sqrt() + d] });
    let (wind, error) = (Zonotope::from_box(&[0.0], &[0.01]), Zonotope::from_box(&[0.0; 2], &[0.1; 2]));
    let system = System::new(Relation::new(still), wind.unwrap(), Relation::new(sees), error.unwrap()).unwrap();
    for options in [RczOptions::fast(1), RczOptions::cheap(1), RczOptions::slow(1)] {
        let start = ConstrainedZonotope::from_box(&[-1.5], &[0.5]).unwrap();
        let mut filter = Rcz::new(system.clone(), start, options).unwrap();
        filter.update_some(&[Some(-1.5), None], &[]).unwrap();
        assert!(filter.hull()[0].subset_of(&Interval::new(-1.6 - 1e-12, -1.4 + 1e-12).unwrap()), "{:?}", filter.hull());
        filter.update_some(&[None, None], &[]).unwrap();
        let before = filter.state().clone();
        let error = filter.update_some(&[None, Some(1.0)], &[]).unwrap_err();
        let EstimatorError::Inconsistent(contradiction) = error else { panic!("{error}") };
        assert!(contradiction.verify_with(&system), "{contradiction:?}");
        assert_eq!(filter.state(), &before);
    }
}
