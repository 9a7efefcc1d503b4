//! Brute force in exact rational arithmetic: slow, short, and independent of the library.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use setrep::{HPolytope, Matrix, VPolytope};

pub(crate) type Q = BigRational;

pub(crate) fn q(x: f64) -> Q {
    Q::from_float(x).unwrap()
}

/// The row-reduced matrix and its pivot columns.
fn reduce(mut rows: Vec<Vec<Q>>) -> (Vec<Vec<Q>>, Vec<usize>) {
    let cols = rows.first().map_or(0, Vec::len);
    let mut pivots = Vec::new();
    for col in 0..cols {
        let at = pivots.len();
        let Some(found) = (at..rows.len()).find(|&i| !rows[i][col].is_zero()) else { continue };
        rows.swap(at, found);
        let inverse = rows[at][col].recip();
        for x in &mut rows[at] {
            *x *= &inverse;
        }
        for i in 0..rows.len() {
            if i != at && !rows[i][col].is_zero() {
                let factor = rows[i][col].clone();
                for k in 0..cols {
                    let change = &factor * &rows[at][k];
                    rows[i][k] -= change;
                }
            }
        }
        pivots.push(col);
        if pivots.len() == rows.len() {
            break;
        }
    }
    (rows, pivots)
}

/// Every subset of `k` of `0..m`.
fn subsets(m: usize, k: usize) -> Vec<Vec<usize>> {
    let mut all = vec![vec![]];
    for size in 0..k {
        all = all
            .into_iter()
            .flat_map(|s: Vec<usize>| {
                let start = s.last().map_or(0, |x| x + 1);
                (start..m + size + 1 - k).map(move |x| [&s[..], &[x]].concat())
            })
            .collect();
    }
    all
}

/// The half-spaces as rational rows `(a, b)`.
pub(crate) fn half_spaces(polytope: &HPolytope) -> Vec<(Vec<Q>, Q)> {
    let (normals, n) = (polytope.normals(), polytope.dim());
    polytope.offsets().iter().enumerate().map(|(i, &b)| ((0..n).map(|k| q(normals[(i, k)])).collect(), q(b))).collect()
}

pub(crate) fn dot(a: &[Q], x: &[Q]) -> Q {
    a.iter().zip(x).fold(Q::zero(), |sum, (a, x)| sum + a * x)
}

/// The vertices: solutions of `n` independent equations that fulfil all inequalities.
pub(crate) fn vertices(polytope: &HPolytope) -> Vec<Vec<Q>> {
    let n = polytope.dim();
    let rows = half_spaces(polytope);
    let mut found = Vec::new();
    for subset in subsets(rows.len(), n) {
        let system = subset.iter().map(|&i| [&rows[i].0[..], &[rows[i].1.clone()]].concat()).collect();
        let (reduced, pivots) = reduce(system);
        if pivots.len() == n && pivots.last() < Some(&n) {
            let x: Vec<Q> = reduced.into_iter().map(|mut row| row.pop().unwrap()).collect();
            if rows.iter().all(|(a, b)| dot(a, &x) <= *b) {
                found.push(x);
            }
        }
    }
    found.sort();
    found.dedup();
    found
}

/// The facets of a full-dimensional hull as `(b, a)` with `a'x <= b`, scaled to `|a|_1 = 1`, and the sum of `|det|` of the simplices from
/// the first point over those facets that are simplices (all of them for points in general position).
pub(crate) fn facets(points: &Matrix) -> (Vec<Vec<Q>>, Q) {
    let (n, m) = (points.rows(), points.cols());
    let lifted: Vec<Vec<Q>> =
        points.columns().map(|v| std::iter::once(-Q::one()).chain(v.iter().map(|&x| q(x))).collect()).collect();
    let mut found = Vec::new();
    let mut sum = Q::zero();
    for subset in subsets(m, n) {
        let (reduced, pivots) = reduce(subset.iter().map(|&j| lifted[j].clone()).collect());
        if pivots.len() < n {
            continue;
        }
        let free = (0..=n).find(|k| !pivots.contains(k)).unwrap();
        let mut y = vec![Q::zero(); n + 1];
        y[free] = Q::one();
        for (row, &pivot) in reduced.iter().zip(&pivots) {
            y[pivot] = -row[free].clone();
        }
        let signs: Vec<Q> = lifted.iter().map(|v| dot(v, &y)).collect();
        if signs.iter().any(Q::is_positive) {
            if signs.iter().any(Q::is_negative) {
                continue;
            }
            for x in &mut y {
                *x = -x.clone();
            }
        }
        let length = y[1..].iter().fold(Q::zero(), |sum, x| sum + x.abs());
        for x in &mut y {
            *x /= &length;
        }
        found.push(y);
        sum += determinant(points, 0, &subset).abs();
    }
    found.sort();
    found.dedup();
    (found, sum)
}

/// `det [v_j - v_origin]`.
fn determinant(points: &Matrix, origin: usize, columns: &[usize]) -> Q {
    let mut rows: Vec<Vec<Q>> = columns
        .iter()
        .map(|&j| points.col(j).iter().zip(points.col(origin)).map(|(&x, &o)| q(x) - q(o)).collect())
        .collect();
    let n = rows.len();
    let mut product = Q::one();
    for k in 0..n {
        let Some(pivot) = (k..n).find(|&i| !rows[i][k].is_zero()) else { return Q::zero() };
        if pivot != k {
            rows.swap(pivot, k);
            product = -product;
        }
        product *= rows[k][k].clone();
        for i in k + 1..n {
            let factor = &rows[i][k] / &rows[k][k];
            for j in k..n {
                let change = &factor * &rows[k][j];
                rows[i][j] -= change;
            }
        }
    }
    product
}

/// `1 / n!`.
pub(crate) fn inverse_factorial(n: usize) -> Q {
    Q::new(BigInt::one(), (1..=n).fold(BigInt::one(), |product, k| product * k))
}

/// Whether the point lies in the half-space form, exactly.
pub(crate) fn lies_in(point: &[Q], polytope: &HPolytope) -> bool {
    half_spaces(polytope).iter().all(|(a, b)| dot(a, point) <= *b)
}

/// Whether points and columns match up: each within the remainder of some of the others, and as many.
pub(crate) fn match_columns(points: &[Vec<Q>], polytope: &VPolytope) -> bool {
    let near =
        |x: &Vec<Q>, v: &[f64]| v.iter().zip(x).zip(polytope.remainder()).all(|((&v, x), &r)| (q(v) - x).abs() <= q(r));
    points.len() == polytope.num_vertices()
        && points.iter().all(|x| polytope.vertices().columns().any(|v| near(x, v)))
        && polytope.vertices().columns().all(|v| points.iter().any(|x| near(x, v)))
}

/// The nearest float.
pub(crate) fn float(x: &Q) -> f64 {
    use num_traits::ToPrimitive;
    x.to_f64().unwrap()
}
