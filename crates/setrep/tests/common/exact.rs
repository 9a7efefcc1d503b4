//! Exact points of sets, and exact proofs that a point lies in a set.

use setrep::{Matrix, Zonotope};

use super::dyadic::Dyadic;
use super::random::Random;

/// A member of a set with its coordinates: `x = c + G xi + diag(r) eta`.
#[derive(Debug, Clone)]
pub(crate) struct Member {
    pub(crate) xi: Vec<f64>,
    pub(crate) eta: Vec<f64>,
    pub(crate) x: Vec<Dyadic>,
}

/// `G xi`, exactly.
pub(crate) fn times(generators: &Matrix, xi: &[f64]) -> Vec<Dyadic> {
    let mut sum = vec![Dyadic::zero(); generators.rows()];
    for (column, &t) in generators.columns().zip(xi) {
        let t = Dyadic::from(t);
        for (s, &g) in sum.iter_mut().zip(column) {
            *s += &(&Dyadic::from(g) * &t);
        }
    }
    sum
}

/// `R x`, exactly.
pub(crate) fn image(map: &Matrix, x: &[Dyadic]) -> Vec<Dyadic> {
    (0..map.rows())
        .map(|i| x.iter().enumerate().fold(Dyadic::zero(), |sum, (k, x)| &sum + &(&Dyadic::from(map[(i, k)]) * x)))
        .collect()
}

/// `x + y`, exactly.
pub(crate) fn sum(x: &[Dyadic], y: &[Dyadic]) -> Vec<Dyadic> {
    x.iter().zip(y).map(|(x, y)| x + y).collect()
}

/// A random member of a set.
pub(crate) fn member(set: &Zonotope, random: &mut Random) -> Member {
    let (xi, eta) = (random.cube(set.num_generators()), random.cube(set.dim()));
    let mut x = times(set.generators(), &xi);
    for (k, x) in x.iter_mut().enumerate() {
        let rest = &Dyadic::from(set.remainder()[k]) * &Dyadic::from(eta[k]);
        *x += &(&Dyadic::from(set.center()[k]) + &rest);
    }
    Member { xi, eta, x }
}

/// Whether the witness `xi` proves `x` a member: `|xi| <= 1` and `|x - c - G xi| <= r`, exactly.
pub(crate) fn is_witness(set: &Zonotope, xi: &[f64], x: &[Dyadic]) -> bool {
    xi.len() == set.num_generators()
        && xi.iter().all(|t| t.abs() <= 1.0)
        && excess(set, xi, x).iter().all(|e| e <= &Dyadic::zero())
}

/// `|x - c - G xi| - r` per row, exactly.
pub(crate) fn excess(set: &Zonotope, xi: &[f64], x: &[Dyadic]) -> Vec<Dyadic> {
    let inner = times(set.generators(), xi);
    (0..set.dim())
        .map(|k| {
            let residual = &(&x[k] - &Dyadic::from(set.center()[k])) - &inner[k];
            &residual.abs() - &Dyadic::from(set.remainder()[k])
        })
        .collect()
}

/// Whether the image under a map of the member of `set` lies in `mapped`: its coordinates are those of the member, followed by those
/// of the components of the remainder that became generators. Any choice of these that works is a proof.
pub(crate) fn is_mapped_witness(set: &Zonotope, mapped: &Zonotope, member: &Member, x: &[Dyadic]) -> bool {
    let extra = mapped.num_generators() - set.num_generators();
    (0_u32..1 << set.dim()).filter(|rows| rows.count_ones() as usize == extra).any(|rows| {
        let mut xi = member.xi.clone();
        xi.extend((0..set.dim()).filter(|k| rows >> k & 1 == 1).map(|k| member.eta[k]));
        is_witness(mapped, &xi, x)
    })
}

/// The determinant, by Laplace expansion along the first column.
pub(crate) fn determinant(columns: &[Vec<Dyadic>]) -> Dyadic {
    let n = columns.len();
    if n == 0 {
        return Dyadic::from(1.0);
    }
    let mut sum = Dyadic::zero();
    for i in 0..n {
        if columns[0][i].is_zero() {
            continue;
        }
        let minor: Vec<Vec<Dyadic>> = columns[1..]
            .iter()
            .map(|c| c.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, x)| x.clone()).collect())
            .collect();
        let term = &columns[0][i] * &determinant(&minor);
        sum += &if i % 2 == 0 { term } else { -term };
    }
    sum
}

/// The solution of `T z = b` by Cramer's rule, rounded and clamped to the unit cube; `None` if `T` is singular.
pub(crate) fn solve(columns: &[Vec<Dyadic>], b: &[Dyadic]) -> Option<Vec<f64>> {
    let whole = determinant(columns);
    if whole.is_zero() {
        return None;
    }
    let replaced = |k: usize| {
        let mut columns = columns.to_vec();
        columns[k] = b.to_vec();
        determinant(&columns)
    };
    Some((0..columns.len()).map(|k| replaced(k).ratio(&whole).clamp(-1.0, 1.0)).collect())
}

/// Exact support function `d'c + sum_j |d'g_j| + |d|'r`.
pub(crate) fn support(set: &Zonotope, direction: &[f64]) -> Dyadic {
    let d: Vec<Dyadic> = direction.iter().map(|&d| Dyadic::from(d)).collect();
    let dot = |x: &[f64]| d.iter().zip(x).fold(Dyadic::zero(), |sum, (d, &x)| &sum + &(d * &Dyadic::from(x)));
    let mut h = dot(set.center());
    for column in set.generators().columns() {
        h += &dot(column).abs();
    }
    for (d, &r) in d.iter().zip(set.remainder()) {
        h += &(&d.clone().abs() * &Dyadic::from(r));
    }
    h
}

/// The exact values of floats.
pub(crate) fn exact(x: &[f64]) -> Vec<Dyadic> {
    x.iter().map(|&x| Dyadic::from(x)).collect()
}

/// Exact membership: `|l'(x - c)| <= sum_j |l'g_j| + |l|'r` for the normals `l` of all `n - 1` columns of `[G I]`.
///
/// For `G` alone these are the facets of a set of full dimension; those of `[G eI]` for every small `e > 0` are among the normals
/// of `[G I]`, and the set is the intersection of these larger ones.
pub(crate) fn lies_in(set: &Zonotope, x: &[Dyadic]) -> bool {
    let remainder = exact(set.remainder());
    let generators: Vec<Vec<Dyadic>> = set.generators().columns().map(exact).collect();
    let offset: Vec<Dyadic> = x.iter().zip(set.center()).map(|(x, &c)| x - &Dyadic::from(c)).collect();
    lies_in_centered(&generators, &remainder, &offset)
}

/// Whether `x` lies in `{ G xi + e : |xi| <= 1, |e| <= r }`.
pub(crate) fn lies_in_centered(generators: &[Vec<Dyadic>], remainder: &[Dyadic], x: &[Dyadic]) -> bool {
    let n = x.len();
    let mut columns = generators.to_vec();
    columns.extend((0..n).map(|k| exact(Matrix::identity(n).col(k))));
    let dot = |a: &[Dyadic], b: &[Dyadic]| a.iter().zip(b).fold(Dyadic::zero(), |sum, (a, b)| &sum + &(a * b));
    let within = |normal: &[Dyadic]| {
        let mut radius = generators.iter().fold(Dyadic::zero(), |sum, g| &sum + &dot(normal, g).abs());
        normal.iter().zip(remainder).for_each(|(l, r)| radius += &(&l.clone().abs() * r));
        dot(normal, x).abs() <= radius
    };
    subsets(columns.len(), n - 1)
        .iter()
        .all(|subset| within(&normal(&subset.iter().map(|&j| columns[j].clone()).collect::<Vec<_>>(), n)))
}

/// The vector orthogonal to `n - 1` columns whose components are their signed minors.
fn normal(columns: &[Vec<Dyadic>], n: usize) -> Vec<Dyadic> {
    (0..n)
        .map(|i| {
            let rows =
                columns.iter().map(|c| c.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, x)| x.clone()).collect());
            let minor = determinant(&rows.collect::<Vec<_>>());
            if i % 2 == 0 { minor } else { -minor }
        })
        .collect()
}

/// The `k`-subsets of `0..m`.
fn subsets(m: usize, k: usize) -> Vec<Vec<usize>> {
    if k == 0 {
        return vec![Vec::new()];
    }
    (k - 1..m)
        .flat_map(|last| {
            subsets(last, k - 1).into_iter().map(move |mut s| {
                s.push(last);
                s
            })
        })
        .collect()
}
