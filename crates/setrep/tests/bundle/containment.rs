//! Members of every operation's exact result, hulls, supports and proofs.

use allocation_counter::measure;
use scalars::Interval;
use setrep::{
    Emptiness, IntervalMatrix, IntervalVector, Matrix, Membership, SupportFunction, Workspace, Zonotope, ZonotopeBundle,
};

use crate::SEED;
use crate::common::dyadic::Dyadic;
use crate::common::exact::{image, lies_in, member, sum, times};
use crate::common::random::{Random, cases};
use crate::member::{around, assert_not_refuted, dot};

/// A bundle whose members share an exact point: each further one has the center that puts it there, its rounding in the remainder.
pub(crate) fn bundle(random: &mut Random, n: usize, members: usize) -> (ZonotopeBundle, Vec<Dyadic>) {
    let first = {
        let m = random.between(0, 6);
        random.set(n, m)
    };
    let x = member(&first, random).x;
    let mut all = vec![first];
    for _ in 1..members {
        let m = random.between(0, 6);
        let (g, xi) = (random.generators(n, m), random.cube(m));
        let offset: Vec<Dyadic> = x.iter().zip(times(&g, &xi)).map(|(x, h)| x - &h).collect();
        let center: Vec<f64> = offset.iter().map(Dyadic::approx).collect();
        let wide = random.below(3) == 0;
        let remainder: Vec<f64> = offset
            .iter()
            .zip(&center)
            .map(|(x, &c)| around(&(x - &Dyadic::from(c)).abs(), 0.0, 0.0).hi() + if wide { c.abs() } else { 0.0 })
            .collect();
        all.push(Zonotope::with_remainder(&center, &g, &remainder).unwrap());
    }
    (ZonotopeBundle::new(all).unwrap(), x)
}

/// Panics if the exact point is not proven a member of every zonotope, or is refuted by what is asked of the bundle; and if a hull or a
/// support is looser than a member's.
pub(crate) fn assert_member(
    set: &ZonotopeBundle,
    x: &[Dyadic],
    random: &mut Random,
    workspace: &mut Workspace,
    context: &str,
) {
    assert!(set.members().iter().all(|member| lies_in(member, x)), "outside a member, {context}: {set:?}");
    let hull = set.interval_hull(workspace).unwrap();
    for own in set.members().iter().map(Zonotope::interval_hull) {
        assert!(hull.iter().zip(own.iter()).all(|(side, own)| side.subset_of(own)), "{context}: {hull:?} of {set:?}");
    }
    for (side, x) in hull.iter().zip(x) {
        let inside = !side.is_empty() && &Dyadic::from(side.lo()) <= x && x <= &Dyadic::from(side.hi());
        assert!(inside, "outside the hull, {context}: {set:?}");
    }
    let d: Vec<f64> = (0..set.dim()).map(|_| random.moderate()).collect();
    let h = set.support(&d, workspace).unwrap();
    assert!(h == f64::INFINITY || dot(&d, x) <= Dyadic::from(h), "above the support, {context}: {set:?} {d:?}");
    let by_vector = set.support_vector(&d, &mut vec![0.0; d.len()], workspace).unwrap();
    assert_eq!(h, by_vector, "support with and without vector, {context}: {set:?} {d:?}");
    assert!(!set.is_proven_empty(workspace).unwrap(), "proven empty, {context}: {set:?}");
    assert!(!matches!(set.emptiness(workspace).unwrap(), Emptiness::ProvenEmpty(_)), "{context}: {set:?}");
    let point: Vec<Interval> = x.iter().map(|x| around(x, 0.0, 0.0)).collect();
    let verdict = set.membership(&point, workspace).unwrap();
    assert!(verdict != Membership::ProvenOutside, "proven outside, {context}: {set:?}");
}

#[test]
fn operations_contain_exact_results() {
    let mut workspace = Workspace::new();
    for case in 0..cases(2_500) {
        let mut random = Random::new(SEED, case);
        let (n, members) = (random.between(1, 3), random.between(1, 4));
        let (set, x) = bundle(&mut random, n, members);
        let context = format!("seed {SEED} case {case}");
        let (mut result, y) = match case % 8 {
            0 => (set.clone(), x.clone()),
            1 => {
                let p = random.between(1, 3);
                let map = random.matrix(p, n);
                (set.linear_map(&map).unwrap(), image(&map, &x))
            }
            2 => {
                let m = random.between(0, 3);
                let noise = random.set(n, m);
                let w = member(&noise, &mut random).x;
                (set.minkowski_sum(&noise).unwrap(), sum(&x, &w))
            }
            3 => {
                let (other, y) = bundle(&mut random, 1, 2);
                (set.cartesian_product(&other), [x.clone(), y].concat())
            }
            4 => {
                let map = random.matrix(n, n);
                let mut image_set = set.clone();
                let interval = IntervalMatrix::point(map.clone()).unwrap();
                image_set.interval_map_in_place(&interval, &mut workspace).unwrap();
                (image_set, image(&map, &x))
            }
            5 => {
                let shift: Vec<Dyadic> = (0..n).map(|_| Dyadic::from(random.wide())).collect();
                let sides: Vec<Interval> =
                    shift.iter().map(|t| around(t, 0.0, 0.0).inflate(random.unit().abs())).collect();
                let mut moved = set.clone();
                moved.add_box(&sides, &mut workspace).unwrap();
                (moved, sum(&x, &shift))
            }
            6 => {
                let coordinates: Vec<usize> = (0..random.between(1, n)).map(|_| random.below(n)).collect();
                (set.project(&coordinates).unwrap(), coordinates.iter().map(|&k| x[k].clone()).collect())
            }
            _ => {
                let (shift, factor): (Vec<f64>, f64) = ((0..n).map(|_| random.wide()).collect(), random.wide());
                let mut moved = set.clone();
                moved.scale(factor, &mut workspace).unwrap();
                moved.translate(&shift, &mut workspace).unwrap();
                let y = x.iter().zip(&shift).map(|(x, &t)| &(&Dyadic::from(factor) * x) + &Dyadic::from(t)).collect();
                (moved, y)
            }
        };
        assert_member(&result, &y, &mut random, &mut workspace, &context);
        let twin = result.clone();
        result.intersect_bundle(&twin).unwrap();
        assert_eq!(result.num_members(), 2 * twin.num_members());
    }
}

#[test]
fn conversions_contain_the_set() {
    let mut workspace = Workspace::new();
    for case in 0..cases(1_500) {
        let mut random = Random::new(SEED + 1, case);
        let (n, members) = (random.between(1, 3), random.between(1, 4));
        let (set, x) = bundle(&mut random, n, members);
        let context = || format!("seed {SEED}+1 case {case}: {set:?}");
        let constrained = set.to_constrained_zonotope().unwrap();
        assert_not_refuted(&constrained, &x, &mut random, &mut workspace, &context);
        assert_eq!(constrained.num_constraints(), n * (members - 1));
        let most = random.between(1, 4);
        let back = constrained.to_zonotope_bundle(most, &mut workspace).unwrap();
        assert!(back.num_members() <= most && back.members().iter().all(|member| member.num_generators() <= n));
        assert_member(&back, &x, &mut random, &mut workspace, &context());
    }
}

/// A square and a diamond meet in an octagon or a triangle: hull, support and emptiness are those of the intersection.
#[test]
fn the_program_sees_all_members() {
    let mut workspace = Workspace::new();
    let square = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    let diamond = |x: f64| {
        let generators = Matrix::from_rows(&[&[0.5, 0.5], &[0.5, -0.5]]).unwrap();
        Zonotope::new(&[x, 0.0], &generators).unwrap()
    };
    let mut bundle = ZonotopeBundle::new(vec![square.clone(), diamond(1.5)]).unwrap();
    // |x_1 - 1.5| + |x_2| <= 1 with x_1 <= 1: the tip at 0.5, half-height 0.5 at x_1 = 1.
    let hull = bundle.interval_hull(&mut workspace).unwrap();
    for (side, (lo, hi)) in hull.iter().zip([(0.5, 1.0), (-0.5, 0.5)]) {
        assert!(side.contains(lo) && side.contains(hi) && side.width() < hi - lo + 1e-13, "{hull:?}");
    }
    let h = bundle.support(&[1.0, 1.0], &mut workspace).unwrap();
    assert!((1.5..1.5 + 1e-13).contains(&h));
    assert!(matches!(bundle.emptiness(&mut workspace).unwrap(), Emptiness::ProvenNonEmpty(_)));
    let inside = bundle.membership(&IntervalVector::point(&[0.75, 0.125]), &mut workspace).unwrap();
    assert_eq!(inside, Membership::ProvenInside);
    let outside = bundle.membership(&IntervalVector::point(&[0.5, 0.25]), &mut workspace).unwrap();
    assert_eq!(outside, Membership::ProvenOutside);
    // Empty as a whole, though any two members meet.
    bundle.intersect(&diamond(-0.75)).unwrap();
    assert!(bundle.is_proven_empty(&mut workspace).unwrap());
    assert!(bundle.interval_hull(&mut workspace).unwrap().iter().all(Interval::is_empty));
    let Emptiness::ProvenEmpty(proof) = bundle.emptiness(&mut workspace).unwrap() else { panic!("{bundle:?}") };
    assert!(proof.verify(&bundle.to_constrained_zonotope().unwrap()));
    assert_eq!(bundle.support(&[1.0, 0.0], &mut workspace).unwrap(), f64::NEG_INFINITY);
}

#[test]
fn a_warm_step_allocates_nothing() {
    let mut random = Random::new(7, 0);
    let (start, _) = bundle(&mut random, 3, 3);
    let noise = random.set(3, 2);
    let map = Matrix::from_rows(&[&[0.8, -0.6, 0.0], &[0.6, 0.8, 0.0], &[0.0, 0.1, 1.0]]).unwrap();
    let (mut set, mut workspace, mut hull) = (start.clone(), Workspace::new(), vec![Interval::ZERO; 3]);
    let mut step = || {
        set.clone_from(&start);
        set.linear_map_in_place(&map, &mut workspace).unwrap();
        set.add_assign(&noise, &mut workspace).unwrap();
        set.interval_hull_into(&mut hull, &mut workspace).unwrap();
        hull[0].hi() + set.support(&[1.0, 2.0, 3.0], &mut workspace).unwrap()
    };
    let expected: f64 = (0..10).map(|_| step()).sum();
    let mut total = 0.0;
    let count = measure(|| (0..10).for_each(|_| total += step()));
    assert!(expected == total && count.count_total == 0, "{} allocations", count.count_total);
}
