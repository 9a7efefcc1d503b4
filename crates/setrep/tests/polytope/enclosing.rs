//! Outer polytopes of bounded size: supersets, exactly, within the budget, and not much too large.

use setrep::{HPolytope, IntervalVector, Matrix, SetError, VPolytope, Workspace, Zonotope};

use crate::common::random::Random;
use crate::oracle::{Q, lies_in, q, vertices};
use crate::samples::{ALL_ENTRIES, Entries, cases, h_polytope, v_polytope};

const SEED: u64 = 41;

#[test]
fn outer_polytopes_contain_the_vertices_within_the_budget() {
    let mut workspace = Workspace::new();
    for case in 0..cases(300) {
        let mut random = Random::new(SEED, case);
        let n = random.between(1, 3);
        let (m, extra) = (random.between(1, 12), random.between(0, 9));
        let budget = 2 * n + random.between(0, 8);
        let hull = v_polytope(&mut random, n, m, ALL_ENTRIES[case % 3]);
        let outer = hull.enclosing_h_polytope(budget, &mut workspace).unwrap();
        assert!(outer.num_half_spaces() <= budget, "case {case}");
        for v in hull.vertices().columns() {
            assert!(lies_in(&v.iter().map(|&x| q(x)).collect::<Vec<Q>>(), &outer), "case {case}");
        }
        let set = h_polytope(&mut random, n, extra, ALL_ENTRIES[case % 3]);
        let corners = vertices(&set);
        for outer in [set.simplified(budget, &mut workspace), HPolytope::enclosing(&set, budget, &mut workspace)] {
            match outer {
                Ok(outer) => {
                    assert!(outer.num_half_spaces() <= budget, "case {case}");
                    assert!(corners.iter().all(|x| lies_in(x, &outer)), "case {case}");
                }
                Err(error) => assert!(error == SetError::EmptySet && corners.is_empty(), "case {case}: {error}"),
            }
        }
    }
}

/// With enough half-spaces nothing is lost; with fewer the area stays near.
#[test]
fn the_budget_is_spent_well() {
    let mut workspace = Workspace::new();
    for case in 0..cases(40) {
        let mut random = Random::new(SEED + 1, case);
        let set = v_polytope(&mut random, 2, 12, Entries::Generic);
        let facets = set.to_h_polytope().unwrap();
        let exact = set.volume().unwrap().mid();
        let all = facets.simplified(facets.num_half_spaces(), &mut workspace).unwrap();
        assert!((all.volume().unwrap().mid() / exact - 1.0).abs() < 1e-9, "case {case}");
        let mut before = f64::INFINITY;
        for budget in [4, 6, 8, 12] {
            let area = facets.simplified(budget, &mut workspace).unwrap().volume().unwrap().mid();
            assert!(area <= before * (1.0 + 1e-9) && area >= exact * (1.0 - 1e-9), "case {case}");
            before = area;
        }
        assert!(before < 1.15 * exact, "case {case}: {before} {exact}");
        let template = set.enclosing_h_polytope(12, &mut workspace).unwrap().volume().unwrap().mid();
        assert!(template < 1.3 * exact, "case {case}: {template} {exact}");
    }
    // A slanted parallelogram: its own directions are among the template.
    let slanted = Zonotope::new(&[3.0, 1.0], &Matrix::from_columns(&[&[2.0, 2.0], &[0.1, -0.1]]).unwrap()).unwrap();
    let outer = HPolytope::enclosing(&slanted, 8, &mut workspace).unwrap();
    assert!((outer.volume().unwrap().mid() - 1.6).abs() < 1e-9, "{outer:?}");
}

#[test]
fn bad_input_is_refused() {
    let mut workspace = Workspace::new();
    let square = HPolytope::from_intervals(&IntervalVector::from_center(&[0.0; 2], &[1.0; 2]).unwrap()).unwrap();
    assert_eq!(HPolytope::enclosing(&square, 3, &mut workspace), Err(SetError::OverBudget { count: 4, limit: 3 }));
    let wrong = HPolytope::enclosing_along(&square, &Matrix::identity(3), 8, &mut workspace);
    assert!(matches!(wrong, Err(SetError::Dimension { .. })));
    let wedge = HPolytope::new(Matrix::from_rows(&[&[1.0, 1.0]]).unwrap(), &[1.0]).unwrap();
    assert_eq!(HPolytope::enclosing(&wedge, 9, &mut workspace), Err(SetError::Unbounded));
    let point = VPolytope::new(Matrix::from_columns(&[&[0.1, 0.7, 2.0]]).unwrap()).unwrap();
    let outer = point.enclosing_h_polytope(6, &mut workspace).unwrap();
    assert_eq!(outer.bounding_box(&mut workspace).unwrap(), IntervalVector::point(&[0.1, 0.7, 2.0]));
}
