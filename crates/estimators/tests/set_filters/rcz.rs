//! `Rcz`: containment with uniform and vertex noise, radii against the best that is possible, proofs of faults.

use estimators::{Estimator, EstimatorError, Guarantee, Rcz, RczOptions, Tier};
use setrep::Membership;

use crate::plants::{Draw, attitude, attitude_run, attitude_start, planar, planar_run, planar_start, radius};
use crate::support::{Random, cases};

/// The state lies in the hull, and is not proven to lie outside the set.
fn check(filter: &Rcz, x: &[f64], what: &str) {
    let point: Vec<_> = x.iter().map(|&x| scalars::Interval::point(x).inflate(1e-12)).collect();
    assert!(filter.hull().iter().zip(&point).all(|(side, x)| !side.disjoint(x)), "{what}: {:?} {x:?}", filter.hull());
    let member = filter.enclosure().membership(&point, &mut setrep::Workspace::new()).expect("well-formed");
    assert_ne!(member, Membership::ProvenOutside, "{what}");
}

/// Mean radius over the steps of example 5.1.
fn planar_radius(options: RczOptions, draw: Draw, random: &mut Random) -> f64 {
    let mut filter = Rcz::new(planar(), planar_start(), options).expect("well-formed");
    let run = planar_run(draw, 10, random);
    let mut sum = 0.0;
    for (k, (x, y)) in run.iter().enumerate() {
        if k > 0 {
            filter.predict(&[]).expect("well-formed");
        }
        filter.update(y).expect("well-formed");
        check(&filter, x, "planar");
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
    let mut filter = Rcz::new(attitude(noise), attitude_start(), options).expect("well-formed");
    assert_eq!(filter.guarantee(), Guarantee::Rigorous);
    let run = attitude_run(noise, draw, steps, random);
    let mut radii = Vec::new();
    for (k, (x, y, _)) in run.iter().enumerate() {
        if k > 0 {
            filter.predict(&run[k - 1].2).expect("well-formed");
        }
        filter.update(y).expect("well-formed");
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
        let mut filter = Rcz::new(attitude(0.15), attitude_start(), RczOptions::fast(4)).expect("well-formed");
        let run = attitude_run(0.15, Draw::Uniform, 12, &mut random);
        for (k, (_, y, _)) in run.iter().enumerate() {
            if k > 0 {
                filter.predict(&run[k - 1].2).expect("well-formed");
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
                    filter.restore(&before).expect("well-formed");
                }
            }
            filter.update(y).expect("well-formed");
        }
    }
    println!("{proven} of {total} outliers proven");
    assert!(proven * 20 >= total * 19);
}
