//! Containment of exact images: membership.

use setrep::{IntervalVector, Matrix, Membership, Zonotope};

use crate::SEED;
use crate::common::exact::{exact, lies_in};
use crate::common::random::{Random, cases};

/// A point at about the given gauge, rounded to floats.
fn point_at(set: &Zonotope, gauge: f64, random: &mut Random) -> Vec<f64> {
    let xi = random.cube(set.num_generators());
    let mut x = set.center().to_vec();
    for (column, t) in set.generators().columns().zip(xi) {
        x.iter_mut().zip(column).for_each(|(x, g)| *x += g * t);
    }
    let eta = random.cube(set.dim());
    x.iter_mut().zip(set.remainder()).zip(eta).for_each(|((x, r), t)| *x += r * t);
    // Along this ray, the boundary is at 1 / gauge(x).
    let reach = set.gauge_approx(&x).unwrap();
    let factor = if reach > 0.0 && reach.is_finite() { gauge / reach } else { gauge };
    x.iter().zip(set.center()).map(|(x, c)| c + (x - c) * factor).collect()
}

#[test]
fn proofs_agree_with_exact_facets() {
    let total = cases(6_000);
    let (mut counts, mut clear, mut decided) = ([0; 3], 0, 0);
    for case in 0..total {
        let mut random = Random::new(SEED + 21, case);
        let (n, m) = (random.between(1, 3), random.between(0, 6));
        let set = random.set(n, m);
        let gauge = [0.0, 0.5, 0.99, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.01, 3.0][random.below(8)];
        let point = point_at(&set, gauge, &mut random);
        let verdict = set.membership(&IntervalVector::point(&point)).unwrap();
        let inside = lies_in(&set, &exact(&point));
        let context = format!("seed {SEED}+21 case {case}: {verdict:?}, exactly {inside}, {point:?} {set:?}");
        match verdict {
            Membership::ProvenInside => assert!(inside, "{context}"),
            Membership::ProvenOutside => assert!(!inside, "{context}"),
            Membership::Undecided => {}
        }
        counts[verdict as usize] += 1;
        // A set that only its rounding keeps from being flat leaves no room on either side of its points.
        let bare = Zonotope::new(set.center(), set.generators()).unwrap();
        let thick = bare.volume().unwrap().lo() > 0.0;
        if thick && (gauge - 1.0).abs() > 0.005 {
            clear += 1;
            decided += usize::from(verdict != Membership::Undecided);
        }
    }
    println!("membership: {counts:?} inside, outside, undecided; {decided} of {clear} clear cases decided");
    assert!(1000 * decided > 995 * clear, "{decided} of {clear} clear cases decided");
    assert!(counts[0] > total / 10 && counts[1] > total / 10);
}

/// A box around a point is inside only if all of it is, and outside only if none of it is.
#[test]
fn boxes_of_points() {
    let square = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    let around = |x: f64, r: f64| IntervalVector::from_center(&[x, 0.0], &[r, r]).unwrap();
    assert_eq!(square.membership(&around(0.5, 0.4)).unwrap(), Membership::ProvenInside);
    assert_eq!(square.membership(&around(1.0, 0.4)).unwrap(), Membership::Undecided);
    assert_eq!(square.membership(&around(1.5, 0.4)).unwrap(), Membership::ProvenOutside);
}

/// Two columns a few ulps apart: their computed normal is mostly rounding, and must not prove the point beyond the third inside. Where
/// the third is as short as the first two are apart, no other normal tells.
#[test]
fn nearly_parallel_generators() {
    let mut outside = 0;
    for case in 0..cases(300) {
        let mut random = Random::new(SEED + 22, case);
        let a: Vec<f64> = (0..3).map(|_| random.moderate()).collect();
        let b: Vec<f64> = a.iter().map(|x| x * (1.0 + (random.below(9) as f64 - 4.0) * f64::EPSILON)).collect();
        let length = [1e-2, 1e-15, 1e-16][random.below(3)];
        let c: Vec<f64> = (0..3).map(|_| length * random.moderate()).collect();
        let generators = Matrix::from_columns(&[&a, &b, &c]).unwrap();
        let set = Zonotope::new(&[0.0; 3], &generators).unwrap();
        let point: Vec<f64> = c.iter().map(|x| 1.01 * x).collect();
        let inside = lies_in(&set, &exact(&point));
        outside += usize::from(!inside);
        let verdict = set.membership(&IntervalVector::point(&point)).unwrap();
        let wrong = if inside { Membership::ProvenOutside } else { Membership::ProvenInside };
        assert_ne!(verdict, wrong, "seed {SEED}+22 case {case}: {set:?}");
    }
    assert!(outside > 200, "only {outside} points are outside");
}
