//! Strips: sizes against literal determinants and the least F-radius, known cuts, emptiness, bad input, allocations.

use scalars::Interval;
use setrep::{Matrix, Part, SetError, StripCut, StripRule, Workspace, Zonotope};

use crate::common::random::{Random, cases};

fn determinant(set: &Zonotope) -> f64 {
    let covariation = set.covariation();
    nalgebra::DMatrix::from_column_slice(set.dim(), set.dim(), covariation.as_slice()).determinant()
}

fn random_set(n: usize, m: usize, random: &mut Random) -> Zonotope {
    let entries: Vec<f64> = (0..n * m).map(|_| random.moderate()).collect();
    let center: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
    Zonotope::new(&center, &Matrix::from_column_slice(n, m, &entries).unwrap()).unwrap()
}

/// A strip across the set whose middle is off its center.
fn across(set: &Zonotope, a: &[f64], random: &mut Random) -> Interval {
    let reach = set.reach(a, &mut Workspace::new()).unwrap();
    let middle = reach.mid() + 0.45 * reach.rad() * random.moderate();
    Interval::point(middle).inflate(reach.rad() * (0.02 + random.moderate().abs()))
}

/// The rule takes the candidate whose literal determinant is least, the set itself among them.
#[test]
fn the_determinant_rule_takes_the_least_of_all_candidates() {
    let mut workspace = Workspace::new();
    let (mut cut_sets, mut kept) = (0, 0);
    for case in 0..cases(3000) {
        let mut random = Random::new(61, case);
        let n = random.between(1, 4);
        let m = n + random.below(6);
        let set = random_set(n, m, &mut random);
        let a: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
        let range = across(&set, &a, &mut random);
        let clipped = range.intersection(set.reach(&a, &mut workspace).unwrap());
        let mut least = determinant(&set);
        for column in set.generators().columns() {
            let along: f64 = a.iter().zip(column).map(|(a, g)| a * g).sum();
            let weights: Vec<f64> = column.iter().map(|g| g / along).collect();
            let mut candidate = set.clone();
            candidate.intersect_strip_by(&a, clipped, &weights, &mut workspace).unwrap();
            least = least.min(determinant(&candidate));
        }
        let mut cut = set.clone();
        let answer = cut.intersect_strip(&a, range, StripRule::Determinant, &mut workspace).unwrap();
        match answer {
            StripCut::Unchanged => kept += 1,
            _ => cut_sets += 1,
        }
        let found = determinant(&cut);
        assert!(found <= least * (1.0 + 1e-6) && found >= least * (1.0 - 1e-6), "case {case}: {found} {least}");
        assert_eq!(cut.num_generators(), set.num_generators());
    }
    println!("{cut_sets} cut, {kept} kept");
    assert!(cut_sets > 100 && kept > 100);
}

/// Other weights than those of the segment rule give a larger F-radius.
#[test]
fn the_segment_rule_is_a_minimum() {
    let mut workspace = Workspace::new();
    for case in 0..500 {
        let mut random = Random::new(62, case);
        let n = random.between(1, 4);
        let set = random_set(n, n + 3, &mut random);
        let a: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
        let range = across(&set, &a, &mut random);
        let mut cut = set.clone();
        let answer = cut.intersect_whole_strip(&a, range, StripRule::Segments, &mut workspace).unwrap();
        assert_eq!(answer, StripCut::Cut);
        let radius = cut.f_radius();
        assert!(radius <= set.f_radius());
        for step in [0.1, 0.01] {
            let sigma = range.rad();
            let spread: Vec<f64> = (0..n).map(|i| (0..n).map(|k| set.covariation()[(i, k)] * a[k]).sum()).collect();
            let total: f64 = a.iter().zip(&spread).map(|(a, s)| a * s).sum::<f64>() + sigma * sigma;
            let weights: Vec<f64> = spread.iter().map(|s| s / total + step * random.moderate()).collect();
            let mut other = set.clone();
            other.intersect_strip_by(&a, range, &weights, &mut workspace).unwrap();
            assert!(other.f_radius() >= radius * (1.0 - 1e-12), "case {case}");
        }
    }
}

/// A box cut along an axis is the smaller box; its remainder takes part as a generator.
#[test]
fn a_box_cut_along_an_axis_is_exact() {
    let mut set = Zonotope::from_box(&[1.0, 2.0], &[1.0, 3.0]).unwrap();
    let strip = Interval::new(0.25, 0.75).unwrap();
    let answer = set.intersect_strip(&[0.0, 0.5], strip, StripRule::Determinant, &mut Workspace::new()).unwrap();
    assert_eq!(answer, StripCut::Cut);
    let hull = set.interval_hull();
    for (side, (lo, hi)) in hull.iter().zip([(0.0, 2.0), (0.5, 1.5)]) {
        assert!((side.lo() - lo).abs() < 1e-14 && (side.hi() - hi).abs() < 1e-14, "{hull:?}");
    }
}

/// A flat set is cut within its span, and a point or a strip of no direction is left alone.
#[test]
fn flat_sets_are_cut_too() {
    let mut workspace = Workspace::new();
    let segment = Zonotope::new(&[0.0, 0.0], &Matrix::from_columns(&[&[1.0, 1.0]]).unwrap()).unwrap();
    let mut cut = segment.clone();
    let strip = Interval::point(0.5).inflate(0.25);
    assert_eq!(cut.intersect_strip(&[1.0, 0.0], strip, StripRule::Determinant, &mut workspace), Ok(StripCut::Cut));
    let hull = cut.interval_hull();
    assert!(hull.iter().all(|side| side.lo() > 0.25 - 1e-14 && side.hi() < 0.75 + 1e-14), "{hull:?}");
    // The strip follows a plane that the set does not leave.
    let mut same = segment.clone();
    assert_eq!(
        same.intersect_strip(&[1.0, -1.0], strip.add_f64(-0.5), StripRule::Determinant, &mut workspace),
        Ok(StripCut::Unchanged)
    );
    let mut point = Zonotope::point(&[1.0, 2.0]).unwrap();
    assert_eq!(
        point.intersect_strip(&[1.0, 0.0], Interval::ONE, StripRule::Determinant, &mut workspace),
        Ok(StripCut::Unchanged)
    );
    assert_eq!(
        same.intersect_strip(&[0.0, 0.0], Interval::ZERO, StripRule::Segments, &mut workspace),
        Ok(StripCut::Unchanged)
    );
    assert_eq!(same, segment);
    // An exact measurement leaves a point of the segment.
    assert_eq!(
        same.intersect_strip(&[1.0, 0.0], Interval::point(0.5), StripRule::Determinant, &mut workspace),
        Ok(StripCut::Cut)
    );
    assert!(same.radius() < 1e-14 && (same.center()[1] - 0.5).abs() < 1e-15);
}

/// Emptiness is proven with the reach, one-sided and unbounded strips are fine, and a strip that only touches is not empty.
#[test]
fn emptiness_and_unbounded_strips() {
    let mut workspace = Workspace::new();
    let set = random_set(3, 5, &mut Random::new(63, 0));
    let a = [1.0, -0.5, 0.25];
    let reach = set.reach(&a, &mut workspace).unwrap();
    let mut cut = set.clone();
    let beyond = Interval::new(reach.hi() + 1e-9, f64::INFINITY).unwrap();
    assert_eq!(
        cut.intersect_strip(&a, beyond, StripRule::Determinant, &mut workspace),
        Ok(StripCut::ProvenEmpty { reach })
    );
    for whole in [Interval::ENTIRE, reach] {
        assert_eq!(cut.intersect_strip(&a, whole, StripRule::Determinant, &mut workspace), Ok(StripCut::Unchanged));
    }
    assert_eq!(cut, set);
    let half = Interval::new(f64::NEG_INFINITY, reach.mid()).unwrap();
    assert_eq!(cut.intersect_strip(&a, half, StripRule::Segments, &mut workspace), Ok(StripCut::Cut));
    let mut touched = set.clone();
    let end = Interval::new(reach.hi(), f64::INFINITY).unwrap();
    let answer = touched.intersect_strip(&a, end, StripRule::Determinant, &mut workspace).unwrap();
    assert!(!matches!(answer, StripCut::ProvenEmpty { .. }));
}

#[test]
fn bad_strips_leave_the_set_as_it_was() {
    let mut workspace = Workspace::new();
    let set = Zonotope::with_remainder(&[1.0, 2.0], &Matrix::identity(2), &[0.125, 1e300]).unwrap();
    let mut cut = set.clone();
    let rule = StripRule::Determinant;
    assert_eq!(
        cut.intersect_strip(&[1.0], Interval::ONE, rule, &mut workspace),
        Err(SetError::Dimension { part: Part::Direction, expected: 2, found: 1 })
    );
    assert!(matches!(
        cut.intersect_strip(&[1.0, f64::NAN], Interval::ONE, rule, &mut workspace),
        Err(SetError::NonFinite { part: Part::Direction, row: 1, .. })
    ));
    assert_eq!(
        cut.intersect_strip(&[1.0, 1.0], Interval::EMPTY, rule, &mut workspace),
        Err(SetError::EmptyInterval { part: Part::Range, row: 0 })
    );
    assert_eq!(
        cut.intersect_whole_strip(&[1.0, 1.0], Interval::ENTIRE, rule, &mut workspace),
        Err(SetError::UnboundedInterval { part: Part::Range, row: 0, col: 0 })
    );
    assert_eq!(
        cut.intersect_strip_by(&[1.0, 1.0], Interval::ONE, &[0.0], &mut workspace),
        Err(SetError::Dimension { part: Part::Factor, expected: 2, found: 1 })
    );
    assert!(cut.intersect_strip_by(&[1.0, 1.0], Interval::ONE, &[0.0, f64::INFINITY], &mut workspace).is_err());
    assert!(matches!(
        cut.intersect_strip_by(&[1.0, 1.0], Interval::ONE, &[1e200, 1e200], &mut workspace),
        Err(SetError::Overflow { row: 0 })
    ));
    assert_eq!(cut, set);

    // Products that overflow leave weights of zero.
    let huge = Zonotope::new(&[0.0, 0.0], &Matrix::from_columns(&[&[1e200, 1.0]]).unwrap()).unwrap();
    let mut cut = huge.clone();
    for rule in [StripRule::Determinant, StripRule::Segments] {
        let answer = cut.intersect_strip(&[1e200, 0.0], Interval::ONE, rule, &mut workspace);
        assert!(matches!(answer, Ok(StripCut::Unchanged) | Err(SetError::Overflow { .. })), "{rule:?}: {answer:?}");
        assert_eq!(cut, huge);
    }
    assert!(cut.intersect_strip_by(&[1e200, 0.0], Interval::ONE, &[0.0, 0.0], &mut workspace).is_err());
    assert_eq!(cut, huge);
}

#[test]
fn warm_cuts_allocate_nothing() {
    for rule in [StripRule::Determinant, StripRule::Segments] {
        let mut random = Random::new(64, 0);
        let start = random_set(4, 10, &mut random);
        let directions: Vec<Vec<f64>> = (0..6).map(|_| (0..4).map(|_| random.moderate()).collect()).collect();
        let ranges: Vec<Interval> = directions.iter().map(|a| across(&start, a, &mut random).inflate(0.1)).collect();
        let (mut set, mut workspace, mut count) = (start.clone(), Workspace::new(), 0);
        let mut run = || {
            set.clone_from(&start);
            for (a, &range) in directions.iter().zip(&ranges) {
                count += usize::from(set.intersect_strip(a, range, rule, &mut workspace).unwrap() == StripCut::Cut);
            }
        };
        run();
        assert_eq!(allocation_counter::measure(&mut run).count_total, 0, "{rule:?}");
        assert!(count > 2, "{rule:?}");
    }
}
