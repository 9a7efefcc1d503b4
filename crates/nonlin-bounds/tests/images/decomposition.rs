//! Images and solution sets by remainder-form decomposition.

use nonlin_bounds::{
    BoundError, DynFunction, Function, Jet, Operand, Order, RangeMethod, Workspace, decomposition_image,
    decomposition_image_of_zonotope, decomposition_solution, range,
};
use scalars::{Interval, Scalar};
use setrep::{ConstrainedZonotope, Matrix, SetError, Zonotope};

use crate::common::functions::{Domain, PlanarMap, PlanarOutput, Visitor, each};
use crate::common::polynomial::{Polynomials, lies_in, rational};
use crate::common::random::{Random, cases};
use crate::generated::{Generated, Supports};

const SEED: u64 = 0x0003_3001;

/// The image by either function, as a constrained zonotope.
fn image(
    f: &dyn DynFunction,
    set: &ConstrainedZonotope,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<ConstrainedZonotope, BoundError> {
    if set.num_constraints() > 0 {
        return decomposition_image(f, set, p, workspace);
    }
    Ok(decomposition_image_of_zonotope(f, set.unconstrained(), p, workspace)?.into())
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
        let constrained = random.below(2) == 0;
        let Generated { set, points } = Generated::within(&center, &vec![4.0; n], constrained, &mut random);
        let image = image(&f, &set, &[], &mut workspace).unwrap();
        let supports = Supports::of(&image, &mut random, &mut workspace);
        for point in &points {
            let exact: Vec<_> = point.iter().map(|&x| rational(x)).collect();
            let value: Vec<_> = (0..2).map(|i| f.exact(i, &exact)).collect();
            triples += 1;
            let outside = supports.refute(&value);
            assert_eq!(outside, None, "seed {SEED} case {case}: {f:?} at {point:?} of {set:?}");
        }
    }
    println!("{triples} exact images inside");
    assert!(triples >= cases(5000));
}

/// The twelve functions: no image of a point is proven to lie outside.
#[test]
fn images_of_twelve_functions() {
    struct Images {
        triples: usize,
    }
    impl Visitor for Images {
        fn visit<F: Function + 'static>(&mut self, function: F, domain: Domain) {
            let f: &dyn DynFunction = &function;
            let (mut workspace, mut jet) = (Workspace::new(), Jet::new());
            let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p)).collect();
            for case in 0..cases(40) {
                let mut random = Random::new(SEED + 1, case);
                let generated = Generated::within(&domain.center, &domain.radius, case % 2 == 0, &mut random);
                let image = image(f, &generated.set, &p, &mut workspace)
                    .unwrap_or_else(|error| panic!("{} case {case}: {error}", domain.name));
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
    let mut images = Images { triples: 0 };
    each(&mut images);
    println!("{} images inside", images.triples);
    assert!(images.triples >= cases(4000));
}

/// Points whose exact values lie in `[y]` stay in the solution set.
#[test]
fn solution_sets_keep_the_solutions() {
    let (mut workspace, mut kept, mut cut) = (Workspace::new(), 0, 0);
    for case in 0..cases(600) {
        let mut random = Random::new(SEED + 2, case);
        let n = 1 + random.below(3);
        let g = Polynomials::random(n, 2, 3, &mut random);
        let center: Vec<f64> = (0..n).map(|_| 2.0 * random.unit()).collect();
        let Generated { set, points } = Generated::within(&center, &vec![4.0; n], random.below(2) == 0, &mut random);
        let exact = |point: &[f64], i: usize| g.exact(i, &point.iter().map(|&x| rational(x)).collect::<Vec<_>>());
        // A box around the value at the first point, unbounded on a side now and then.
        let mut first = [0.0; 2];
        DynFunction::value(&g, &points[0], &[], &mut first).unwrap();
        let width = [0.25, 1.0, 4.0][random.below(3)];
        let y = first.map(|y| {
            let lo = if random.below(6) == 0 { f64::NEG_INFINITY } else { y - width };
            Interval::new(lo, y + width).unwrap()
        });
        let solution = decomposition_solution(&g, &set, &y, &[], &mut workspace).unwrap();
        let supports = Supports::of(&solution, &mut random, &mut workspace);
        let inside = |value: &num_rational::BigRational, y: Interval| {
            lies_in(value, y) || (y.lo() == f64::NEG_INFINITY && *value <= rational(y.hi()))
        };
        for point in &points {
            let solves = (0..2).all(|i| inside(&exact(point, i), y[i]));
            let x: Vec<_> = point.iter().map(|&x| rational(x)).collect();
            let outside = supports.refute(&x);
            kept += usize::from(solves);
            cut += usize::from(outside.is_some());
            assert!(!solves || outside.is_none(), "seed {SEED} case {case}: {point:?} of {set:?}, {g:?}");
        }
    }
    println!("{kept} solutions kept, {cut} other points cut off");
    assert!(kept >= cases(2000) && cut >= cases(500));
}

/// The set of the authors' public example of the map (15) of paper 003.
fn example() -> ConstrainedZonotope {
    let decimal = |rows: &[&[f64]]| Matrix::from_rows(rows).unwrap();
    let generators = decimal(&[&[0.2, 0.4, 0.2], &[0.2, 0.0, -0.2]]);
    ConstrainedZonotope::from_cg_rep(&[-1.0, 1.0], &generators, &decimal(&[&[2.0, 2.0, 2.0]]), &[-3.0]).unwrap()
}

/// There the published form (shifts clamped at zero, one row an output, no cuts) has the upper bound 0.42 of the second output, and the tight range over
/// the hull without constraints -0.99. Exactly it is `f_2(-1.2, 0.9)` on the set, and `f_2(-0.2, 0.6)` on that hull.
#[test]
fn the_example_of_the_authors() {
    let (set, mut workspace) = (example(), Workspace::new());
    let mut tight = [Interval::EMPTY; 2];
    range(&PlanarMap, &set.unconstrained().interval_hull(), &[], RangeMethod::Tight, &mut workspace, &mut tight)
        .unwrap();
    assert!(tight[1].hi() < -1.2 + 3.0 * -0.2 * 0.6 / 3.8 + 1e-12);
    let hull = set.interval_hull(&mut workspace.sets).unwrap();
    range(&PlanarMap, &hull, &[], RangeMethod::Tight, &mut workspace, &mut tight).unwrap();

    let image = decomposition_image(&PlanarMap, &set, &[], &mut workspace).unwrap();
    let sides = image.interval_hull(&mut workspace.sets).unwrap();
    println!("tight range {tight:?}\nwithout constraints {:?}", image.unconstrained().interval_hull());
    println!("image {sides:?}, {} generators, {} constraints", image.num_generators(), image.num_constraints());
    assert!(image.unconstrained().interval_hull()[1].hi() < -1.9);
    assert!(sides.subset_of(&tight.map(|side| side.inflate(1e-12))) && sides[1].hi() < -2.6);
    // Sampled by the vertices of the set: -2.70.
    let exact = -1.8 + 3.0 * -1.2 * 0.9 / 2.8;
    assert!(sides[1].hi() - exact < 0.4, "{exact}");
}

/// Linear functions are mapped exactly but for rounding, the correlation of outputs included.
#[test]
fn linear_functions_are_exact() {
    let f = Polynomials {
        variables: 2,
        outputs: vec![
            vec![(2.0, vec![1, 0]), (-1.0, vec![0, 1]), (1.0, vec![0, 0])],
            vec![(0.5, vec![1, 0]), (3.0, vec![0, 1])],
        ],
    };
    let (mut workspace, set) = (Workspace::new(), example());
    let image = decomposition_image(&f, &set, &[], &mut workspace).unwrap();
    let map = Matrix::from_rows(&[&[2.0, -1.0], &[0.5, 3.0]]).unwrap();
    let mut exact = set.linear_map(&map).unwrap();
    exact.translate(&[1.0, 0.0]).unwrap();
    for direction in [[1.0, 0.0], [0.0, -1.0], [1.0, 1.0], [-1.0, 2.0], [-3.0, -0.5]] {
        let ours = image.support(&direction, &mut workspace.sets).unwrap();
        let least = exact.support(&direction, &mut workspace.sets).unwrap();
        assert!((ours - least).abs() < 1e-12, "{direction:?}: {ours} {least}");
    }
}

/// `(x_1 - x_2)^2` on a set along the diagonal: over the generators the derivative is small, over the axes of the hull it is not.
#[test]
fn generators_see_what_the_hull_does_not() {
    let f = Polynomials { variables: 2, outputs: vec![vec![(1.0, vec![2, 0]), (-2.0, vec![1, 1]), (1.0, vec![0, 2])]] };
    let generators = Matrix::from_rows(&[&[1.0, 0.125], &[1.0, -0.125]]).unwrap();
    let set = Zonotope::new(&[0.0, 0.0], &generators).unwrap();
    let image = decomposition_image_of_zonotope(&f, &set, &[], &mut Workspace::new()).unwrap();
    // The image is [0, 1/16], that of the hull [0, 5].
    let width = image.interval_hull()[0].width();
    println!("width {width}");
    assert!(width < 8.0 / 16.0 + 1e-12, "{width}");
}

/// Curved rows cut a set: the measurement (17) of paper 003 about a value in the middle.
#[test]
fn a_measurement_shrinks_the_set() {
    let set =
        ConstrainedZonotope::from_intervals(&[Interval::new(5.0, 6.0).unwrap(), Interval::new(0.0, 1.0).unwrap()])
            .unwrap();
    let mut workspace = Workspace::new();
    let y = [Interval::point(5.25).inflate(0.1), Interval::point(-2.25).inflate(0.1)];
    let solution = decomposition_solution(&PlanarOutput, &set, &y, &[], &mut workspace).unwrap();
    assert_eq!((solution.num_generators(), solution.num_constraints()), (2, 2));
    let hull = solution.interval_hull(&mut workspace.sets).unwrap();
    println!("{hull:?}");
    assert!(hull[0].width() < 0.75 && hull[1].width() < 0.4, "{hull:?}");
}

#[test]
fn bad_input() {
    struct Root;
    impl Function for Root {
        const VARIABLES: Option<usize> = Some(1);
        fn outputs(&self) -> usize {
            1
        }
        fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
            y[0] = x[0].sqrt();
        }
    }
    let mut workspace = Workspace::new();
    let planar = example();
    let one = ConstrainedZonotope::from_box(&[0.5], &[1.0]).unwrap();
    let dimension = |operand, expected, found| BoundError::Dimension { operand, expected, found };
    let error = decomposition_image(&PlanarMap, &one, &[], &mut workspace).unwrap_err();
    assert_eq!(error, dimension(Operand::Variables, 2, 1));
    let error = decomposition_image(&PlanarMap, &planar, &[Interval::ONE], &mut workspace).unwrap_err();
    assert_eq!(error, dimension(Operand::Parameters, 0, 1));
    let error = decomposition_solution(&PlanarOutput, &planar, &[Interval::ONE], &[], &mut workspace).unwrap_err();
    assert_eq!(error, dimension(Operand::Outputs, 2, 1));
    let error = decomposition_solution(&PlanarOutput, &planar, &[Interval::ONE, Interval::EMPTY], &[], &mut workspace);
    assert_eq!(error.unwrap_err(), BoundError::EmptyInterval { operand: Operand::Outputs, index: 1 });
    let error = decomposition_image(&Root, &one, &[], &mut workspace).unwrap_err();
    assert!(matches!(error, BoundError::NotSmooth { output: 0, .. }), "{error}");

    // A set that is proven empty, and one whose constraints exclude the pole that its generators reach.
    let mut empty = planar.clone();
    empty.intersect_strip(&[1.0, 0.0], Interval::new(5.0, 6.0).unwrap(), &mut workspace.sets).unwrap();
    let error = decomposition_image(&PlanarMap, &empty, &[], &mut workspace).unwrap_err();
    assert_eq!(error, BoundError::Set(SetError::EmptySet));
    let mut positive = one.clone();
    positive.intersect_strip(&[1.0], Interval::new(0.25, 9.0).unwrap(), &mut workspace.sets).unwrap();
    let image = decomposition_image(&Root, &positive, &[], &mut workspace).unwrap();
    let side = image.interval_hull(&mut workspace.sets).unwrap()[0];
    assert!(side.lo() > 0.4999 && side.hi() < 1.2248, "{side:?}");
}
