//! Sizes: values by hand, and the same sets by other means.

use nonlin_bounds::{Expansion, Function, Workspace, polytopic_image, polytopic_solution, polytopic_solution_lift};
use scalars::{Interval, Scalar};
use setrep::{HPolytope, IntervalVector, Matrix, Membership, VPolytope};

use crate::common::functions::PlanarMap;
use crate::common::random::{Random, cases};

fn polygon(corners: &[&[f64]]) -> VPolytope {
    VPolytope::new(Matrix::from_columns(corners).unwrap()).unwrap()
}

fn area(set: &VPolytope) -> f64 {
    let volume = set.volume().unwrap();
    assert!(volume.width() < 1e-11);
    volume.mid()
}

/// `(x_1 + 2 x_2 + 3, x_1 - x_2)`.
struct Affine;

impl Function for Affine {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = (x[0] + x[1].scale(2.0)).add_f64(3.0);
        y[1] = x[0] - x[1];
    }
}

/// An affine function maps vertex to vertex: no corner is doubled, nothing is lost to the remainder.
#[test]
fn affine_images_are_exact() {
    let triangle = polygon(&[&[0.0, 0.0], &[4.0, 0.0], &[0.0, 2.0], &[1.0, 0.5]]);
    let image = polytopic_image(&Affine, &triangle, Expansion::Point(&[1.0, 1.0]), &[], &mut Workspace::new()).unwrap();
    assert_eq!(image.num_vertices(), 3);
    assert!(image.remainder().iter().all(|&r| r < 1e-13));
    assert!((area(&image) - 3.0 * 4.0).abs() < 1e-12);
}

/// `(x_1^2, x_1 + x_2)`.
struct SquareAndSum;

impl Function for SquareAndSum {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0].sqr();
        y[1] = x[0] + x[1];
    }
}

/// By hand: on `[0, 2]` about 1 the slope is in `[0, 4]`, so the square lies in `[-3, 1]` at 0 and in `[1, 5]` at 2. The second output has
/// no width: two corners a vertex, not four.
#[test]
fn boxes_around_vertices_are_as_by_hand() {
    let segment = polygon(&[&[0.0, 0.0], &[2.0, 0.0]]);
    let image =
        polytopic_image(&SquareAndSum, &segment, Expansion::Point(&[1.0, 0.0]), &[], &mut Workspace::new()).unwrap();
    assert_eq!(image.num_vertices(), 4);
    let hull = image.interval_hull();
    for (side, (lo, hi)) in hull.iter().zip([(-3.0, 5.0), (0.0, 2.0)]) {
        assert!(Interval::new(lo, hi).unwrap().subset_of(side) && side.width() < hi - lo + 1e-13);
    }
    // The parallelogram (-3, 0), (1, 0), (5, 2), (1, 2).
    assert!((area(&image) - 8.0).abs() < 1e-12);
}

/// The remainder of the set is carried by `|[J]|`, not more.
#[test]
fn the_remainder_of_the_set_is_carried_over() {
    let set = VPolytope::with_remainder(Matrix::from_columns(&[&[1.0, 0.0]]).unwrap(), &[0.0, 0.5]).unwrap();
    let image = polytopic_image(&Affine, &set, Expansion::Point(&[1.0, 0.0]), &[], &mut Workspace::new()).unwrap();
    assert!((image.remainder()[0] - 1.0).abs() < 1e-14 && (image.remainder()[1] - 0.5).abs() < 1e-14);
}

/// Against the formula of the paper, `[Jlo v+ - Jhi v-, Jhi v+ - Jlo v-]` with all corners, in plain arithmetic.
#[test]
fn the_planar_map_has_the_area_of_the_printed_formula() {
    let corners: [[f64; 2]; 3] = [[6.5, 1.0], [5.5, 0.5], [5.0, 0.0]];
    let p0 = [5.75, 0.5];
    let mut value = [0.0; 2];
    PlanarMap.eval(&p0, &[], &mut value);
    let mut jet = nonlin_bounds::Jet::new();
    let hull = [Interval::new(5.0, 6.5).unwrap(), Interval::new(0.0, 1.0).unwrap()];
    nonlin_bounds::DynFunction::enclose(&PlanarMap, nonlin_bounds::Order::Jacobian, &hull, &[], &mut jet).unwrap();
    let mut points = Matrix::zeros(2, 0);
    for v in corners {
        let (mut low, mut high) = (value, value);
        for i in 0..2 {
            for k in 0..2 {
                let (slope, d) = (jet.jacobian()[2 * i + k], v[k] - p0[k]);
                low[i] += slope.lo() * d.max(0.0) - slope.hi() * (-d).max(0.0);
                high[i] += slope.hi() * d.max(0.0) - slope.lo() * (-d).max(0.0);
            }
        }
        for y in [[low[0], low[1]], [low[0], high[1]], [high[0], low[1]], [high[0], high[1]]] {
            points.push_col(&y).unwrap();
        }
    }
    let expected = area(&VPolytope::new(points).unwrap());
    let set = polygon(&[&corners[0], &corners[1], &corners[2]]);
    let image = polytopic_image(&PlanarMap, &set, Expansion::Point(&p0), &[], &mut Workspace::new()).unwrap();
    assert!((area(&image) - expected).abs() < 1e-9 * expected);
}

/// A row that is affine is a half-space: the square without a corner.
#[test]
fn affine_rows_cut_exactly() {
    let square = polygon(&[&[0.0, 0.0], &[1.0, 0.0], &[1.0, 1.0], &[0.0, 1.0]]);
    let y = HPolytope::new(Matrix::from_rows(&[&[1.0, 0.0]]).unwrap(), &[4.5]).unwrap();
    // x_1 + 2 x_2 <= 3/2
    let solution =
        polytopic_solution(&Affine, &square, &y, Expansion::Point(&[0.5, 0.5]), &[], &mut Workspace::new()).unwrap();
    assert!((area(&solution) - 0.5).abs() < 1e-12);
    assert_eq!(solution.num_vertices(), 4);
}

/// In a triangle the weights of a point are unique, so the set of one row is `{ x : sum_i l_i(x) low_i <= b }`, tried point by point.
#[test]
fn one_row_in_a_triangle_agrees_with_brute_force() {
    let mut workspace = Workspace::new();
    for case in 0..cases(40) {
        let random = &mut Random::new(7, case);
        let corners: Vec<[f64; 2]> = (0..3).map(|_| [2.0 * random.unit(), 2.0 * random.unit()]).collect();
        let set = polygon(&[&corners[0], &corners[1], &corners[2]]);
        let at = set.interval_hull().mid();
        let level = random.unit();
        let y = HPolytope::new(Matrix::from_rows(&[&[1.0, -0.5]]).unwrap(), &[level]).unwrap();
        // x_1^2 - (x_1 + x_2) / 2 <= level
        let side = set.interval_hull()[0];
        let slope = side.scale(2.0).add_f64(-0.5);
        let low = |v: &[f64]| {
            let d = v[0] - at[0];
            let term = if d > 0.0 { slope.lo() * d } else { slope.hi() * d };
            at[0] * at[0] - 0.5 * (at[0] + at[1]) + term - 0.5 * (v[1] - at[1])
        };
        let lows: Vec<f64> = corners.iter().map(|v| low(v)).collect();
        let solution = match polytopic_solution(&SquareAndSum, &set, &y, Expansion::Point(&at), &[], &mut workspace) {
            Ok(solution) => solution.to_h_polytope().unwrap(),
            Err(error) => {
                assert_eq!(error, setrep::SetError::EmptySet.into());
                assert!(lows.iter().all(|&low| low > level - 1e-12));
                continue;
            }
        };
        for _ in 0..200 {
            let mut weights = [random.fraction(), random.fraction(), random.fraction()];
            let sum: f64 = weights.iter().sum();
            weights.iter_mut().for_each(|w| *w /= sum);
            let x: Vec<f64> = (0..2).map(|k| (0..3).map(|i| weights[i] * corners[i][k]).sum()).collect();
            let excess = (0..3).map(|i| weights[i] * lows[i]).sum::<f64>() - level;
            let verdict = solution.membership(&IntervalVector::point(&x)).unwrap();
            if excess > 1e-9 {
                assert_eq!(verdict, Membership::ProvenOutside, "case {case}: {x:?} {excess}");
            } else if excess < -1e-9 {
                assert_eq!(verdict, Membership::ProvenInside, "case {case}: {x:?} {excess}");
            }
        }
    }
}

/// With one row the cut polytope and the lift are the same set.
#[test]
fn one_row_gives_the_same_set_twice() {
    let square = polygon(&[&[-1.0, -1.0], &[1.5, -1.0], &[1.0, 1.0], &[-1.0, 0.5]]);
    let mut workspace = Workspace::new();
    let y = HPolytope::new(Matrix::from_rows(&[&[1.0, -1.0]]).unwrap(), &[-0.25]).unwrap();
    let at = [0.0, 0.0];
    let solution = polytopic_solution(&SquareAndSum, &square, &y, Expansion::Point(&at), &[], &mut workspace).unwrap();
    let lift = polytopic_solution_lift(&SquareAndSum, &square, &y, Expansion::Point(&at), &[], &mut workspace).unwrap();
    for k in 0..64 {
        let angle = f64::from(k) * std::f64::consts::TAU / 64.0;
        let direction = [angle.cos(), angle.sin()];
        let (a, b) = (solution.support(&direction).unwrap(), lift.support(&direction, &mut workspace.sets).unwrap());
        assert!((a - b).abs() < 1e-12, "{direction:?}: {a} {b}");
    }
}

/// `x_1^2 = 1/4`, twice with the Jacobian over the smaller hull.
#[test]
fn a_second_pass_tightens() {
    let set = polygon(&[&[0.0, 0.0], &[2.0, 0.0], &[2.0, 1.0], &[0.0, 1.0]]);
    let y = HPolytope::from_intervals(&[Interval::point(0.25), Interval::new(-10.0, 10.0).unwrap()]).unwrap();
    let mut workspace = Workspace::new();
    let pass = |set: &VPolytope, workspace: &mut Workspace| {
        polytopic_solution(&SquareAndSum, set, &y, Expansion::HullCenter, &[], workspace).unwrap()
    };
    let first = pass(&set, &mut workspace);
    // About 1: 1 + [0, 4] (x - 1) = 1/4 for some slope cuts the weights to l_2 <= 13/16, and from below to nothing.
    assert!((first.interval_hull()[0].hi() - 13.0 / 8.0).abs() < 1e-12);
    let second = pass(&first, &mut workspace);
    assert!(second.interval_hull()[0].hi() < 1.5 && second.interval_hull()[0].contains(0.5));
}
