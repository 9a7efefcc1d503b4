//! Cubes, cross-polytopes, products of simplices: counts and volumes in closed form, in both representations, sheared too.

use setrep::{HPolytope, Matrix, VPolytope};

use crate::common::random::Random;
use crate::conversions::assert_encloses;
use crate::oracle::{Q, inverse_factorial, q};

/// The compositions of `2..=6` into dimensions of simplices: `[1, 1, 1]` is a cube, `[3]` a simplex.
fn compositions() -> Vec<Vec<usize>> {
    let mut all = vec![vec![]];
    let mut result = Vec::new();
    for _ in 0..6 {
        all = all
            .into_iter()
            .flat_map(|parts: Vec<usize>| {
                let (least, used) = (parts.last().copied().unwrap_or(1), parts.iter().sum::<usize>());
                (least..=6 - used.min(6)).map(move |part| [&parts[..], &[part]].concat())
            })
            .collect();
        result.extend(all.iter().filter(|parts| (2..=6).contains(&parts.iter().sum::<usize>())).cloned());
    }
    result
}

/// Vertices of the product of the simplices `conv { 0, s e_1, .., s e_k }`.
fn product_vertices(parts: &[usize], size: f64) -> Matrix {
    let n = parts.iter().sum();
    let mut columns: Vec<Vec<f64>> = vec![vec![]];
    for &k in parts {
        columns = columns
            .into_iter()
            .flat_map(|column| {
                (0..=k).map(move |vertex| {
                    let mut longer = column.clone();
                    longer.extend((0..k).map(|i| if i == vertex { size } else { 0.0 }));
                    longer
                })
            })
            .collect();
    }
    Matrix::from_column_slice(n, columns.len(), &columns.concat()).unwrap()
}

/// Half-spaces of the same: `-x_i <= 0`, and `sum x_i <= s` for each factor.
fn product_half_spaces(parts: &[usize], size: f64) -> HPolytope {
    let n: usize = parts.iter().sum();
    let mut normals = Matrix::zeros(n + parts.len(), n);
    let mut offsets = vec![0.0; n];
    for k in 0..n {
        normals[(k, k)] = -1.0;
    }
    let mut start = 0;
    for (i, &k) in parts.iter().enumerate() {
        for j in start..start + k {
            normals[(n + i, j)] = 1.0;
        }
        offsets.push(size);
        start += k;
    }
    HPolytope::new(normals, &offsets).unwrap()
}

/// A product of integer shears: determinant 1, exact on small integers.
fn unimodular(random: &mut Random, n: usize) -> Matrix {
    let mut map = Matrix::identity(n);
    for _ in 0..2 * n {
        let (i, j) = (random.below(n), random.below(n));
        if i != j {
            for k in 0..n {
                let change = map[(j, k)];
                map[(i, k)] += change;
            }
        }
    }
    map
}

#[test]
fn products_of_simplices() {
    let compositions = compositions();
    assert!(compositions.len() >= 25 && compositions.contains(&vec![1, 2, 3]) && compositions.contains(&vec![1; 6]));
    for (case, parts) in compositions.iter().enumerate() {
        for size in [1.0, 0.1] {
            let n = parts.iter().sum();
            let facets: usize = parts.iter().map(|k| k + 1).sum();
            let vertices: usize = parts.iter().map(|k| k + 1).product();
            let volume: Q =
                parts.iter().map(|&k| inverse_factorial(k)).product::<Q>() * (0..n).map(|_| q(size)).product::<Q>();
            let from_h = product_half_spaces(parts, size);
            let found = from_h.to_v_polytope().unwrap();
            assert_eq!(found.num_vertices(), vertices, "{parts:?}");
            assert_eq!(found.remainder(), vec![0.0; n], "float vertices are exact: {parts:?}");
            assert_eq!(from_h.remove_redundant().unwrap().num_half_spaces(), facets, "{parts:?}");
            assert_encloses(from_h.volume().unwrap(), &volume);

            let from_v = VPolytope::new(product_vertices(parts, size)).unwrap();
            assert_eq!(from_v.to_h_polytope().unwrap().num_half_spaces(), facets, "{parts:?}");
            assert_eq!(from_v.remove_redundant().unwrap().num_vertices(), vertices, "{parts:?}");
            assert_encloses(from_v.volume().unwrap(), &volume);

            let map = unimodular(&mut Random::new(7, case), n);
            let sheared = from_v.linear_map(&map).unwrap();
            if size == 1.0 {
                assert_eq!(sheared.remainder(), vec![0.0; n], "small integers are exact: {parts:?}");
                assert_eq!(sheared.to_h_polytope().unwrap().num_half_spaces(), facets, "{parts:?}");
                assert_encloses(sheared.volume().unwrap(), &volume);
            }
        }
    }
}

#[test]
fn cross_polytopes() {
    for n in 1..=6 {
        let mut vertices = Matrix::zeros(n, 2 * n);
        for k in 0..n {
            vertices[(k, 2 * k)] = 1.0;
            vertices[(k, 2 * k + 1)] = -1.0;
        }
        let set = VPolytope::new(vertices).unwrap();
        let half_spaces = set.to_h_polytope().unwrap();
        assert_eq!(half_spaces.num_half_spaces(), 1 << n);
        assert!(half_spaces.offsets().iter().all(|&b| b == 1.0), "{half_spaces:?}");
        assert_encloses(set.volume().unwrap(), &(inverse_factorial(n) * q(f64::from(1 << n))));
        let back = half_spaces.to_v_polytope().unwrap();
        assert_eq!((back.num_vertices(), back.remainder()), (2 * n, &*vec![0.0; n]));
        assert_encloses(half_spaces.volume().unwrap(), &(inverse_factorial(n) * q(f64::from(1 << n))));
    }
}

#[test]
fn boxes_convert_exactly() {
    let sides = setrep::IntervalVector::from_center(&[0.3, -7.0, 1e-9], &[0.1, 2.0, 1e-10]).unwrap();
    let half_spaces = HPolytope::from_intervals(&sides).unwrap();
    let vertices = VPolytope::from_intervals(&sides).unwrap();
    assert_eq!((half_spaces.num_half_spaces(), vertices.num_vertices()), (6, 8));
    assert_eq!(half_spaces.interval_hull().unwrap(), sides);
    assert_eq!(vertices.interval_hull(), sides);
    let back = vertices.to_h_polytope().unwrap();
    assert_eq!(back.interval_hull().unwrap(), sides);
    assert_eq!(back.num_half_spaces(), 6);
    let found = half_spaces.to_v_polytope().unwrap();
    assert_eq!(found.remainder(), [0.0; 3]);
}
