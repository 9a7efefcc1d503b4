//! Containment of exact images: linear map.

use setrep::{Matrix, Workspace, Zonotope};

use crate::SEED;
use crate::common::exact::{image, is_mapped_witness, is_witness, member};
use crate::common::random::{Random, cases};

#[test]
fn contains_exact_images() {
    let (mut stripped, mut rounded) = (0, 0);
    for case in 0..cases(30_000) {
        let mut random = Random::new(SEED, case);
        let (n, m) = (random.between(1, 6), random.between(0, 10));
        let p = if random.below(3) == 0 { random.between(1, 6) } else { n };
        let (set, map) = (random.set(n, m), random.matrix(p, n));
        let mapped = set.linear_map(&map).unwrap();
        let member = member(&set, &mut random);
        let x = image(&map, &member.x);
        assert!(is_mapped_witness(&set, &mapped, &member, &x), "seed {SEED} case {case}: {map:?} {set:?} {mapped:?}");
        if set.remainder().iter().all(|&r| r == 0.0) {
            let bare = Zonotope::new(mapped.center(), mapped.generators()).unwrap();
            rounded += 1;
            stripped += usize::from(!is_witness(&bare, &member.xi, &x));
        }
    }
    assert!(10 * stripped > rounded, "only {stripped} of {rounded} images need the rounding term");
}

/// The plain product is not an enclosure: 0.1 * 3 rounds up, so the image of the upper end is not attained from the rounded center.
#[test]
fn the_rounding_term_is_needed() {
    let set = Zonotope::new(&[0.1], &Matrix::zeros(1, 0)).unwrap();
    let mapped = set.linear_map(&Matrix::from_rows(&[&[3.0]]).unwrap()).unwrap();
    let x = image(&Matrix::from_rows(&[&[3.0]]).unwrap(), &[crate::common::dyadic::Dyadic::from(0.1)]);
    assert!(is_witness(&mapped, &[], &x));
    assert!(!is_witness(&Zonotope::point(mapped.center()).unwrap(), &[], &x));
}

/// Underflow is rounding too: the exact image is not zero, the computed one is.
#[test]
fn underflow_is_covered() {
    for scale in [1e-200, 5e-324, 1e-310] {
        let set = Zonotope::new(&[scale], &Matrix::from_rows(&[&[1e-150, 3e-170]]).unwrap()).unwrap();
        let map = Matrix::from_rows(&[&[1e-160]]).unwrap();
        let mapped = set.linear_map(&map).unwrap();
        let mut random = Random::new(SEED, 0);
        for _ in 0..100 {
            let member = member(&set, &mut random);
            assert!(is_witness(&mapped, &member.xi, &image(&map, &member.x)));
        }
    }
}

/// Ten products of 0.4 of the smallest number all vanish, and their sum of four times it must come back in the remainder.
#[test]
fn every_underflow_counts() {
    let (tiny, shrink) = (0.4 * 2f64.powi(-74), Matrix::from_rows(&[&[2f64.powi(-1000)]]).unwrap());
    let set = Zonotope::new(&[0.0], &Matrix::from_rows(&[&[tiny; 10]]).unwrap()).unwrap();
    let mapped = set.linear_map(&shrink).unwrap();
    assert_eq!(mapped.generators().as_slice(), [0.0; 10]);
    assert!(mapped.remainder()[0] >= 4.0 * f64::from_bits(1));
}

/// Signed permutations and projections are exact, so they cost no remainder.
#[test]
fn selections_are_exact() {
    let mut random = Random::new(SEED, 1);
    let set = Zonotope::new(&[1.0, 2.0, 3.0], &random.matrix(3, 5)).unwrap();
    let select = Matrix::from_rows(&[&[0.0, -1.0, 0.0], &[1.0, 0.0, 0.0]]).unwrap();
    let selected = set.linear_map(&select).unwrap();
    assert_eq!((selected.center(), selected.remainder()), (&[-2.0, 1.0][..], &[0.0, 0.0][..]));
}

/// A box that is rotated keeps its shape: the remainder becomes generators first. Carried as `|R| r`, its hull would grow by a
/// factor of `sqrt 2` each step.
#[test]
fn model_size_remainders_do_not_wrap() {
    let mut set = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    let c = std::f64::consts::FRAC_1_SQRT_2;
    let rotation = Matrix::from_rows(&[&[c, -c], &[c, c]]).unwrap();
    let mut workspace = Workspace::new();
    for _ in 0..8 {
        set.linear_map_in_place(&rotation, &mut workspace).unwrap();
    }
    assert!((set.radius() - 1.0).abs() < 1e-13);
    assert_eq!(set.num_generators(), 2);
    assert!(set.remainder().iter().all(|&r| r < 1e-13));
}

/// A set of one point may be mapped for ever: its rounding wraps for a while, then becomes generators, two in some twenty steps.
#[test]
fn rounding_of_a_long_run_stays_small() {
    let mut set = Zonotope::point(&[1.0, 0.5]).unwrap();
    let rotation = Matrix::from_rows(&[&[0.8, -0.6], &[0.6, 0.8]]).unwrap();
    let mut workspace = Workspace::new();
    for _ in 0..1000 {
        set.linear_map_in_place(&rotation, &mut workspace).unwrap();
    }
    assert!(set.radius() < 1e-9, "radius {}", set.radius());
    assert!(set.num_generators() <= 120, "{} generators", set.num_generators());
}
