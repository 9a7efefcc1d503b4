//! Containment of exact solutions.

use nonlin_bounds::{
    Expansion, PolytopicCut, Workspace, polytopic_image_with_noise, polytopic_solution, polytopic_solution_lift,
    polytopic_strips,
};
use scalars::Interval;
use setrep::{HPolytope, IntervalVector, Matrix, Membership};

use crate::common::random::{Random, cases};
use crate::polynomials::{Polynomials, expansion_point, member, polytope};

const SEED: u64 = 42;

/// A box or a polytope around a value, with few bits; its offsets are exact.
fn target(random: &mut Random, y: &[f64]) -> HPolytope {
    let half_width = |random: &mut Random| random.below(9) as f64 * if random.below(2) == 0 { 0.25 } else { 4.0 };
    if random.below(2) == 0 {
        let sides: Vec<Interval> = y
            .iter()
            .map(|&y| Interval::point(y - half_width(random)).hull(Interval::point(y + half_width(random))))
            .collect();
        return HPolytope::from_intervals(&sides).unwrap();
    }
    let mut normals = Matrix::zeros(3, y.len());
    normals.as_mut_slice().iter_mut().for_each(|a| *a = random.below(5) as f64 - 2.0);
    let offset = |j: usize| (0..y.len()).map(|i| normals[(j, i)] * y[i]).sum::<f64>();
    let offsets: Vec<f64> = (0..3).map(|j| offset(j) + half_width(random)).collect();
    HPolytope::new(normals, &offsets).unwrap()
}

#[test]
fn exact_solutions_are_kept() {
    let (mut workspace, mut kept) = (Workspace::new(), 0);
    for case in 0..cases(700) {
        let random = &mut Random::new(SEED, case);
        let (n, m) = (1 + random.below(3), 1 + random.below(2));
        let (g, set) = (Polynomials::random(random, n, m), polytope(random, n));
        let x = member(random, &set);
        let y = target(random, &g.exact(&x));
        let at = expansion_point(random, &set);
        let solution = polytopic_solution(&g, &set, &y, Expansion::Point(&at), &[], &mut workspace).unwrap();
        let half_spaces = solution.to_h_polytope().unwrap();
        let lift = polytopic_solution_lift(&g, &set, &y, Expansion::Point(&at), &[], &mut workspace).unwrap();
        for k in 0..60 {
            let x = member(random, &set);
            if y.membership(&IntervalVector::point(&g.exact(&x))).unwrap() != Membership::ProvenInside {
                continue;
            }
            let point = IntervalVector::point(&x);
            assert_ne!(
                half_spaces.membership(&point).unwrap(),
                Membership::ProvenOutside,
                "seed {SEED}, case {case}: {x:?}"
            );
            if k < 10 {
                let verdict = lift.membership(&point, &mut workspace.sets).unwrap();
                assert_ne!(verdict, Membership::ProvenOutside, "lift, seed {SEED}, case {case}: {x:?}");
            }
            kept += 1;
        }
    }
    assert!(kept >= cases(10_000), "only {kept} solutions were met");
}

/// Neither set reaches beyond the set that it refines.
#[test]
fn solutions_are_subsets() {
    let mut workspace = Workspace::new();
    for case in 0..cases(200) {
        let random = &mut Random::new(SEED + 1, case);
        let n = 1 + random.below(3);
        let (g, set) = (Polynomials::random(random, n, 1), polytope(random, n));
        let x = member(random, &set);
        let y = target(random, &g.exact(&x));
        let at = set.interval_hull().mid();
        let solution = polytopic_solution(&g, &set, &y, Expansion::Point(&at), &[], &mut workspace).unwrap();
        let lift = polytopic_solution_lift(&g, &set, &y, Expansion::Point(&at), &[], &mut workspace).unwrap();
        for _ in 0..4 {
            let direction: Vec<f64> = (0..n).map(|_| random.unit()).collect();
            let limit = set.support(&direction).unwrap() + 1e-11;
            assert!(solution.support(&direction).unwrap() <= limit, "seed {}, case {case}", SEED + 1);
            assert!(lift.support(&direction, &mut workspace.sets).unwrap() <= limit, "seed {}, case {case}", SEED + 1);
        }
    }
}

/// A member of a box of noises, in eighths of its radius.
fn noise_member(random: &mut Random, noise: &[Interval]) -> Vec<f64> {
    noise.iter().map(|side| side.rad() * (random.below(17) as f64 - 8.0) / 8.0).collect()
}

/// With noises that are variables of their own, some of which move several outputs: images and strips keep what is exactly reached.
#[test]
fn noises_in_a_box_are_kept() {
    let (mut workspace, mut kept, mut reached) = (Workspace::new(), 0, 0);
    for case in 0..cases(400) {
        let random = &mut Random::new(SEED + 2, case);
        let (n, q, m) = (1 + random.below(3), random.below(3), 1 + random.below(2));
        let (g, set) = (Polynomials::random(random, n + q, m), polytope(random, n));
        let noise: Vec<Interval> = (0..q).map(|_| Interval::ZERO.inflate(random.below(3) as f64 * 0.25)).collect();
        let point = |random: &mut Random| [member(random, &set), noise_member(random, &noise)].concat();
        let center = [set.interval_hull().mid(), vec![0.0; q]].concat();
        let at = if random.below(2) == 0 { Expansion::SetCenter } else { Expansion::Point(&center) };
        let image = polytopic_image_with_noise(&g, &set, &noise, at, &[], &mut workspace).unwrap();
        let image = image.to_h_polytope().unwrap();
        let value = g.exact(&point(random));
        let y: Vec<Interval> =
            value.iter().map(|&y| Interval::point(y).inflate(random.below(9) as f64 * 0.5)).collect();
        let cut = polytopic_strips(&g, (&set, &noise), &y, at, &[], &mut workspace).unwrap();
        let PolytopicCut::Left(left) = cut else { panic!("seed {}, case {case}: a solution is lost", SEED + 2) };
        let left = left.to_h_polytope().unwrap();
        for _ in 0..40 {
            let z = point(random);
            let value = g.exact(&z);
            let verdict = image.membership(&IntervalVector::point(&value)).unwrap();
            assert_ne!(verdict, Membership::ProvenOutside, "image, seed {}, case {case}: {z:?}", SEED + 2);
            reached += 1;
            if value.iter().zip(&y).all(|(&value, side)| side.contains(value)) {
                let verdict = left.membership(&IntervalVector::point(&z[..n])).unwrap();
                assert_ne!(verdict, Membership::ProvenOutside, "strips, seed {}, case {case}: {z:?}", SEED + 2);
                kept += 1;
            }
        }
    }
    assert!(kept >= cases(4000) && reached > kept, "only {kept} solutions were met");
}
