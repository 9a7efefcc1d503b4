//! Noises: affine ones exactly, additive ones for nothing, skew ones by their shape; Kuhn's inclusion.

use nonlin_bounds::{
    AffineEnclosure, Domain, DynFunction, Expansion, Form, Function, Jet, Order, Workspace, affine_image,
};
use scalars::{Interval, Scalar};
use setrep::{ConstrainedZonotope, IntervalMatrix, Matrix, Zonotope};

use crate::common::functions::PlanarMap;
use crate::planar::area;

/// `x + (1 + x) w`.
struct Gain;

impl Function for Gain {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        1
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0] + x[0].add_f64(1.0) * x[1];
    }
}

/// `(x_1^2 + w_1, x_1 x_2 + w_1 - w_2 / 10)`, and the last one in decimals that are no floats.
struct Additive;

impl Function for Additive {
    const VARIABLES: Option<usize> = Some(4);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0].sqr() + x[2];
        y[1] = x[0] * x[1] + x[2] - S::decimal("0.1") * x[3];
    }
}

fn side(radius: f64) -> Interval {
    Interval::point(0.0).inflate(radius)
}

/// Remark 8: the derivative by `w` at the expansion point is `1 + gamma`, without width.
#[test]
fn affine_noise_is_exact() {
    let mut w = Workspace::new();
    let mut enclosure = AffineEnclosure::new();
    let hull = [side(0.5), side(1.0)];
    enclosure.enclose(Form::MeanValue, &Gain, &Domain::new(&hull, &[0.0; 2]), &mut w).unwrap();
    assert!((enclosure.offsets()[0].rad() - 1.0).abs() < 1e-14);
    let domain = Domain::new(&hull, &[0.0; 2]).with_noises(1);
    enclosure.enclose(Form::MeanValue, &Gain, &domain, &mut w).unwrap();
    assert!((enclosure.offsets()[0].rad() - 0.5).abs() < 1e-14);
    // A known state: the noise alone, exactly.
    let hull = [Interval::point(0.25), side(1.0)];
    for form in [Form::MeanValue, Form::Slope, Form::Taylor] {
        let domain = Domain::new(&hull, &[0.25, 0.0]).with_noises(1);
        enclosure.enclose(form, &Gain, &domain, &mut w).unwrap();
        assert_eq!(enclosure.jacobian()[(0, 1)], 1.25, "{form:?}");
        assert!(enclosure.offsets()[0].contains(0.25) && enclosure.offsets()[0].width() < 1e-14, "{form:?}");
    }
}

/// Columns of constant derivative add nothing to the remainder, whatever the size of the noise.
#[test]
fn additive_noise_adds_no_remainder() {
    let mut w = Workspace::new();
    let mut enclosure = AffineEnclosure::new();
    let hull = [side(0.5), side(0.25), side(64.0), side(64.0)];
    // What x_1^2 and x_1 x_2 alone have; the range over the box does not help beside such noise.
    for (form, square, product) in [(Form::MeanValue, 1.0, 0.5), (Form::Slope, 0.5, 0.25), (Form::Taylor, 0.25, 0.25)] {
        enclosure.enclose(form, &Additive, &Domain::new(&hull, &[0.0; 4]), &mut w).unwrap();
        assert!((enclosure.offsets()[0].width() - square).abs() < 1e-14, "{form:?}");
        // 1/10 is no float: the rounding of its column is all that is added.
        assert!((enclosure.offsets()[1].width() - product).abs() < 64.0 * 4.0 * f64::EPSILON, "{form:?}");
    }
}

/// A box of additive noise costs no generators, stacked or not; unstacked noise that mixes outputs loses its shape, but no more.
#[test]
fn boxes_of_noise_cost_no_generators() {
    let mut w = Workspace::new();
    let generators = Matrix::from_rows(&[&[0.5, 0.0], &[0.125, 0.25]]).unwrap();
    let states = ConstrainedZonotope::from(Zonotope::new(&[1.0, 2.0], &generators).unwrap());
    let noise = ConstrainedZonotope::from_box(&[0.0; 2], &[0.0, 0.5]).unwrap();
    let stacked = states.cartesian_product(&noise);
    let hull = stacked.interval_hull(&mut w.sets).unwrap();
    let mut enclosure = AffineEnclosure::new();
    let at = [1.0, 2.0, 0.0, 0.0];
    enclosure.enclose(Form::Taylor, &Additive, &Domain::new(&hull, &at).with_noises(2), &mut w).unwrap();
    let image = enclosure.image(&stacked, &mut w).unwrap();
    let boxed = enclosure.image(&states, &mut w).unwrap();
    assert_eq!((image.num_generators(), boxed.num_generators()), (2, 2));
    for k in 0..2 {
        assert!((image.remainder()[k] - boxed.remainder()[k]).abs() < 1e-14);
    }
    // Second output: x_1 x_2 has the cross term 0.5 * 0.375, the noise has 0.05.
    assert!((boxed.remainder()[1] - (0.5 * 0.375 + 0.05)).abs() < 1e-12, "{:?}", boxed.remainder());
}

/// An affine function's image is its linear map.
#[test]
fn affine_functions_are_exact() {
    struct Affine;
    impl Function for Affine {
        const VARIABLES: Option<usize> = Some(2);
        fn outputs(&self) -> usize {
            2
        }
        fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
            y[0] = x[0].scale(3.0) - x[1] + S::from_f64(0.5);
            y[1] = x[0] + x[1].scale(0.25);
        }
    }
    let mut w = Workspace::new();
    let generators = Matrix::from_rows(&[&[0.5, 0.0, 1.0], &[0.125, 0.25, -1.0]]).unwrap();
    let set = Zonotope::new(&[1.0, 2.0], &generators).unwrap();
    let expected = set.linear_map(&Matrix::from_rows(&[&[3.0, -1.0], &[1.0, 0.25]]).unwrap()).unwrap();
    for form in [Form::Natural, Form::MeanValue, Form::Slope, Form::Taylor] {
        let image = affine_image(form, &Affine, &set, Expansion::HullCenter, &[], &mut w).unwrap();
        assert_eq!(image.generators(), expected.generators(), "{form:?}");
        if form == Form::Natural {
            // The range and the linear part are taken apart: the natural form knows of no dependency.
            assert!(image.remainder()[0] > 1.0);
        } else {
            assert!(image.remainder().iter().all(|&r| r < 1e-13), "{form:?} {image:?}");
        }
    }
}

/// Measurement noise that mixes outputs: as a set it keeps its shape, `{ x : x = -M v }`.
#[test]
fn skew_noise_keeps_its_shape() {
    struct Output;
    impl Function for Output {
        const VARIABLES: Option<usize> = Some(4);
        fn outputs(&self) -> usize {
            2
        }
        fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
            y[0] = x[0] + x[2].scale(0.5) + x[3].scale(0.25);
            y[1] = x[1] + x[2].scale(0.5) + x[3].scale(0.3125);
        }
    }
    let mut w = Workspace::new();
    let set = ConstrainedZonotope::from_box(&[0.0; 2], &[1.0; 2]).unwrap();
    let noise = ConstrainedZonotope::from_box(&[0.0; 2], &[1.0; 2]).unwrap();
    let hull = [side(1.0); 4];
    let mut enclosure = AffineEnclosure::new();
    let domain = Domain::new(&hull, &[0.0; 4]).with_noises(2);
    enclosure.enclose(Form::MeanValue, &Output, &domain, &mut w).unwrap();
    let (mut boxed, mut shaped) = (set.clone(), set.clone());
    enclosure.intersect(&mut boxed, &[Interval::ZERO; 2], &mut w).unwrap();
    enclosure.intersect_with_noise(&mut shaped, &[Interval::ZERO; 2], &noise, &mut w).unwrap();
    // The strips are [-3/4, 3/4] x [-13/16, 13/16]; the parallelogram has the area 4 det M, M = [1/2 1/4; 1/2 5/16].
    assert!((area(&boxed, &mut w.sets) - 1.5 * 1.625).abs() < 1e-6);
    assert!((area(&shaped, &mut w.sets) - 4.0 / 32.0).abs() < 1e-6);
}

/// Fact 2.3 of paper 001: for a zonotope about its center, Kuhn's inclusion of `[J] G` is the mean value form over the hull.
#[test]
fn kuhns_inclusion_is_the_mean_value_form() {
    let mut w = Workspace::new();
    let generators = Matrix::from_rows(&[&[0.0625, 0.03125, -0.015625], &[0.03125, -0.0625, 0.03125]]).unwrap();
    let set = Zonotope::new(&[5.0, 0.5], &generators).unwrap();
    let hull = set.interval_hull();
    let mut jet = Jet::new();
    PlanarMap.enclose(Order::Jacobian, &hull, &[], &mut jet).unwrap();
    let j = jet.jacobian();
    let jacobian = IntervalMatrix::from_intervals(2, 2, &[j[0], j[2], j[1], j[3]]).unwrap();
    let product = jacobian.mul(&IntervalMatrix::point(generators.clone()).unwrap()).unwrap();
    let image = affine_image(Form::MeanValue, &PlanarMap, &set, Expansion::HullCenter, &[], &mut w).unwrap();
    for i in 0..2 {
        let kuhn: f64 = (0..3).map(|k| product.rad()[(i, k)]).sum();
        assert!((image.remainder()[i] / kuhn - 1.0).abs() < 1e-12, "{} {kuhn}", image.remainder()[i]);
        for k in 0..3 {
            assert!((image.generators()[(i, k)] - product.mid()[(i, k)]).abs() < 1e-15);
        }
    }
}
