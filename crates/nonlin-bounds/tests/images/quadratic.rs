//! Quadratic enclosures of polynomials in exact arithmetic, with the products of a member's coordinates as witnesses.

use nonlin_bounds::{Copies, Domain, QuadraticEnclosure, Workspace};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Membership};

use crate::SEED;
use crate::members::{around, constrained, is_proven_member, on_grid, values};
use crate::polynomials::Polynomials;
use crate::sets::dyadic::Dyadic;
use crate::sets::exact::{Member, lies_in};
use crate::sets::random::{Random, cases};

/// `2 xi_a^2 - 1`, then `xi_a xi_b`, then a copy of the coordinates if there is one.
fn coordinates(set: &ConstrainedZonotope, member: &Member, copies: Copies) -> Vec<f64> {
    let mut xi = member.xi.clone();
    xi.extend((0..set.dim()).filter(|&k| set.remainder()[k] > 0.0).map(|k| member.eta[k]));
    let mut products: Vec<f64> = xi.iter().map(|t| 2.0 * t * t - 1.0).collect();
    for a in 0..xi.len() {
        products.extend((a + 1..xi.len()).map(|b| xi[a] * xi[b]));
    }
    if copies == Copies::Separate {
        products.extend_from_slice(&xi);
    }
    products
}

/// A polynomial with every square and product.
fn dense(random: &mut Random, n: usize) -> Polynomials {
    let mut output = || {
        let mut terms = vec![(random.integer(), vec![0]), (random.integer(), vec![0, 0, n - 1])];
        for j in 0..n {
            terms.extend((j..n).map(|k| (f64::from(random.below(5) as u32 + 1), vec![j, k])));
        }
        terms
    };
    Polynomials { variables: n, outputs: (0..2).map(|_| output()).collect() }
}

#[test]
fn images_and_solutions_contain_exact_ones() {
    let (mut w, mut explicit) = (Workspace::new(), 0);
    for case in 0..cases(700) {
        let mut random = Random::new(SEED + 4, case);
        let n = random.between(1, 3);
        let (set, members) = on_grid(&mut random, n, 2);
        let f = dense(&mut random, n);
        let hull = set.interval_hull(&mut w.sets).unwrap();
        let at = if random.below(2) == 0 { hull.mid() } else { set.center().to_vec() };
        for copies in [Copies::Shared, Copies::Separate] {
            let context = || format!("{copies:?}, seed {SEED}+4 case {case}: {f:?} {set:?} {at:?}");
            let enclosure = QuadraticEnclosure::new(&f, &set, &Domain::new(&hull, &at), copies, &mut w).unwrap();
            let image = enclosure.image(&set, &mut w).unwrap();
            let mut boxed = enclosure.clone();
            boxed.box_curvature(&mut w).unwrap();
            assert_eq!((boxed.curvature().num_generators(), boxed.curvature().num_constraints()), (0, 0));
            let boxed_image = boxed.image(&set, &mut w).unwrap();
            for member in &members {
                let y = values(&f, &member.x);
                let mut cut = set.clone();
                let sides: Vec<Interval> = y.iter().map(|y| around(y, 0.0, random.unit().abs())).collect();
                enclosure.intersect(&mut cut, &sides, &mut w).unwrap();
                let mut boxed_cut = set.clone();
                boxed.intersect(&mut boxed_cut, &sides, &mut w).unwrap();
                // No column but those of the set's own remainder.
                assert!(boxed_cut.num_generators() <= set.num_generators() + n);
                refute(&boxed_cut, &member.x, &mut w, &context);
                refute(&boxed_image, &y, &mut w, &context);
                let tail = coordinates(&set, member, copies);
                if enclosure.curvature().num_generators() == tail.len() {
                    explicit += 1;
                    assert!(is_proven_member(&set, &image, member, &tail, &y), "image, {}", context());
                    assert!(is_proven_member(&set, &cut, member, &tail, &member.x), "solution, {}", context());
                } else {
                    // Columns of zeros were left out.
                    refute(&image, &y, &mut w, &context);
                    refute(&cut, &member.x, &mut w, &context);
                }
            }
        }
    }
    assert!(explicit > cases(700), "{explicit} explicit witnesses");
}

/// Sets of all scales, by proofs of non-membership.
#[test]
fn sets_of_all_scales_are_not_refuted() {
    let mut w = Workspace::new();
    for case in 0..cases(300) {
        let mut random = Random::new(SEED + 5, case);
        let n = random.between(1, 3);
        let (set, members) = constrained(&mut random, n, 1);
        let f = dense(&mut random, n);
        let hull = set.interval_hull(&mut w.sets).unwrap();
        for copies in [Copies::Shared, Copies::Separate] {
            let context = || format!("{copies:?}, seed {SEED}+5 case {case}: {f:?} {set:?}");
            let domain = Domain::new(&hull, set.center());
            let enclosure = QuadraticEnclosure::new(&f, &set, &domain, copies, &mut w).unwrap();
            let y = values(&f, &members[0].x);
            refute(&enclosure.image(&set, &mut w).unwrap(), &y, &mut w, &context);
            let mut cut = set.clone();
            let sides: Vec<Interval> = y.iter().map(|y| around(y, 0.0, 0.0)).collect();
            enclosure.intersect(&mut cut, &sides, &mut w).unwrap();
            refute(&cut, &members[0].x, &mut w, &context);
        }
    }
}

/// Combastel's extension: for zonotopes, exact membership of the exact image.
#[test]
fn images_of_zonotopes_contain_exact_images() {
    let mut w = Workspace::new();
    for case in 0..cases(500) {
        let mut random = Random::new(SEED + 6, case);
        let n = random.between(1, 3);
        let (set, members) = on_grid(&mut random, n, 1);
        let (set, f) = (set.unconstrained().clone(), dense(&mut random, n));
        let hull = set.interval_hull();
        let domain = Domain::new(&hull, set.center());
        let enclosure = QuadraticEnclosure::new(&f, &set, &domain, Copies::Shared, &mut w).unwrap();
        let image = enclosure.image(&set, &mut w).unwrap();
        assert_eq!(enclosure.curvature().num_constraints(), 0);
        assert!(lies_in(&image, &values(&f, &members[0].x)), "seed {SEED}+6 case {case}: {f:?} {set:?}");
    }
}

/// A remainder of rounding size next to the center adds no coordinates, however small the set.
#[test]
fn rounding_around_a_point_is_no_generator() {
    let mut w = Workspace::new();
    let mut set = ConstrainedZonotope::from_box(&[1.0, -3.0], &[0.0; 2]).unwrap();
    set.add_box(&[Interval::ZERO.inflate(1e-16); 2]).unwrap();
    assert_eq!(set.num_generators(), 0);
    let hull = set.interval_hull(&mut w.sets).unwrap();
    let domain = Domain::new(&hull, set.center());
    let product = nonlin_bounds::function!(|[x, y]: 2| -> 1 { [x * y] });
    let enclosure = QuadraticEnclosure::new(&product, &set, &domain, Copies::Shared, &mut w).unwrap();
    assert_eq!(enclosure.curvature().num_generators(), 0);
    let image = enclosure.image(&set, &mut w).unwrap().interval_hull(&mut w.sets).unwrap()[0];
    assert!(image.contains(-3.0) && image.width() < 3e-14, "{image:?}");
}

/// Panics if `x` is proven not to lie in the set.
fn refute(set: &ConstrainedZonotope, x: &[Dyadic], w: &mut Workspace, context: &dyn Fn() -> String) {
    let point: Vec<Interval> = x.iter().map(|x| around(x, 0.0, 0.0)).collect();
    assert_ne!(set.membership(&point, &mut w.sets).unwrap(), Membership::ProvenOutside, "{}", context());
}
