//! Polynomials on random sets in exact arithmetic: affine enclosures, images and solution sets of every form.

use nonlin_bounds::{AffineEnclosure, Domain, DynFunction, Form, OutputStrip, Workspace};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Zonotope};

use crate::SEED;
use crate::members::{around, constrained, is_enclosed, is_proven_member, on_grid, values};
use crate::polynomials::Polynomials;
use crate::sets::dyadic::Dyadic;
use crate::sets::exact::{Member, is_mapped_witness};
use crate::sets::random::{Random, cases};

const FORMS: [Form; 4] = [Form::Natural, Form::MeanValue, Form::Slope, Form::Taylor];

/// One function, one set, one expansion point.
struct Case {
    f: Polynomials,
    set: ConstrainedZonotope,
    members: Vec<Member>,
    hull: Vec<Interval>,
    at: Vec<f64>,
    noises: usize,
}

fn draw(case: usize, seed: u64, workspace: &mut Workspace) -> Case {
    let mut random = Random::new(seed, case);
    let n = random.between(1, 4);
    let (set, members) = if random.below(2) == 0 { on_grid(&mut random, n, 3) } else { constrained(&mut random, n, 3) };
    let hull = set.interval_hull(&mut workspace.sets).unwrap().to_vec();
    let outputs = random.between(1, 3);
    let f = Polynomials::random(&mut crate::common::random::Random::new(seed, case), n, outputs);
    // The middle, the center if it is in the hull or not, or any point.
    let at = match random.below(4) {
        0 => set.center().to_vec(),
        1 => hull.iter().map(|side| side.mid() + 0.9 * random.moderate() * side.rad()).collect(),
        _ => hull.iter().map(Interval::mid).collect(),
    };
    Case { f, set, members, hull, at, noises: random.below(n + 1) }
}

/// The image of every member lies in the enclosure and, by an explicit witness, in the images of the zonotope and the constrained
/// zonotope.
#[test]
fn images_contain_exact_images() {
    let (mut w, mut enclosure, mut triples) = (Workspace::new(), AffineEnclosure::new(), 0);
    for case in 0..cases(1_300) {
        let Case { f, set, members, hull, at, noises } = draw(case, SEED, &mut w);
        let body: Zonotope = set.unconstrained().clone();
        let wide = body.interval_hull();
        for form in FORMS {
            let context = || format!("{form:?}, seed {SEED} case {case}: {f:?} {set:?} {at:?}");
            for (hull, constrained) in [(&hull[..], true), (&wide[..], false)] {
                let domain = Domain::new(hull, &at).with_noises(noises);
                enclosure.enclose(form, &f, &domain, &mut w).unwrap_or_else(|e| panic!("{e}: {hull:?} {}", context()));
                let (image, plain) = (enclosure.image(&set, &mut w).unwrap(), enclosure.image(&body, &mut w).unwrap());
                for member in &members {
                    let y = values(&f, &member.x);
                    assert!(is_enclosed(&enclosure, &member.x, &y), "enclosure, {}", context());
                    let inside = if constrained {
                        is_proven_member(&set, &image, member, &[], &y)
                    } else {
                        is_mapped_witness(&body, &plain, member, &y)
                    };
                    assert!(inside, "image, {}", context());
                    triples += 1;
                }
            }
        }
    }
    assert!(triples >= 30_000);
}

/// Members whose value lies in `Y` stay in the set: with the last variables as noises in their hull, and with `Y` as a set.
#[test]
fn solution_sets_contain_exact_solutions() {
    let (mut w, mut enclosure, mut triples) = (Workspace::new(), AffineEnclosure::new(), 0);
    for case in 0..cases(1_300) {
        let Case { f, set, members, hull, at, noises } = draw(case, SEED + 1, &mut w);
        let mut random = Random::new(SEED + 2, case);
        let n = hull.len();
        let states = n - noises.min(n - 1);
        for form in FORMS {
            let context = || format!("{form:?}, seed {SEED}+1 case {case}: {f:?} {set:?} {at:?}");
            let domain = Domain::new(&hull, &at).with_noises(n - states);
            enclosure.enclose(form, &f, &domain, &mut w).unwrap();
            for member in &members {
                let y = values(&f, &member.x);
                let sides = sides(&mut random, &y);
                let mut cut = set.clone();
                enclosure.intersect(&mut cut, &sides, &mut w).unwrap();
                assert!(is_proven_member(&set, &cut, member, &[], &member.x), "box, {}", context());
                assert!(cut.num_generators() <= set.num_generators() + n, "no slack columns");
                // The states alone, the noises ranging over the box.
                let projection = projected(&set, states);
                let mut cut = projection.clone();
                enclosure.intersect(&mut cut, &sides, &mut w).unwrap();
                let alone = Member {
                    xi: member.xi.clone(),
                    eta: member.eta[..states].to_vec(),
                    x: member.x[..states].to_vec(),
                };
                assert!(is_proven_member(&projection, &cut, &alone, &[], &alone.x), "noises, {}", context());
                // A set of values in the middle of which the value lies.
                let center: Vec<f64> = y.iter().map(Dyadic::approx).collect();
                let radii: Vec<f64> = y.iter().map(|y| 1e-12 * (1.0 + y.approx().abs())).collect();
                let target = ConstrainedZonotope::from_box(&center, &radii).unwrap();
                let mut cut = set.clone();
                enclosure.intersect_set(&mut cut, &target, &mut w).unwrap();
                assert!(is_proven_member(&set, &cut, member, &[], &member.x), "set, {}", context());
                triples += 3;
            }
        }
    }
    assert!(triples >= 30_000);
}

/// The strip of an output, its parts evaluated apart, holds every member whose value lies in `Y`; the range of the output its value.
#[test]
fn strips_of_outputs_contain_exact_solutions() {
    let (mut w, mut strip, mut checks) = (Workspace::new(), OutputStrip::new(), 0);
    let lies_in = |x: &Dyadic, range: Interval| {
        (range.lo() == f64::NEG_INFINITY || *x >= Dyadic::from(range.lo()))
            && (range.hi() == f64::INFINITY || *x <= Dyadic::from(range.hi()))
    };
    for case in 0..cases(1_300) {
        let Case { f, members, hull, noises, .. } = draw(case, SEED + 4, &mut w);
        let mut random = Random::new(SEED + 5, case);
        let states = hull.len() - noises.min(hull.len() - 1);
        for member in &members {
            let y = values(&f, &member.x);
            for (i, side) in sides(&mut random, &y).into_iter().enumerate() {
                strip.enclose(&f, i, &hull, states, &[], side, &mut w).unwrap();
                let along = strip
                    .direction()
                    .iter()
                    .zip(&member.x)
                    .fold(Dyadic::zero(), |sum, (&a, x)| &sum + &(&Dyadic::from(a) * x));
                assert!(lies_in(&along, strip.range()), "seed {SEED}+4 case {case}: {f:?} {strip:?} {hull:?}");
                assert!(lies_in(&y[i], strip.predicted()), "seed {SEED}+4 case {case}: {f:?} {strip:?} {hull:?}");
                checks += 1;
            }
        }
    }
    assert!(checks >= 5_000, "{checks}");
}

/// The rows bind: a value outside the range of the enclosure proves that there is no solution.
#[test]
fn values_out_of_reach_leave_nothing() {
    let (mut w, mut enclosure, mut empty) = (Workspace::new(), AffineEnclosure::new(), 0);
    for case in 0..cases(200) {
        let Case { f, set, hull, at, .. } = draw(case, SEED + 3, &mut w);
        enclosure.enclose(Form::Taylor, &f, &Domain::new(&hull, &at), &mut w).unwrap();
        let mut range = vec![Interval::ZERO; DynFunction::outputs(&f)];
        enclosure.range_into(&mut range).unwrap();
        let beyond: Vec<Interval> = range.iter().map(|r| Interval::point(r.hi() + 1.0 + 1e-3 * r.mag())).collect();
        let mut cut = set.clone();
        enclosure.intersect(&mut cut, &beyond, &mut w).unwrap();
        empty += usize::from(cut.is_proven_empty(&mut w.sets).unwrap());
    }
    assert!(empty >= cases(200) * 98 / 100, "{empty}");
}

/// A box about a value, with or without width, one-sided now and then.
fn sides(random: &mut Random, y: &[Dyadic]) -> Vec<Interval> {
    let mut side = |y: &Dyadic| {
        let width = if random.below(2) == 0 { 0.0 } else { random.unit().abs() };
        let tight = around(y, width, 2.0 * width);
        match random.below(6) {
            0 => Interval::new(f64::NEG_INFINITY, tight.hi()).unwrap(),
            1 => Interval::new(tight.lo(), f64::INFINITY).unwrap(),
            _ => tight,
        }
    };
    y.iter().map(&mut side).collect()
}

/// The first coordinates of a set, exactly.
fn projected(set: &ConstrainedZonotope, states: usize) -> ConstrainedZonotope {
    let mut generators = setrep::Matrix::zeros(states, 0);
    set.generators().columns().for_each(|column| generators.push_col(&column[..states]).unwrap());
    let body = Zonotope::with_remainder(&set.center()[..states], &generators, &set.remainder()[..states]).unwrap();
    ConstrainedZonotope::with_constraints(&body, set.constraints(), set.ranges()).unwrap()
}
