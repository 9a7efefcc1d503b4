//! Containment of exact intersections with strips: the family for any weights, and both rules.

use scalars::Interval;
use setrep::{StripCut, StripRule, Workspace, Zonotope};

use crate::SEED;
use crate::common::dyadic::Dyadic;
use crate::common::exact::{Member, image, member, times};
use crate::common::random::{Random, cases};

/// Whether a result holds the member `x` of `set` with `a'x = v` in the strip `m +- sigma`. Its coordinates are those of the member, those of
/// the components of the remainder that became generators, and `(v - m) / sigma` for the strip's generator, at the end or in the place
/// of another. The check is multiplied by `sigma`, which makes it exact.
fn holds(set: &Zonotope, cut: &Zonotope, member: &Member, v: &Dyadic, strip: Interval) -> bool {
    let (m, sigma) = (Dyadic::from(strip.mid()), Dyadic::from(strip.rad()));
    let share = v - &m;
    assert!(share.clone().abs() <= sigma, "the member lies in the strip");
    let columns = set.num_generators();
    let is_proof = |xi: &[f64], place: usize| {
        let mut rest = xi.to_vec();
        rest[place] = 0.0;
        let inner = times(cut.generators(), &rest);
        (0..set.dim()).all(|i| {
            let residual = &(&member.x[i] - &Dyadic::from(cut.center()[i])) - &inner[i];
            let along = &Dyadic::from(cut.generators()[(i, place)]) * &share;
            let left = if sigma.is_zero() { residual } else { &(&residual * &sigma) - &along };
            let scale = if sigma.is_zero() { Dyadic::from(1.0) } else { sigma.clone() };
            left.abs() <= &scale * &Dyadic::from(cut.remainder()[i])
        })
    };
    (0_u32..1 << set.dim()).any(|rows| {
        let mut xi = member.xi.clone();
        xi.extend((0..set.dim()).filter(|k| rows >> k & 1 == 1).map(|k| member.eta[k]));
        match cut.num_generators() {
            // The strip's generator took the place of another.
            count if count == xi.len() => (0..count).any(|place| is_proof(&xi, place)),
            count if count == xi.len() + 1 => {
                xi.push(0.0);
                is_proof(&xi, count - 1)
            }
            _ => false,
        }
    }) && columns <= cut.num_generators()
}

/// A strip that holds the value `v`, narrow or wide.
fn around(v: &Dyadic, random: &mut Random) -> Interval {
    let width = v.approx().abs().max(1e-9) * 10f64.powi(random.below(18) as i32 - 16) + 1e-300;
    let share = random.unit().abs();
    let mut strip = Interval::new(v.approx() - share * width, v.approx() + (1.0 - share) * width).unwrap();
    let outside = |strip: Interval| *v < Dyadic::from(strip.lo()) || *v > Dyadic::from(strip.hi());
    while outside(strip) {
        strip = strip.inflate(strip.rad().max(f64::EPSILON * strip.mag()));
    }
    strip
}

#[test]
fn contains_exact_intersections() {
    let mut workspace = Workspace::new();
    let (mut cuts, mut stripped) = (0, 0);
    for case in 0..cases(20_000) {
        let mut random = Random::new(SEED, case);
        let (n, m) = (random.between(1, 4), random.between(0, 7));
        let (set, row) = (random.set(n, m), random.matrix(1, n));
        let a = row.as_slice();
        let member = member(&set, &mut random);
        let v = image(&row, &member.x).remove(0);
        let range = around(&v, &mut random);
        let mut cut = set.clone();
        let mut strip = range;
        let answer = match case % 5 {
            0 => {
                let weights: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
                cut.intersect_strip_by(a, range, &weights, &mut workspace).unwrap();
                StripCut::Cut
            }
            1 => cut.intersect_whole_strip(a, range, StripRule::Determinant, &mut workspace).unwrap(),
            2 => cut.intersect_whole_strip(a, range, StripRule::Segments, &mut workspace).unwrap(),
            kind => {
                strip = range.intersection(set.reach(a, &mut workspace).unwrap());
                let rule = if kind == 3 { StripRule::Determinant } else { StripRule::Segments };
                cut.intersect_strip(a, range, rule, &mut workspace).unwrap()
            }
        };
        match answer {
            StripCut::ProvenEmpty { reach } => panic!("seed {SEED} case {case}: {reach:?} misses {v:?}, {range:?}"),
            StripCut::Unchanged => assert_eq!(cut, set, "seed {SEED} case {case}"),
            StripCut::Cut => {
                assert!(
                    holds(&set, &cut, &member, &v, strip),
                    "seed {SEED} case {case}: {a:?} {range:?} {set:?} {cut:?}"
                );
                let bare = Zonotope::new(cut.center(), cut.generators()).unwrap();
                cuts += 1;
                stripped += usize::from(!holds(&set, &bare, &member, &v, strip));
            }
        }
    }
    println!("{stripped} of {cuts} cuts need the rounding term");
    assert!(2 * cuts > cases(20_000) && 4 * stripped > cuts, "{stripped} of {cuts}");
}

/// A weight that underflows does not lose what its generator had in that row.
#[test]
fn a_weight_that_underflows_loses_nothing() {
    let generators = setrep::Matrix::from_columns(&[&[1e20, 1e-310], &[1.0, 1.0]]).unwrap();
    let set = Zonotope::new(&[0.0, 0.0], &generators).unwrap();
    let mut cut = set.clone();
    let mut workspace = Workspace::new();
    let strip = Interval::point(0.0).inflate(0.5);
    let answer = cut.intersect_strip(&[1.0, 0.0], strip, StripRule::Determinant, &mut workspace).unwrap();
    assert_eq!(answer, StripCut::Cut);
    let xi = vec![2f64.powi(-70), 0.25];
    let member = Member { x: times(&generators, &xi), xi, eta: vec![0.0; 2] };
    let v = member.x[0].clone();
    assert!(holds(&set, &cut, &member, &v, strip));
    let bare = Zonotope::new(cut.center(), cut.generators()).unwrap();
    assert!(!holds(&set, &bare, &member, &v, strip));
}
