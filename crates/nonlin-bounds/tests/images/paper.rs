//! The figures of paper 003: Fig. 1 (images) and Fig. 4 (solution sets).

use nonlin_bounds::{
    AffineEnclosure, Copies, Domain, Expansion, Form, Function, QuadraticEnclosure, Workspace, affine_image,
};
use scalars::{Interval, Scalar};
use setrep::{ConstrainedZonotope, Matrix, Membership, Zonotope};

use crate::common::functions::UnitNorm;
use crate::planar::area;

/// The planar map (15), every variable written once a term: `x_1 x_2 / (4 + x_1) = x_2 - 4 x_2 / (4 + x_1)`.
struct PlanarMap;

impl Function for PlanarMap {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let quotient = x[1] * x[0].add_f64(4.0).recip();
        y[0] = x[0].scale(3.0) - S::ratio(1, 7) * x[0].sqr() - x[1].scale(4.0) + quotient.scale(16.0);
        y[1] = x[1] - quotient.scale(12.0);
    }
}

fn triangle() -> ConstrainedZonotope {
    let g = Matrix::from_rows(&[&[0.5, 1.0, -0.5], &[0.5, 0.5, 0.0]]).unwrap();
    let a = Matrix::from_rows(&[&[-1.0, 1.0, -1.0]]).unwrap();
    ConstrainedZonotope::from_cg_rep(&[5.0, 0.5], &g, &a, &[2.0]).unwrap()
}

/// Whether an area is the one of the notes, to its digits.
#[track_caller]
fn assert_area(set: &ConstrainedZonotope, expected: f64, workspace: &mut Workspace) {
    let area = area(set, &mut workspace.sets);
    assert!((area / expected - 1.0).abs() < 1e-5, "area {area}, expected {expected}");
}

/// Areas of enclosures of the image of the triangle: Proposition 2, and Proposition 1.
#[test]
fn figure_1() {
    let mut w = Workspace::new();
    let set = triangle();
    let hull = set.interval_hull(&mut w.sets).unwrap();
    let mut quadratic = |at: [f64; 2], copies| {
        let domain = Domain::new(&hull, &at);
        let enclosure = QuadraticEnclosure::new(&PlanarMap, &set, &domain, copies, &mut w).unwrap();
        enclosure.image(&set, &mut w).unwrap()
    };
    let (center, closest, middle) = ([5.0, 0.5], [5.5, 0.5], [5.75, 0.5]);
    let printed = quadratic(center, Copies::Separate);
    let shared = quadratic(center, Copies::Shared);
    let at_closest = quadratic(closest, Copies::Separate);
    let at_middle = quadratic(middle, Copies::Separate);
    let shared_at_closest = quadratic(closest, Copies::Shared);
    assert_area(&printed, 0.720_843, &mut w);
    assert_area(&shared, 0.720_843, &mut w);
    assert_area(&at_closest, 0.955_999, &mut w);
    assert_area(&at_middle, 1.084_798, &mut w);
    // Shared coordinates gain wherever the expansion point is not the center.
    assert_area(&shared_at_closest, 0.795_602, &mut w);
    let range = printed.interval_hull(&mut w.sets).unwrap();
    for (bound, expected) in
        [(range[0].lo(), 10.25046), (range[0].hi(), 11.95997), (range[1].lo(), -0.42460), (range[1].hi(), 0.25428)]
    {
        assert!((bound - expected).abs() < 1e-5);
    }
    for (form, at, expected) in [
        (Form::MeanValue, middle, 0.327_099),
        (Form::MeanValue, closest, 0.427_367),
        // Beyond the paper: the slope form and the one-sided remainder.
        (Form::Slope, middle, 0.170_570),
        (Form::Taylor, middle, 0.142_073),
    ] {
        let image = affine_image(form, &PlanarMap, &set, Expansion::Point(&at), &[], &mut w).unwrap();
        assert_area(&image, expected, &mut w);
        assert_eq!((image.num_generators(), image.num_constraints()), (3, 1));
    }
}

/// Areas of the parts of the parallelogram, and of its intersection with the unit box, that may be on the unit circle:
/// Corollaries 1 and 2.
#[test]
fn figure_4() {
    let mut w = Workspace::new();
    let g = Matrix::from_rows(&[&[0.2, 0.2], &[0.0, 0.2]]).unwrap();
    let set = ConstrainedZonotope::from(Zonotope::new(&[1.3, 0.0], &g).unwrap());
    let mut inner = set.clone();
    inner.intersect_rows(&Matrix::identity(2), &[Interval::new(-1.0, 1.0).unwrap(); 2], &mut w.sets).unwrap();
    assert_area(&set, 0.16, &mut w);
    assert_area(&inner, 0.005, &mut w);
    for (set, mean_value, quadratic, taylor) in
        [(set, 0.041_605, 0.012_011_8, 0.007_396_45), (inner, 0.000_993_695, 0.004_319_44, 0.000_250_823)]
    {
        let hull = set.interval_hull(&mut w.sets).unwrap();
        let (mut middle, mut clamped) = ([0.0; 2], [0.0; 2]);
        Expansion::HullCenter.of_constrained(&set, &hull, &mut w, &mut middle).unwrap();
        Expansion::SetCenter.of_constrained(&set, &hull, &mut w, &mut clamped).unwrap();
        for (form, expected) in [(Form::MeanValue, mean_value), (Form::Taylor, taylor)] {
            let mut enclosure = AffineEnclosure::new();
            enclosure.enclose(form, &UnitNorm { dim: 2 }, &Domain::new(&hull, &middle), &mut w).unwrap();
            let mut cut = set.clone();
            enclosure.intersect(&mut cut, &[Interval::ZERO], &mut w).unwrap();
            assert_area(&cut, expected, &mut w);
            assert_eq!(cut.num_generators(), set.num_generators());
        }
        let domain = Domain::new(&hull, &clamped);
        let enclosure = QuadraticEnclosure::new(&UnitNorm { dim: 2 }, &set, &domain, Copies::Separate, &mut w).unwrap();
        let mut cut = set.clone();
        enclosure.intersect(&mut cut, &[Interval::ZERO], &mut w).unwrap();
        assert_area(&cut, quadratic, &mut w);
    }
}

struct Product;

impl Function for Product {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        1
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0] * x[1];
    }
}

/// The counterexample to Lemma 2 as printed: with the upper triangular `Q` in `L = p'Q` the row reads `-x_1 + zeta = 1`, which cuts off the
/// solution (1, 1).
#[test]
fn lemma_2_with_a_symmetric_matrix_keeps_the_state() {
    let mut w = Workspace::new();
    let square = ConstrainedZonotope::new(&[0.0; 2], &Matrix::identity(2), &Matrix::zeros(0, 2), &[]).unwrap();
    let hull = square.interval_hull(&mut w.sets).unwrap();
    for copies in [Copies::Shared, Copies::Separate] {
        let domain = Domain::new(&hull, &[0.0, -1.0]);
        let enclosure = QuadraticEnclosure::new(&Product, &square, &domain, copies, &mut w).unwrap();
        let mut cut = square.clone();
        enclosure.intersect(&mut cut, &[Interval::ONE], &mut w).unwrap();
        let verdict = cut.membership(&[Interval::ONE; 2], &mut w.sets).unwrap();
        assert_ne!(verdict, Membership::ProvenOutside, "{copies:?}");
        assert!(cut.support(&[1.0, 1.0], &mut w.sets).unwrap() >= 2.0, "{copies:?}");
    }
}
