//! Images by DC programming.

use nonlin_bounds::{
    BoundError, ConvexSplit, DynFunction, Function, Jet, Operand, Order, Workspace, dc_image, dc_image_of_zonotope,
};
use scalars::{Interval, Scalar};
use setrep::{ConstrainedZonotope, Matrix, SetError, Zonotope};

use crate::common::functions::{Coupled, Domain, PlanarMap, Visitor, each};
use crate::common::polynomial::{Polynomials, rational};
use crate::common::random::{Random, cases};
use crate::generated::{Generated, Supports};

const SEED: u64 = 0x0003_4001;

/// The image by either function, as a constrained zonotope.
fn image(
    split: &ConvexSplit<'_>,
    set: &ConstrainedZonotope,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<ConstrainedZonotope, BoundError> {
    if set.num_constraints() > 0 {
        return dc_image(split, set, p, workspace);
    }
    Ok(dc_image_of_zonotope(split, set.unconstrained(), p, workspace)?.into())
}

/// Exact rational images of exact points under random polynomials.
#[test]
fn images_of_polynomials() {
    let (mut workspace, mut triples) = (Workspace::new(), 0);
    for case in 0..cases(600) {
        let mut random = Random::new(SEED, case);
        let n = 1 + random.below(3);
        let f = Polynomials::random(n, 2, 4, &mut random);
        let center: Vec<f64> = (0..n).map(|_| 2.0 * random.unit()).collect();
        let Generated { set, points } = Generated::within(&center, &vec![4.0; n], random.below(2) == 0, &mut random);
        let image = image(&ConvexSplit::Automatic(&f), &set, &[], &mut workspace).unwrap();
        assert_eq!(image.num_constraints(), set.num_constraints());
        let supports = Supports::of(&image, &mut random, &mut workspace);
        for point in &points {
            let exact: Vec<_> = point.iter().map(|&x| rational(x)).collect();
            let value: Vec<_> = (0..2).map(|i| f.exact(i, &exact)).collect();
            triples += 1;
            assert_eq!(supports.refute(&value), None, "seed {SEED} case {case}: {f:?} at {point:?} of {set:?}");
        }
    }
    println!("{triples} exact images inside");
    assert!(triples >= cases(5000));
}

/// The twelve functions, where they are proven smooth on the parallelotope.
#[test]
fn images_of_twelve_functions() {
    struct Images {
        triples: usize,
        refused: usize,
    }
    impl Visitor for Images {
        fn visit<F: Function + 'static>(&mut self, function: F, domain: Domain) {
            let f: &dyn DynFunction = &function;
            let (mut workspace, mut jet) = (Workspace::new(), Jet::new());
            let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p)).collect();
            // 2^12 vertices of the largest one.
            let count = if f.variables() > 10 { 4 } else { 40 };
            for case in 0..cases(count) {
                let mut random = Random::new(SEED + 1, case);
                let generated = Generated::within(&domain.center, &domain.radius, case % 2 == 0, &mut random);
                let image = match image(&ConvexSplit::Automatic(f), &generated.set, &p, &mut workspace) {
                    Ok(image) => image,
                    Err(BoundError::NotSmooth { .. }) => {
                        self.refused += 1;
                        continue;
                    }
                    Err(error) => panic!("{} case {case}: {error}", domain.name),
                };
                let supports = Supports::of(&image, &mut random, &mut workspace);
                for point in &generated.points {
                    let at: Vec<Interval> = point.iter().map(|&x| Interval::point(x)).collect();
                    f.enclose(Order::Value, &at, &p, &mut jet).unwrap();
                    self.triples += 1;
                    assert_eq!(supports.refute_box(jet.values()), None, "{} case {case} at {point:?}", domain.name);
                }
            }
        }
    }
    let mut images = Images { triples: 0, refused: 0 };
    each(&mut images);
    println!("{} images inside, {} sets refused", images.triples, images.refused);
    assert!(images.triples >= cases(3500));
}

/// `sin(x_1) x_2`, alone or with the squares that make a split.
struct SineProduct;

impl Function for SineProduct {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        1
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0].sin() * x[1];
    }
}

/// `sin(x_1) x_2 + s (x_1^2 + x_2^2)`, convex for `s = 1` where `|sin x_1| x_2 < 3 / 2`.
struct Convex {
    sine: bool,
    steepness: f64,
}

impl Function for Convex {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        1
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = (x[0].sqr() + x[1].sqr()).scale(self.steepness);
        if self.sine {
            y[0] += x[0].sin() * x[1];
        }
    }
}

/// The check of the notes: sampled errors of the linearisation of `sin(x_1) x_2` lie inside the bounds, which are not far from them.
#[test]
fn sine_times_a_variable() {
    let generators = Matrix::from_rows(&[&[0.25, 0.125], &[-0.125, 0.25]]).unwrap();
    let set = Zonotope::new(&[0.5, 1.0], &generators).unwrap();
    let mut workspace = Workspace::new();
    let split = ConvexSplit::Given {
        plus: &Convex { sine: true, steepness: 1.0 },
        minus: &Convex { sine: false, steepness: 1.0 },
    };
    let automatic = dc_image_of_zonotope(&ConvexSplit::Automatic(&SineProduct), &set, &[], &mut workspace).unwrap();
    let given = dc_image_of_zonotope(&split, &set, &[], &mut workspace).unwrap();
    // The sampled error of the linearisation.
    let (value, slope) = (0.5_f64.sin(), [0.5_f64.cos(), 0.5_f64.sin()]);
    let (mut least, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
    for i in -50..=50 {
        for j in -50..=50 {
            let (a, b) = (f64::from(i) / 50.0, f64::from(j) / 50.0);
            let z = [0.25 * a + 0.125 * b, -0.125 * a + 0.25 * b];
            let error = (0.5 + z[0]).sin() * (1.0 + z[1]) - value - slope[0] * z[0] - slope[1] * z[1];
            (least, largest) = (least.min(error), largest.max(error));
        }
    }
    for (name, image, factor) in [("automatic", automatic, 2.0), ("given", given, 5.0)] {
        // Both have the generators of the linearisation, and the error in the remainder.
        let error = Interval::point(image.center()[0] - value).inflate(image.remainder()[0]);
        println!("{name}: error in {error:?}, sampled [{least}, {largest}]");
        assert!(error.lo() <= least + 1e-12 && error.hi() >= largest - 1e-12, "{name}");
        assert!(error.width() <= factor * (largest - least), "{name}: {error:?} against [{least}, {largest}]");
    }
}

/// Parabolas and products on boxes: the bounds of the error are attained.
#[test]
fn attained_bounds() {
    let mut workspace = Workspace::new();
    let square = Polynomials { variables: 1, outputs: vec![vec![(1.0, vec![2])], vec![(-3.0, vec![2])]] };
    let set = ConstrainedZonotope::from_box(&[1.0], &[0.5]).unwrap();
    let image = dc_image(&ConvexSplit::Automatic(&square), &set, &[], &mut workspace).unwrap();
    // 1 + 2 z + [0, 1/4] and -3 - 6 z - [0, 3/4].
    let parts = |i: usize| (image.center()[i], image.remainder()[i], image.generators()[(i, 0)].abs());
    let close = |a: (f64, f64, f64), b: (f64, f64, f64)| {
        (a.0 - b.0).abs() < 1e-13 && (a.1 - b.1).abs() < 1e-13 && (a.2 - b.2).abs() < 1e-13
    };
    assert!(close(parts(0), (1.125, 0.125, 1.0)) && close(parts(1), (-3.375, 0.375, 3.0)), "{image:?}");

    let product = Polynomials { variables: 2, outputs: vec![vec![(1.0, vec![1, 1])]] };
    let sum =
        Polynomials { variables: 2, outputs: vec![vec![(0.25, vec![2, 0]), (0.5, vec![1, 1]), (0.25, vec![0, 2])]] };
    let difference =
        Polynomials { variables: 2, outputs: vec![vec![(0.25, vec![2, 0]), (-0.5, vec![1, 1]), (0.25, vec![0, 2])]] };
    let set = Zonotope::new(&[1.0, 2.0], &Matrix::from_diagonal(&[0.5, 0.25])).unwrap();
    for (split, radius) in [
        // z_1 z_2 itself, and the squares of the sum and the difference, a quarter each.
        (ConvexSplit::Automatic(&product as &dyn DynFunction), 0.125),
        (ConvexSplit::Given { plus: &sum, minus: &difference }, 0.75 * 0.75 / 4.0),
    ] {
        let image = dc_image_of_zonotope(&split, &set, &[], &mut workspace).unwrap();
        assert!((image.center()[0] - 2.0).abs() < 1e-13 && (image.remainder()[0] - radius).abs() < 1e-13, "{image:?}");
    }
}

/// A set along the diagonal: the parallelotope follows it, a box would not.
#[test]
fn the_parallelotope_follows_the_set() {
    let f = Polynomials { variables: 2, outputs: vec![vec![(1.0, vec![2, 0]), (-2.0, vec![1, 1]), (1.0, vec![0, 2])]] };
    let generators = Matrix::from_rows(&[&[1.0, 0.125], &[1.0, -0.125]]).unwrap();
    let set = Zonotope::new(&[0.0, 0.0], &generators).unwrap();
    let image = dc_image_of_zonotope(&ConvexSplit::Automatic(&f), &set, &[], &mut Workspace::new()).unwrap();
    let side = image.interval_hull()[0];
    assert!(side.lo() > -1e-12 && side.hi() < 1.0 / 16.0 + 1e-12, "{side:?}");
}

#[test]
fn bad_input() {
    let mut workspace = Workspace::new();
    let planar = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    let line = ConstrainedZonotope::from_box(&[0.0], &[1.0]).unwrap();
    let split = ConvexSplit::Automatic(&PlanarMap);
    let dimension = |operand, expected, found| BoundError::Dimension { operand, expected, found };
    let error = dc_image(&split, &line, &[], &mut workspace).unwrap_err();
    assert_eq!(error, dimension(Operand::Variables, 2, 1));
    let error = dc_image(&split, &planar, &[Interval::ONE], &mut workspace).unwrap_err();
    assert_eq!(error, dimension(Operand::Parameters, 0, 1));
    let mixed = ConvexSplit::Given { plus: &PlanarMap, minus: &SineProduct };
    assert_eq!(dc_image(&mixed, &planar, &[], &mut workspace).unwrap_err(), dimension(Operand::Outputs, 2, 1));

    // The pole x_1 = -4 lies in the set; a set with a contradiction; 17 dimensions.
    let wide = ConstrainedZonotope::from_box(&[0.0, 0.0], &[5.0, 1.0]).unwrap();
    assert!(matches!(dc_image(&split, &wide, &[], &mut workspace), Err(BoundError::NotSmooth { .. })));
    let mut empty = planar.clone();
    empty.intersect_strip(&[1.0, 0.0], Interval::new(5.0, 6.0).unwrap(), &mut workspace.sets).unwrap();
    assert_eq!(dc_image(&split, &empty, &[], &mut workspace).unwrap_err(), BoundError::Set(SetError::EmptySet));
    let large = ConstrainedZonotope::from_box(&[0.0; 17], &[1.0; 17]).unwrap();
    let error = dc_image(&ConvexSplit::Automatic(&Coupled { dim: 17 }), &large, &[], &mut workspace).unwrap_err();
    assert_eq!(error, BoundError::Set(SetError::TooManyDimensions { dim: 17, limit: 16 }));
}
