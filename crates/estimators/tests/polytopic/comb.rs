//! Several filters at once are as good as each of them.

use estimators::{
    Comb, CombMember, CombOptions, DCz, DCzOptions, DZb, DZbOptions, Estimator, EstimatorError, Guarantee, Relation,
    System, Vh, VhOptions,
};
use nonlin_bounds::{BoundError, function};
use setrep::{ConstrainedZonotope, Zonotope};

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
            let member = comb.enclosure().membership(x).unwrap();
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

/// An output that was not measured need not be defined where the state may be.
#[test]
fn missing_outputs_are_not_asked_for() {
    let still = function!(|[x, y, w]: 3| -> 2 { [x + w, y] });
    let outputs = function!(|[x, y, u, v]: 4| -> 2 { [x + y.scale(0.5) + u, y.sqrt() + v] });
    let error = Zonotope::from_box(&[0.0; 2], &[0.1; 2]).unwrap();
    let none = Zonotope::from_box(&[0.0], &[0.0]).unwrap();
    let system = System::new(Relation::new(still), none, Relation::new(outputs), error).unwrap();
    let start = Zonotope::from_box(&[0.0; 2], &[1.0; 2]).unwrap();
    let (vertices, set) = (start.to_v_polytope().unwrap(), ConstrainedZonotope::from(start.clone()));
    let members: Vec<Box<dyn CombMember>> = vec![
        Box::new(Vh::new(system.clone(), vertices.clone(), VhOptions::paper()).unwrap()),
        Box::new(DCz::new(system.clone(), set, DCzOptions::new(2)).unwrap()),
        Box::new(DZb::new(system, start.into(), DZbOptions::new(2)).unwrap()),
    ];
    let mut comb = Comb::new(members, vertices, CombOptions::default()).unwrap();
    assert!(matches!(comb.update(&[1.2, 0.0]), Err(EstimatorError::Bound(BoundError::NotSmooth { .. }))));
    comb.update_some(&[Some(1.2), None]).unwrap();
    // |x + y / 2 - 1.2| <= 0.1.
    assert!((comb.hull()[0].lo() - 0.6).abs() < 1e-9 && (comb.enclosure().volume().unwrap().mid() - 0.12).abs() < 1e-6);
}
