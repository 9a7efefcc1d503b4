//! Several filters at once are as good as each of them.

use estimators::{Comb, CombMember, CombOptions, Estimator, EstimatorError, Guarantee, VhOptions};
use scalars::Interval;

use crate::plants::{Draw, is_proof, planar, unicycle};
use crate::support::{Random, cases};

#[test]
fn the_intersection_is_smaller_and_holds_the_state() {
    for case in 0..cases(4) {
        let example = if case % 2 == 0 { planar(3.0) } else { unicycle(1.0, 1.0) };
        let members: Vec<Box<dyn CombMember>> = example.filters().into_iter().map(|(_, filter)| filter).collect();
        let mut comb = Comb::new(members, example.vertices(), CombOptions::default()).unwrap();
        assert_eq!(comb.guarantee(), Guarantee::Rigorous);
        let mut alone = example.vh(VhOptions::paper());
        for (k, (x, y)) in example.run(Draw::Uniform, 3, &mut Random::new(20 + case as u64)).iter().enumerate() {
            if k > 0 {
                comb.predict(&[]).unwrap();
                alone.predict(&[]).unwrap();
            }
            comb.update(y).unwrap();
            alone.update(y).unwrap();
            let point: Vec<Interval> = x.iter().map(|&x| Interval::point(x).inflate(1e-12)).collect();
            let member = comb.enclosure().membership(&point).unwrap();
            assert_ne!(member, setrep::Membership::ProvenOutside, "case {case}, step {k}");
            let (together, one) = (comb.enclosure().volume().unwrap(), alone.enclosure().volume().unwrap());
            assert!(together.lo() <= one.hi() * (1.0 + 1e-6), "case {case}, step {k}: {together:?} {one:?}");
        }
        assert_eq!(comb.step_index(), 3);
    }
}

#[test]
fn after_an_error_all_members_are_as_before() {
    let example = planar(3.0);
    let members = |count: usize| example.filters().into_iter().take(count).map(|(_, filter)| filter).collect();
    let mut comb = Comb::new(members(4), example.vertices(), CombOptions::default()).unwrap();
    let mut undisturbed = Comb::new(members(4), example.vertices(), CombOptions::default()).unwrap();
    let error = comb.update(&[40.0, 40.0]).unwrap_err();
    assert!(is_proof(&error), "{error:?}");
    assert!(comb.update(&[0.1]).is_err());
    assert!(comb.step(&[1.0], &[0.8, 0.0]).is_err());
    for (_, y) in example.run(Draw::Uniform, 1, &mut Random::new(9)) {
        comb.step(&[], &y).unwrap();
        undisturbed.step(&[], &y).unwrap();
    }
    assert_eq!(comb.enclosure(), undisturbed.enclosure());
    assert_eq!(comb.hull(), undisturbed.hull());

    let none: Vec<Box<dyn CombMember>> = Vec::new();
    assert!(matches!(Comb::new(none, example.vertices(), CombOptions::default()), Err(EstimatorError::Size { .. })));
    let other = Comb::new(members(1), unicycle(1.0, 1.0).vertices(), CombOptions::default());
    assert!(matches!(other, Err(EstimatorError::Size { .. })));
}
