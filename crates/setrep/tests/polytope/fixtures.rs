//! Stored instances: the benchmark polytopes with exact counts, and inputs on which floating-point codes went wrong.

use std::path::PathBuf;

use setrep::{HPolytope, Matrix, SetError, VPolytope};

use crate::oracle;

fn rows(value: &serde_json::Value) -> Vec<Vec<f64>> {
    value.as_array().unwrap().iter().map(numbers).collect()
}

fn numbers(value: &serde_json::Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn slices(rows: &[Vec<f64>]) -> Vec<&[f64]> {
    rows.iter().map(Vec::as_slice).collect()
}

/// Counts of all stored instances, both ways.
#[test]
fn benchmark_polytopes_have_the_exact_counts() {
    let Some(folder) = std::env::var_os("ORBITOPE_DATA") else {
        println!("skipped: set ORBITOPE_DATA to the folder that holds peers/data/polytopes.json");
        return;
    };
    let file = PathBuf::from(folder).join("peers/data/polytopes.json");
    let stored: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    let mut instances = 0;
    for instance in stored["polytopes"].as_array().unwrap() {
        let name = format!("n {} {}", instance["n"], instance["kind"]);
        let expected =
            (instance["n_vertices"].as_u64().unwrap() as usize, instance["n_facets"].as_u64().unwrap() as usize);
        let found = if instance.get("H").is_some() {
            let set =
                HPolytope::new(Matrix::from_rows(&slices(&rows(&instance["H"]))).unwrap(), &numbers(&instance["h"]))
                    .unwrap();
            (set.to_v_polytope().unwrap().num_vertices(), set.remove_redundant().unwrap().num_half_spaces())
        } else {
            let set = VPolytope::new(Matrix::from_columns(&slices(&rows(&instance["V"]))).unwrap()).unwrap();
            (set.remove_redundant().unwrap().num_vertices(), set.to_h_polytope().unwrap().num_half_spaces())
        };
        assert_eq!(found, expected, "{name}");
        instances += 1;
    }
    assert_eq!(instances, 20);
}

/// Rows `b + a'x >= 0`, as in the reports.
fn from_inequalities(rows: &[&[f64]]) -> HPolytope {
    let n = rows[0].len() - 1;
    let mut normals = Matrix::zeros(rows.len(), n);
    for (i, row) in rows.iter().enumerate() {
        for k in 0..n {
            normals[(i, k)] = -row[k + 1];
        }
    }
    HPolytope::new(normals, &rows.iter().map(|row| row[0]).collect::<Vec<_>>()).unwrap()
}

fn assert_exact_vertices(set: &HPolytope, count: usize) {
    let exact = oracle::vertices(set);
    assert_eq!(exact.len(), count);
    assert!(oracle::match_columns(&exact, &set.to_v_polytope().unwrap()));
}

/// cddlib/cddlib#67: two nearly opposite rows; a floating-point code lost two of the five vertices.
#[test]
fn nearly_opposite_rows_keep_all_vertices() {
    assert_exact_vertices(
        &from_inequalities(&[
            &[-0.5367662906646729, 0.9292178750038147, 0.36953237652778625],
            &[0.39611172676086426, 0.058287363499403, -0.9982998371124268],
            &[-0.17240175604820251, -0.0582873672246933, 0.9982998371124268],
            &[-0.45, 1.0, 0.0],
            &[0.45, 0.0, -1.0],
            &[-0.35, 0.0, 1.0],
        ]),
        5,
    );
}

/// mcmtroffaes/pycddlib#93: a box with two more half-planes, moved by 1e-7, became unbounded in a floating-point code.
#[test]
fn a_box_stays_bounded() {
    for (first, second) in [
        (
            [1.3660253171818983, -0.49999999999999994, -0.8660254037844387],
            [0.36602545378443874, -0.8660254037844387, 0.49999999999999994],
        ),
        (
            [1.3660254037844386, -0.49999999999999994, -0.8660254037844387],
            [0.36602540378443876, -0.8660254037844387, 0.49999999999999994],
        ),
    ] {
        let set = from_inequalities(&[
            &first,
            &second,
            &[1.0, 0.0, 1.0],
            &[1.0, -1.0, 0.0],
            &[1.0, 0.0, -1.0],
            &[1.0, 1.0, 0.0],
        ]);
        let count = oracle::vertices(&set).len();
        assert!(count >= 4);
        assert_exact_vertices(&set, count);
    }
}

/// cddlib/cddlib#34: ten points near a common plane, called numerically inconsistent by a floating-point code.
#[test]
fn points_near_a_plane_have_their_facets() {
    let points: [&[f64]; 10] = [
        &[-8.02, -2.955, -2.412],
        &[-7.942, -2.622, -2.362],
        &[-7.956, -1.271, -2.403],
        &[-7.878, -0.937, -2.353],
        &[-7.763, 1.284, -2.392],
        &[-7.685, 1.617, -2.342],
        &[-7.699, 2.968, -2.383],
        &[-7.621, 3.301, -2.333],
        &[-6.495, 3.278, -1.779],
        &[0.773, 3.13, -2.645],
    ];
    let set = VPolytope::new(Matrix::from_columns(&points).unwrap()).unwrap();
    let (exact, _) = oracle::facets(set.vertices());
    let half_spaces = set.to_h_polytope().unwrap();
    assert_eq!(half_spaces.num_half_spaces(), exact.len());
    for v in points {
        assert!(oracle::lies_in(&v.iter().map(|&x| oracle::q(x)).collect::<Vec<_>>(), &half_spaces));
    }
}

/// The same idea in every dimension: a box with two of its facets repeated 1e-8 (and one ulp) apart, tilted by as little.
#[test]
fn nearly_equal_facets_lose_nothing() {
    for n in 2..=4 {
        for gap in [1e-8, f64::EPSILON, -1e-8] {
            let mut rows: Vec<Vec<f64>> = Vec::new();
            for k in 0..n {
                for sign in [1.0, -1.0] {
                    let mut row = vec![0.0; n + 1];
                    (row[0], row[k + 1]) = (1.0, sign);
                    rows.push(row);
                }
            }
            for k in 0..2 {
                let mut row = rows[2 * k].clone();
                row[0] += gap;
                row[(k + 1) % n + 1] = gap;
                rows.push(row);
            }
            let set = from_inequalities(&slices(&rows));
            let count = oracle::vertices(&set).len();
            assert_exact_vertices(&set, count);
        }
    }
}

/// A limit on the faces is kept: refused with a count, not after hours.
#[test]
fn budgets_refuse() {
    // The moment curve: a cyclic polytope, the most facets there can be.
    let columns: Vec<Vec<f64>> = (0..40).map(|t| (1..=6).map(|k| f64::from(t - 20).powi(k)).collect()).collect();
    let cyclic = VPolytope::new(Matrix::from_columns(&slices(&columns)).unwrap()).unwrap();
    match cyclic.to_h_polytope_within(1000) {
        Err(SetError::OverBudget { count, limit }) => assert!(count > 1000 && limit == 1000),
        other => panic!("{other:?}"),
    }
    let few = VPolytope::new(Matrix::from_columns(&slices(&columns[..10])).unwrap()).unwrap();
    // Gale's evenness condition: C(m - k, k) + C(m - k - 1, k - 1) facets of a cyclic polytope in 2k dimensions.
    assert_eq!(few.to_h_polytope().unwrap().num_half_spaces(), 35 + 15);
    let cube = HPolytope::from_intervals(&[scalars::Interval::new(0.0, 1.0).unwrap(); 10]).unwrap();
    assert!(matches!(cube.to_v_polytope_within(1000), Err(SetError::OverBudget { .. })));
    assert_eq!(cube.to_v_polytope_within(1024).unwrap().num_vertices(), 1024);
}
