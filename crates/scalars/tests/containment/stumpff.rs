//! Stumpff functions of points and boxes against their series in fixed point.

use scalars::{Interval, Scalar};

use crate::support::cases;
use crate::support::oracle::Fixed;
use crate::support::random::Random;

fn argument(random: &mut Random) -> f64 {
    match random.below(6) {
        0 => random.log_uniform(-300.0, 0.0),
        1 => random.uniform(-20.0, 20.0),
        2 => random.uniform(0.0, 500.0),
        3 => random.uniform(-200.0, 20.0),
        4 => random.uniform(0.0, 100.0), // past the first minima of C_1 and C_2
        _ => [0.0, 1.0, -1.0, 16.0, -16.0, 20.0, 64.0, 80.0][random.below(8) as usize],
    }
}

#[test]
fn points_are_enclosed() {
    let mut random = Random::new("Stumpff points", 21);
    let precision = Fixed { bits: 400 };
    let mut worst = [0.0_f64; 6];
    for _ in 0..cases(10_000) {
        let s = argument(&mut random);
        for k in 0..=5_u32 {
            let result = Interval::point(s).stumpff(k as usize);
            let exact = precision.enclose(&precision.stumpff(s, k));
            assert!(exact.may_lie_in(result), "C_{k}({s:e}) = {result:?} misses");
            let scale = result.mag().max(if k < 3 { 1e-3 } else { 0.0 });
            worst[k as usize] = worst[k as usize].max(result.width() / scale);
            // The plain function agrees with the enclosure to a few units of its scale.
            let plain = Scalar::stumpff(s, k as usize);
            assert!(
                (plain - result.mid()).abs() <= 1e-13 * result.mag().max(1e-3),
                "C_{k}({s:e}) = {plain} over f64, {result:?}"
            );
        }
    }
    println!("Stumpff C_0..C_5: widest enclosures of points relative to |C_k|: {worst:?}");
    assert!(worst.iter().all(|&w| w < 1e-11));
}

#[test]
fn ranges_enclose_values_of_members() {
    let mut random = Random::new("Stumpff boxes", 22);
    let precision = Fixed { bits: 400 };
    for _ in 0..cases(3_000) {
        let (a, b) = (argument(&mut random), argument(&mut random));
        let domain = Interval::new(a.min(b), a.max(b)).unwrap();
        let s = random.uniform(domain.lo(), domain.hi()).clamp(domain.lo(), domain.hi());
        for k in 0..=5_u32 {
            let range = domain.stumpff(k as usize);
            for s in [s, domain.lo(), domain.hi()] {
                let exact = precision.enclose(&precision.stumpff(s, k));
                assert!(exact.may_lie_in(range), "C_{k} {domain:?} = {range:?} misses at {s:e}");
            }
        }
    }
}

/// Up to s = 20 the range is that of the ends; no dependency, no jump at zero.
#[test]
fn ranges_are_tight_across_zero() {
    for k in 1..=5 {
        for (lo, hi) in [(-1e-3, 1e-3), (-4.0, 9.0), (0.0, 9.0), (-16.0, 16.0), (-20.0, 19.0)] {
            let range = Interval::new(lo, hi).unwrap().stumpff(k);
            let ends = Interval::point(lo).stumpff(k).hull(Interval::point(hi).stumpff(k));
            assert!(
                (range.width() - ends.width()).abs() <= 1e-12 * range.mag(),
                "C_{k} [{lo}, {hi}]: {range:?}, ends {ends:?}"
            );
        }
    }
}

#[test]
fn unbounded_and_unknown_arguments() {
    for k in 0..=5 {
        let right = Interval::new(0.0, f64::INFINITY).unwrap().stumpff(k);
        let left = Interval::new(f64::NEG_INFINITY, 0.0).unwrap().stumpff(k);
        assert!(right.is_bounded() && right.contains(Scalar::stumpff(30.0, k)), "C_{k}: {right:?}");
        assert!(left.hi() == f64::INFINITY && left.lo() > 0.0, "C_{k}: {left:?}");
        assert!(Interval::EMPTY.stumpff(k).is_empty());
    }
    assert_eq!(Interval::ONE.stumpff(21), Interval::ENTIRE);
}
