//! Figures 1 and 4 of paper 003 and Theorem 2 of paper 004 against independent computations.

use nonlin_bounds::{
    DynFunction, Expansion, Function, Jet, Order, Workspace, polytopic_solution, polytopic_solution_lift,
};
use scalars::{Interval, Scalar};
use scenarios::images::plane::{Measured, Shape};
use scenarios::images::{figure_1, figure_4, lemma_2, outline};
use scenarios::published::taylor::Cross;
use scenarios::published::theorem_2::updated_set;
use setrep::{HPolytope, Matrix, Membership, SupportFunction, VPolytope};

fn areas_agree(shapes: Vec<Shape>, points: &[Vec<Interval>]) {
    assert!(points.len() > 50);
    let mut workspace = setrep::Workspace::new();
    for shape in shapes {
        let set = Measured::of(shape, points, &mut workspace).unwrap();
        let (reference, name) = (set.shape.reference.unwrap(), (set.shape.row, set.shape.method, set.shape.mode));
        assert!((set.area - reference).abs() < 1e-5 * reference, "{name:?}: {} instead of {reference}", set.area);
        assert_eq!(set.containment.shares().unwrap().0, 1.0, "{name:?}");
    }
}

#[test]
fn figure_1_has_the_areas_of_an_independent_computation() {
    areas_agree(figure_1::published().unwrap(), &figure_1::images().unwrap());
}

#[test]
fn figure_4_has_the_areas_of_an_independent_computation() {
    areas_agree(figure_4::published(&mut setrep::Workspace::new()).unwrap(), &figure_4::arc());
}

/// The true state (1, 1) is cut off by the lemma as printed and kept by its correction.
#[test]
fn lemma_2_as_printed_loses_a_state() {
    let mut workspace = setrep::Workspace::new();
    assert_eq!(lemma_2::verdict(Cross::AsPrinted, &mut workspace).unwrap(), Membership::ProvenOutside);
    assert_ne!(lemma_2::verdict(Cross::Symmetrised, &mut workspace).unwrap(), Membership::ProvenOutside);
}

/// The measurement (17) of paper 003, without noise.
struct PlanarOutput;

impl Function for PlanarOutput {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0] - x[1].scale(0.5).sin();
        y[1] = x[1] - x[0] * x[1];
    }
}

/// Theorem 2 as the paper has it: the corners of all boxes, their half-spaces, the lifted polytope and its projection.
fn projected(set: &VPolytope, y: &HPolytope, q0: &[f64]) -> VPolytope {
    let (n, rows) = (set.dim(), y.num_half_spaces());
    let mut jet = Jet::new();
    PlanarOutput.enclose(Order::Jacobian, &set.interval_hull(), &[], &mut jet).unwrap();
    let mut value = [0.0; 2];
    PlanarOutput.value(q0, &[], &mut value).unwrap();
    let slope = |j: usize, k: usize| {
        (0..2).map(|i| jet.jacobian()[2 * i + k].scale(y.normals()[(j, i)])).reduce(|a, b| a + b).unwrap()
    };
    let mut corners = Matrix::zeros(rows, 0);
    for v in set.vertices().columns() {
        let half_width = |j: usize| (0..n).map(|k| slope(j, k).rad() * (v[k] - q0[k]).abs()).sum::<f64>();
        for signs in 0..1_usize << rows {
            let corner: Vec<f64> =
                (0..rows).map(|j| if signs >> j & 1 == 1 { half_width(j) } else { -half_width(j) }).collect();
            corners.push_col(&corner).unwrap();
        }
    }
    let boxes = VPolytope::new(corners).unwrap().remove_redundant().unwrap().to_h_polytope().unwrap();
    let outer = set.to_h_polytope().unwrap();
    let (first, second) = (outer.num_half_spaces(), boxes.num_half_spaces());
    let mut normals = Matrix::zeros(first + second + rows, n + rows);
    let mut offsets = [outer.offsets(), boxes.offsets()].concat();
    for i in 0..first {
        (0..n).for_each(|k| normals[(i, k)] = outer.normals()[(i, k)]);
    }
    for i in 0..second {
        (0..rows).for_each(|k| normals[(first + i, n + k)] = boxes.normals()[(i, k)]);
    }
    for j in 0..rows {
        let mut offset = y.offsets()[j] - (0..2).map(|i| y.normals()[(j, i)] * value[i]).sum::<f64>();
        for k in 0..n {
            normals[(first + second + j, k)] = slope(j, k).mid();
            offset += slope(j, k).mid() * q0[k];
        }
        normals[(first + second + j, n + j)] = 1.0;
        offsets.push(offset);
    }
    let lifted = HPolytope::new(normals, &offsets).unwrap().to_v_polytope().unwrap();
    let mut shadow = Matrix::zeros(n, n + rows);
    (0..n).for_each(|k| shadow[(k, k)] = 1.0);
    lifted.linear_map(&shadow).unwrap().remove_redundant().unwrap()
}

fn area(set: &dyn SupportFunction) -> f64 {
    outline::area(&outline::outline(set, &mut setrep::Workspace::new()).unwrap())
}

/// The lift over the simplex is the projection of the paper; with equal weights, or row by row, it is no larger.
#[test]
fn theorem_2_of_paper_004_is_the_lift_over_the_simplex() {
    let sets: [&[&[f64]]; 3] = [
        &[&[0.0, 0.0], &[1.0, 0.2], &[0.4, 1.0]],
        &[&[-0.2, -0.1], &[1.2, 0.1], &[1.0, 1.1], &[0.0, 0.9]],
        &[&[0.1, 0.3], &[0.5, 0.1], &[0.9, 0.3], &[0.9, 0.7], &[0.5, 0.9], &[0.1, 0.7]],
    ];
    for corners in sets {
        let set = VPolytope::new(Matrix::from_columns(corners).unwrap()).unwrap();
        let q0 = set.interval_hull().mid();
        let y =
            HPolytope::from_intervals(&[Interval::new(0.0, 0.3).unwrap(), Interval::new(0.2, 0.4).unwrap()]).unwrap();
        let (lift, literal) = (updated_set(&PlanarOutput, &set, &y, &q0).unwrap(), projected(&set, &y, &q0));
        let (a, b, whole) = (area(&lift), area(&literal), area(&set));
        assert!((a - b).abs() < 1e-9 && a < 0.9 * whole, "{a} {b} {whole}");
        let mut workspace = Workspace::new();
        let equal =
            polytopic_solution_lift(&PlanarOutput, &set, &y, Expansion::HullCenter, &[], &mut workspace).unwrap();
        let cut = polytopic_solution(&PlanarOutput, &set, &y, Expansion::HullCenter, &[], &mut workspace).unwrap();
        println!("{a} {} {}", area(&equal), area(&cut));
        assert!(area(&equal) < a + 1e-9 && area(&cut) < a + 1e-9);
    }
}
