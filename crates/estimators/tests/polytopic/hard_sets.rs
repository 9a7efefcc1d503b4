//! Flat, unbounded and crowded sets: a typed answer, or a result of bounded size.

use estimators::{Estimator, EstimatorError, Relation, System, Vh, VhOptions};
use nonlin_bounds::{Function, function};
use scalars::{Interval, Scalar};
use setrep::{HPolytope, Matrix, SetError, VPolytope, Zonotope};

use crate::plants::{Draw, planar, unicycle};
use crate::support::Random;

/// The budget is that of a box at least, and sets of other dimensions are refused.
#[test]
fn starts_that_do_not_fit_are_refused() {
    let example = planar(1.0);
    let mut options = VhOptions::paper();
    options.vertices = 3;
    let refused = Vh::new(example.system.clone(), example.vertices(), options).unwrap_err();
    assert_eq!(refused, EstimatorError::Size { what: "vertex budget", expected: 4, found: 3 });
    let line = VPolytope::from_intervals(&[Interval::ONE]).unwrap();
    assert!(matches!(Vh::new(example.system.clone(), line, options), Err(EstimatorError::Size { .. })));
    // A half-plane has no vertices to start from.
    let wedge = HPolytope::new(Matrix::from_rows(&[&[1.0, 1.0], &[-1.0, 0.0]]).unwrap(), &[1.0, 0.0]).unwrap();
    assert_eq!(wedge.to_v_polytope(), Err(SetError::Unbounded));
}

/// A segment and a point as `X_0`; the noise makes them thick.
#[test]
fn flat_starts_are_followed() {
    for columns in [vec![[0.2, 0.35], [0.8, 0.65]], vec![[0.8, 0.65]]] {
        let example = planar(1.0);
        let columns: Vec<&[f64]> = columns.iter().map(|v| &v[..]).collect();
        let start = VPolytope::new(Matrix::from_columns(&columns).unwrap()).unwrap();
        let mut filter = Vh::new(example.system.clone(), start, VhOptions::tight()).unwrap();
        for (k, (x, y)) in example.run(Draw::Vertex, 5, &mut Random::new(3)).iter().enumerate() {
            if k > 0 {
                filter.predict(&[]).unwrap();
                assert!(filter.enclosure().volume().unwrap().lo() > 0.0);
            }
            filter.update(y).unwrap();
            assert!(filter.hull().iter().zip(x).all(|(side, x)| x.subset_of(side)), "step {k}");
        }
    }
}

/// A box kept in the remainder, as of a zonotope without generators, is one by its corners: the measurement cuts it.
#[test]
fn a_start_with_a_remainder_of_model_size_is_cut() {
    let example = unicycle(1.0, 1.0);
    let start = example.start.to_v_polytope().unwrap();
    assert!(start.num_vertices() == 1 && start.remainder()[2] > 0.19);
    let mut filter = Vh::new(example.system.clone(), start, VhOptions::paper()).unwrap();
    assert_eq!(filter.enclosure().num_vertices(), 8);
    filter.update(&example.run(Draw::Uniform, 0, &mut Random::new(6))[0].1).unwrap();
    let (before, after) = (3.2e-4, filter.enclosure().volume().unwrap().mid());
    assert!(after < 0.2 * before, "{after:e}");
}

/// Without process noise vertices multiply from step to step; the budget holds, and no state is lost.
#[test]
fn the_vertex_budget_holds() {
    let example = unicycle(1.0, 0.0);
    let run = example.run(Draw::Uniform, 5, &mut Random::new(8));
    for budget in [8, 20, 64] {
        let mut options = VhOptions::paper();
        options.vertices = budget;
        let mut filter = example.vh(options);
        for (k, (x, y)) in run.iter().enumerate() {
            if k > 0 {
                filter.predict(&[]).unwrap();
            }
            filter.update(y).unwrap();
            assert!(filter.enclosure().num_vertices() <= budget, "step {k}");
            let member = filter.enclosure().membership(x).unwrap();
            assert_ne!(member, setrep::Membership::ProvenOutside, "budget {budget}, step {k}");
        }
    }
}

/// A cycle of four states with products.
struct Cycle;

impl Function for Cycle {
    const VARIABLES: Option<usize> = Some(8);
    fn outputs(&self) -> usize {
        4
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        for k in 0..4 {
            y[k] = x[k].scale(0.6) + x[(k + 1) % 4].scale(0.3) + (x[k] * x[(k + 2) % 4]).scale(0.05) + x[4 + k];
        }
    }
}

/// Four states, a start with more than a hundred vertices.
#[test]
fn four_states_with_many_vertices() {
    let sum = function!(|[a, b, c, d, v]: 5| -> 1 { [a + b.scale(0.5) - c * d + v] });
    let noise = Zonotope::from_box(&[0.0; 4], &[0.01; 4]).unwrap();
    let error = Zonotope::from_box(&[0.0], &[0.05]).unwrap();
    let system = System::new(Relation::new(Cycle), noise, Relation::new(sum), error).unwrap();
    let mut random = Random::new(4);
    let mut columns = Matrix::zeros(4, 0);
    for _ in 0..140 {
        let x: Vec<f64> = (0..4).map(|_| random.unit()).collect();
        let length = x.iter().map(|x| x * x).sum::<f64>().sqrt();
        columns.push_col(&x.iter().map(|x| x / length).collect::<Vec<_>>()).unwrap();
    }
    let start = VPolytope::new(columns).unwrap();
    let mut options = VhOptions::paper();
    options.vertices = 150;
    let mut filter = Vh::new(system, start, options).unwrap();
    assert!(filter.enclosure().num_vertices() >= 100);
    let mut x = vec![0.1, -0.2, 0.3, 0.1];
    for step in 0..3 {
        filter.update(&[x[0] + 0.5 * x[1] - x[2] * x[3]]).unwrap();
        filter.predict(&[]).unwrap();
        let mut next = vec![0.0; 4];
        Function::eval(&Cycle, &[&x[..], &[0.0; 4]].concat(), &[], &mut next);
        x = next;
        assert!(filter.enclosure().num_vertices() <= 150);
        assert!(filter.hull().iter().zip(&x).all(|(side, &x)| side.contains(x)), "step {step}");
        assert!(filter.hull().iter().all(|side| side.width() < 3.0), "step {step}: {:?}", filter.hull());
    }
}

/// A noise that mixes its components is as good as its vertices, and better than its hull.
#[test]
fn skew_noise_keeps_its_shape() {
    let shift = function!(|[x, y, w1, w2]: 4| -> 2 { [x + w1, y + w2] });
    let both = function!(|[x, y, v1, v2]: 4| -> 2 { [x + v1, y + v2] });
    let skew = Zonotope::new(&[0.0, 0.0], &Matrix::from_rows(&[&[1.0, 0.1], &[1.0, -0.1]]).unwrap()).unwrap();
    let system = System::new(Relation::new(shift), skew.clone(), Relation::new(both), skew).unwrap();
    let origin = VPolytope::new(Matrix::from_columns(&[&[0.0, 0.0]]).unwrap()).unwrap();
    let mut filter = Vh::new(system.clone(), origin, VhOptions::paper()).unwrap();
    filter.predict(&[]).unwrap();
    assert!((filter.enclosure().volume().unwrap().mid() - 0.8).abs() < 1e-9);
    // The parallelogram cut with the same one about (0.5, 0.5): 1.5 of its 2 units along, all across.
    filter.update(&[0.5, 0.5]).unwrap();
    assert!((filter.enclosure().volume().unwrap().mid() - 0.6).abs() < 1e-9, "{:?}", filter.enclosure().volume());
}
