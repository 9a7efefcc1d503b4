//! `CzFilter`: radii of paper 003's examples, containment with uniform noise and noise at its bounds, options, proofs of faults.

use estimators::{
    Culprit, CzFilter, CzOptions, Estimator, EstimatorError, Evidence, Guarantee, Inclusion, Phase, Rcz, RczOptions,
    Relation, System,
};
use nonlin_bounds::{Copies, function};
use scalars::Interval;
use setrep::{Complexity, ConstrainedZonotope, Matrix, Membership, SetError, Strip, Workspace, Zonotope};

use crate::plants::{
    Draw, PlanarOutput, PlanarStep, attitude, attitude_run, attitude_start, cube, exactly, holds, planar, planar_run,
    planar_start, radius,
};
use crate::support::{Random, cases};

const PLANAR: Option<Complexity> = Some(Complexity { generators: 8, constraints: 3 });
const ATTITUDE: Option<Complexity> = Some(Complexity { generators: 12, constraints: 5 });

/// `|x_i| <= 1` for four states.
fn unit_strips() -> Vec<Strip> {
    let side = Interval::new(-1.0, 1.0).unwrap();
    (0..4).map(|i| Strip::new(Matrix::identity(4).col(i), side).unwrap()).collect()
}

/// The state lies in the hull, and is not proven to lie outside the set.
fn check(filter: &CzFilter, x: &[Interval], what: &str) {
    assert!(holds(filter.hull(), x), "{what}: {:?} {x:?}", filter.hull());
    let member = filter.enclosure().membership(x, &mut Workspace::new()).unwrap();
    assert_ne!(member, Membership::ProvenOutside, "{what}");
}

/// Radii of the hulls of example 5.1, after checks at every step.
fn planar_radii(options: &CzOptions, draw: Draw, random: &mut Random) -> Vec<f64> {
    let mut filter = CzFilter::new(planar(), planar_start(), options.clone()).unwrap();
    assert_eq!(filter.guarantee(), Guarantee::Rigorous);
    let mut radii = Vec::new();
    for (k, (x, y)) in planar_run(draw, 10, random).iter().enumerate() {
        if k > 0 {
            filter.predict(&[]).unwrap();
            check(&filter, &exactly(x), "planar prediction");
        }
        filter.update(y).unwrap();
        check(&filter, &exactly(x), "planar");
        radii.push(radius(filter.hull()));
    }
    radii
}

/// Radii of the hulls of example 5.2, after checks at every step.
fn attitude_radii(noise: f64, draw: Draw, steps: usize, options: &CzOptions, random: &mut Random) -> Vec<f64> {
    let mut filter = CzFilter::new(attitude(noise), attitude_start(), options.clone()).unwrap();
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

fn mean(values: impl IntoIterator<Item = f64>) -> f64 {
    let (sum, count) = values.into_iter().fold((0.0, 0.0), |(sum, count), x| (sum + x, count + 1.0));
    sum / count
}

/// Both filters on example 5.1 within the bands that a reference computation of the paper gives.
#[test]
fn planar_example_has_the_radii_of_the_paper() {
    for (name, options, first, late) in [
        ("CZMV", CzOptions::czmv(PLANAR), 0.84..0.91, 0.42..0.506),
        ("CZFO", CzOptions::czfo(PLANAR), 0.66..0.70, 0.40..0.506),
    ] {
        let runs: Vec<Vec<f64>> =
            (0..10).map(|seed| planar_radii(&options, Draw::Uniform, &mut Random::new(seed))).collect();
        let at = |k: usize| mean(runs.iter().map(|run| run[k]));
        println!("{name}: {:.3?}", (0..11).map(at).collect::<Vec<_>>());
        assert!(first.contains(&at(0)), "{name}: {}", at(0));
        for k in 2..11 {
            assert!(late.contains(&at(k)), "{name}: {} at {k}", at(k));
            assert!(runs.iter().all(|run| run[k] < 0.67), "{name} at {k}");
        }
    }
}

/// CZMV+FC converges in example 5.2 for most courses of the noise, and the invariant makes CZFO tighter, as in Table 3; `Rcz` is tighter still.
#[test]
fn attitude_example_has_the_ratios_of_the_paper() {
    let with_strips = CzOptions::czmv(ATTITUDE).with_consistency().with_feasible(unit_strips());
    let at_16: Vec<f64> =
        (0..8).map(|seed| attitude_radii(0.15, Draw::Uniform, 16, &with_strips, &mut Random::new(seed))[16]).collect();
    println!("CZMV+FC at 16: {at_16:.3?}");
    assert!(at_16.iter().filter(|&&r| r < 0.14).count() >= 6, "{at_16:?}");

    let plain = CzOptions::czfo(ATTITUDE);
    let (mut ratios, mut ratios_of_rcz) = (Vec::new(), Vec::new());
    for seed in 0..3 {
        let run = |options| attitude_radii(0.15, Draw::Uniform, 40, options, &mut Random::new(seed));
        let (with, without) = (run(&plain.clone().with_consistency()), run(&plain));
        ratios.push(mean(with.iter().zip(&without).map(|(with, without)| with / without)));

        let mut filter = Rcz::new(attitude(0.15), attitude_start(), RczOptions::fast(4)).unwrap();
        let samples = attitude_run(0.15, Draw::Uniform, 40, &mut Random::new(seed));
        ratios_of_rcz.push(mean(samples.iter().zip(&with).map(|((_, y, u), with)| {
            filter.update(y).unwrap();
            let ratio = radius(filter.hull()) / with;
            filter.predict(u).unwrap();
            ratio
        })));
    }
    println!("Rcz / CZFO+C: {ratios_of_rcz:.3?}");
    assert!(mean(ratios_of_rcz.iter().copied()) <= 0.86, "{ratios_of_rcz:?}");
    println!("CZFO+C / CZFO: {ratios:.3?}");
    assert!((0.3..0.85).contains(&mean(ratios.iter().copied())), "{ratios:?}");
}

/// Uniform noise, and noise at its bounds, random or constant: the state stays in every set, and none is called empty.
#[test]
fn noise_at_its_bounds_is_never_a_contradiction() {
    let mut random = Random::new(71);
    for run in 0..20 * cases(1) {
        let draw = [Draw::Vertex, Draw::Constant][run % 2];
        for options in [CzOptions::czmv(PLANAR), CzOptions::czfo(PLANAR)] {
            planar_radii(&options, draw, &mut random);
        }
        let mut options = if run % 10 == 9 { CzOptions::czfo(ATTITUDE) } else { CzOptions::czmv(ATTITUDE) };
        options.consistency = run % 4 < 2;
        if run % 3 == 0 {
            options = options.with_feasible(unit_strips());
        }
        attitude_radii(0.15, draw, if run % 10 == 9 { 8 } else { 20 }, &options, &mut random);
    }
}

/// Every option on its own still contains the state; those that can only tighten the first step do.
#[test]
fn options_change_tightness_only() {
    let base = CzOptions::czmv(PLANAR);
    let same_noise = |options: &CzOptions| planar_radii(options, Draw::Uniform, &mut Random::new(72));
    let radii = same_noise(&base);
    let by_hull = same_noise(&CzOptions { inclusion: Inclusion::Hull, ..base.clone() });
    assert!(by_hull[1] <= radii[1] * (1.0 + 1e-9));
    let unlimited = CzOptions::czmv(None);
    let mut filter = CzFilter::new(planar(), planar_start(), unlimited).unwrap();
    for (k, (x, y)) in planar_run(Draw::Uniform, 5, &mut Random::new(72)).iter().enumerate() {
        if k > 0 {
            filter.predict(&[]).unwrap();
        }
        filter.update(y).unwrap();
        check(&filter, &exactly(x), "unlimited");
        assert!(radius(filter.hull()) <= radii[k] * (1.0 + 1e-6));
    }
    assert_eq!(filter.enclosure().num_constraints(), 12);
    let shared = CzOptions::czfo(PLANAR);
    for options in [
        CzOptions { copies: Copies::Separate, ..shared.clone() },
        CzOptions { keep_hull: true, ..shared.clone() },
        CzOptions { keep_hull: true, ..base },
        shared,
    ] {
        assert!(same_noise(&options)[10] < 0.6);
    }
}

/// The phases of a step, in order.
#[test]
fn phases_are_reported_at_their_end() {
    let mut phases = Vec::new();
    let options = CzOptions::czfo(ATTITUDE).with_consistency();
    let mut filter = CzFilter::new(attitude(0.15), attitude_start(), options).unwrap();
    let (_, y, u) = attitude_run(0.15, Draw::Uniform, 0, &mut Random::new(73)).remove(0);
    let y: Vec<_> = y.into_iter().map(Some).collect();
    filter.update_traced(&y, &[], &mut |phase| phases.push(phase)).unwrap();
    filter.predict_traced(&u, &mut |phase| phases.push(phase)).unwrap();
    phases.dedup();
    use Phase::{Consistency, Prediction, Reduction, Update};
    assert_eq!(phases, [Update, Reduction, Consistency, Reduction, Consistency, Prediction, Reduction, Prediction]);
}

/// An outlier is refuted with a proof that can be checked, and leaves the filter as it was.
#[test]
fn an_outlier_is_a_proven_contradiction() {
    let mut random = Random::new(74);
    let (mut proven, mut total) = (0, 0);
    for options in [CzOptions::czmv(PLANAR), CzOptions::czfo(PLANAR)] {
        let mut filter = CzFilter::new(planar(), planar_start(), options).unwrap();
        for (k, (_, y)) in planar_run(Draw::Uniform, 10, &mut random).iter().enumerate() {
            if k > 0 {
                filter.predict(&[]).unwrap();
            }
            if k > 3 {
                total += 1;
                let mut wrong = y.clone();
                wrong[0] += 10.0 * random.sign();
                let before = filter.state().clone();
                match filter.update(&wrong) {
                    Err(EstimatorError::Inconsistent(proof)) => {
                        assert!(proof.verify() && matches!(proof.evidence, Evidence::Rows { .. }), "{proof}");
                        assert!(proof.culprits.contains(&Culprit::Measurement(0)), "{proof}");
                        assert_eq!((proof.step, filter.state()), (k as u64, &before));
                        proven += 1;
                    }
                    Err(error) => panic!("{error}"),
                    Ok(()) => filter.restore(&before).unwrap(),
                }
            }
            filter.update(y).unwrap();
        }
    }
    println!("{proven} of {total} outliers proven");
    assert!(proven * 10 >= total * 9);
}

/// Outputs that were not measured need not be smooth, bounded or defined: the update is the one without them.
#[test]
fn outputs_that_were_not_measured_may_be_anything() {
    let step = || Relation::new(function!(|[x, y, w]: 3| -> 2 { [x + w, y] }));
    let all = || {
        Relation::new(function!(|[x, y, v]: 3| -> 4 {
            [(x - y.scale(0.125)).abs() + v, x * y + v, x.recip() + v, (x.scale(0.1) - y - y.sqr()).sqrt()]
        }))
    };
    let one = || Relation::new(function!(|[x, y, v]: 3| -> 1 { [x * y + v] }));
    for options in [CzOptions::czmv(PLANAR), CzOptions::czfo(PLANAR)] {
        let updated = |output: Relation, y: &[Option<f64>]| {
            let system = System::new(step(), cube(1, 0.01), output, cube(1, 0.05)).unwrap();
            let start = ConstrainedZonotope::from_box(&[0.1, 1.0], &[0.5, 0.1]).unwrap();
            let mut filter = CzFilter::new(system, start, options.clone()).unwrap();
            filter.update_some(y, &[]).unwrap();
            filter.state().clone()
        };
        let expected = updated(one(), &[Some(0.2)]);
        assert_eq!(updated(all(), &[None, Some(0.2), None, None]), expected);
        assert!(expected.hull[0].width() < 0.5);
        // One that is not smooth is no reason to fail either.
        updated(all(), &[Some(0.1), Some(0.2), None, None]);
    }
}

/// Strips and invariants that exclude the set are named.
#[test]
fn culprits_are_named() {
    let far = Strip::new(&[0.0, 1.0, 0.0, 0.0], Interval::new(2.0, 3.0).unwrap()).unwrap();
    for options in [CzOptions::czmv(ATTITUDE), CzOptions::czfo(ATTITUDE)] {
        let options = options.with_feasible([unit_strips(), vec![far.clone()]].concat());
        let mut filter = CzFilter::new(attitude(0.15), attitude_start(), options.clone()).unwrap();
        let Err(EstimatorError::Inconsistent(proof)) = filter.consistency() else { panic!("no contradiction") };
        assert!(proof.verify(), "{proof}");
        assert!(
            proof.culprits.contains(&Culprit::Feasible(4)) && !proof.culprits.contains(&Culprit::Feasible(0)),
            "{proof}"
        );

        let small = ConstrainedZonotope::from_box(&[0.0; 4], &[0.2; 4]).unwrap();
        let options = CzOptions { feasible: vec![], ..options };
        let mut filter = CzFilter::new(attitude(0.15), small, options).unwrap();
        let Err(EstimatorError::Inconsistent(proof)) = filter.consistency() else { panic!("no contradiction") };
        assert_eq!(
            (proof.culprits.as_slice(), proof.verify()),
            (&[Culprit::Invariant(0), Culprit::Prediction][..], true)
        );
    }
}

/// The first filter that fails leaves its state; what is wrong is named.
#[test]
fn bad_input_is_refused() {
    let options = CzOptions::czmv(Some(Complexity { generators: 1, constraints: 3 }));
    let refused = CzFilter::new(planar(), planar_start(), options).unwrap_err();
    assert_eq!(refused, EstimatorError::Set(SetError::TooFewGenerators { max_generators: 1, dim: 2 }));
    let options = CzOptions::czmv(PLANAR).with_feasible(unit_strips());
    let refused = CzFilter::new(planar(), planar_start(), options).unwrap_err();
    assert_eq!(refused, EstimatorError::Size { what: "strip of feasible states", expected: 2, found: 4 });
    let mut empty = ConstrainedZonotope::from_box(&[0.0; 2], &[1.0; 2]).unwrap();
    empty.intersect_half_space(&[1.0, 1.0], -3.0, &mut Workspace::new()).unwrap();
    assert!(matches!(CzFilter::new(planar(), empty, CzOptions::czmv(PLANAR)), Err(EstimatorError::Set(_))));

    for options in [CzOptions::czmv(PLANAR), CzOptions::czfo(PLANAR)] {
        let mut filter = CzFilter::new(planar(), planar_start(), options).unwrap();
        let before = filter.state().clone();
        assert!(matches!(filter.update(&[f64::NAN, 0.0]), Err(EstimatorError::NotFinite { index: 0, .. })));
        assert!(matches!(filter.update(&[0.0]), Err(EstimatorError::Size { .. })));
        assert!(matches!(filter.predict(&[1.0]), Err(EstimatorError::Size { .. })));
        filter.options_mut().feasible = unit_strips();
        assert!(matches!(filter.update(&[0.0, 0.0]), Err(EstimatorError::Size { .. })));
        assert_eq!(filter.state(), &before);
    }
}

/// Missing outputs are no constraints; predictions in a row do not grow the set beyond bounds of its size.
#[test]
fn missing_outputs_and_missing_updates() {
    for options in [CzOptions::czmv(PLANAR), CzOptions::czfo(PLANAR)] {
        let mut filter = CzFilter::new(planar(), planar_start(), options).unwrap();
        let before = filter.hull().to_vec();
        filter.update_some(&[None, None], &[]).unwrap();
        assert!(filter.hull().iter().zip(&before).all(|(new, old)| (new.width() / old.width() - 1.0).abs() < 1e-9));
        let (x, y) = planar_run(Draw::Uniform, 0, &mut Random::new(75)).remove(0);
        filter.update_some(&[None, Some(y[1])], &[]).unwrap();
        check(&filter, &exactly(&x), "one output");
        filter.update_some(&[Some(y[0]), None], &[]).unwrap();
        check(&filter, &exactly(&x), "the other output");
        assert!(radius(filter.hull()) < 0.95);
        for _ in 0..3 {
            filter.predict(&[]).unwrap();
            assert!(filter.enclosure().num_generators() <= 8 + 4 && filter.enclosure().num_constraints() <= 3);
        }
    }
}

/// Noise given by generators that mix the outputs is kept as it is: narrower than its hull in the sum of the outputs.
#[test]
fn skew_noise_keeps_its_shape() {
    let skew = Matrix::from_rows(&[&[0.3, 0.3], &[0.3, -0.3]]).unwrap();
    let skew = Zonotope::new(&[0.0, 0.0], &skew).unwrap();
    let system =
        |noise| System::new(Relation::new(PlanarStep), cube(2, 0.4), Relation::new(PlanarOutput), noise).unwrap();
    let start = || ConstrainedZonotope::from_box(&[5.2, 0.65], &[0.3, 0.3]).unwrap();
    let (x, y) = (vec![5.2, 0.65], [5.2 - 0.325_f64.sin(), 0.65 * (1.0 - 5.2)]);
    for options in [CzOptions::czmv(PLANAR), CzOptions::czfo(PLANAR)] {
        let after = |noise| {
            let mut filter = CzFilter::new(system(noise), start(), options.clone()).unwrap();
            filter.update(&y).unwrap();
            check(&filter, &exactly(&x), "skew noise");
            // The gradient of the sum of the outputs.
            filter.enclosure().support(&[0.35, -4.7], &mut Workspace::new()).unwrap()
        };
        let (own, hull) = (after(skew.clone()), after(cube(2, 0.6)));
        assert!(own < hull - 0.3, "{own} {hull}");
    }
}

/// An invariant with a width (Remark 13), one-sided invariants, and functions that are not smooth enough for either extension.
#[test]
fn inexact_and_rough_invariants() {
    let step = || Relation::new(function!(|[x, y, w]: 3| -> 2 { [x + w, y] }));
    let output = || Relation::new(function!(|[x, y, v]: 3| -> 1 { [x - y + v] }));
    let plain = || System::new(step(), cube(1, 0.01), output(), cube(1, 0.5)).unwrap();
    let circle = || Relation::new(function!(|[x, y]: 2| -> 1 { [x.sqr() + y.sqr()] }));
    let root = || Relation::new(function!(|[x, y]: 2| -> 1 { [(x.sqr() + y.sqr()).sqrt()] }));
    let side = |lo, hi| vec![Interval::new(lo, hi).unwrap()];
    let start = |r| ConstrainedZonotope::from_box(&[0.9, 0.1], &[r, r]).unwrap();
    for options in [CzOptions::czmv(PLANAR), CzOptions::czfo(PLANAR)] {
        let cut = |relation, range, r| {
            let system = plain().with_invariant(relation, range).unwrap();
            let mut filter = CzFilter::new(system, start(r), options.clone()).unwrap();
            filter.consistency().unwrap();
            check(&filter, &exactly(&[1.0, 0.0]), "invariant");
            filter.enclosure().support(&[1.0, 0.25], &mut Workspace::new()).unwrap()
        };
        let circle = |lo, hi| cut(circle(), side(lo, hi), 0.2);
        let (exact, wide) = (circle(1.0, 1.0), circle(0.98, 1.02));
        let (below, above) = (circle(f64::NEG_INFINITY, 1.0), circle(0.0, f64::INFINITY));
        assert!(exact < wide && exact <= below + 1e-9 && below < above, "{exact} {wide} {below} {above}");
        // No derivative at the origin, which lies in the set.
        cut(root(), side(0.9, 1.1), 1.0);
    }
}

/// Steady state allocates nothing.
#[test]
fn a_step_in_steady_state_allocates_nothing() {
    let mut random = Random::new(76);
    for options in [
        CzOptions::czmv(ATTITUDE).with_consistency().with_feasible(unit_strips()),
        CzOptions::czfo(ATTITUDE).with_consistency(),
    ] {
        let run = attitude_run(0.15, Draw::Uniform, 5, &mut random);
        let mut filter = CzFilter::new(attitude(0.15), attitude_start(), options.clone()).unwrap();
        let step = |filter: &mut CzFilter, k: usize| {
            filter.update(&run[k].1).unwrap();
            filter.predict(&run[k].2).unwrap();
        };
        let start = filter.state().clone();
        for _ in 0..6 {
            (0..5).for_each(|k| step(&mut filter, k));
            filter.restore(&start).unwrap();
        }
        let info = allocation_counter::measure(|| (0..5).for_each(|k| step(&mut filter, k)));
        assert_eq!(info.count_total, 0, "{:?}", options.extension);
    }
}
