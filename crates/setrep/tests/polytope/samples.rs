//! Reproducible random polytopes.

use setrep::{HPolytope, Matrix, VPolytope};

use crate::common::random::Random;

/// `ORBITOPE_CASES` times the default size of a battery.
pub(crate) fn cases(default: usize) -> usize {
    let factor = std::env::var("ORBITOPE_CASES").ok().and_then(|text| text.parse::<f64>().ok()).unwrap_or(1.0);
    (default as f64 * factor).ceil() as usize
}

/// How the entries of a random polytope are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Entries {
    /// 53 random bits in `[-1, 1]`.
    Generic,
    /// Multiples of 1/4 in `[-1, 1]`: many coincidences.
    Coarse,
    /// Generic, coordinate `k` scaled by `10^(4 - 3 k)`.
    Scaled,
}

pub(crate) const ALL_ENTRIES: [Entries; 3] = [Entries::Generic, Entries::Coarse, Entries::Scaled];

fn draw(random: &mut Random, entries: Entries) -> f64 {
    match entries {
        Entries::Generic | Entries::Scaled => random.moderate() / 2.0,
        Entries::Coarse => random.between(0, 8) as f64 / 4.0 - 1.0,
    }
}

fn unit(entries: Entries, k: usize) -> f64 {
    if entries == Entries::Scaled { 10f64.powi(4 - 3 * k as i32) } else { 1.0 }
}

/// Points of a box; points in general position if generic.
pub(crate) fn points(random: &mut Random, n: usize, m: usize, entries: Entries) -> Matrix {
    let data: Vec<f64> = (0..n * m).map(|i| draw(random, entries) * unit(entries, i % n)).collect();
    Matrix::from_column_slice(n, m, &data).unwrap()
}

pub(crate) fn v_polytope(random: &mut Random, n: usize, m: usize, entries: Entries) -> VPolytope {
    VPolytope::new(points(random, n, m, entries)).unwrap()
}

/// A bounded polytope around the origin: a box and random half-spaces.
pub(crate) fn h_polytope(random: &mut Random, n: usize, extra: usize, entries: Entries) -> HPolytope {
    let m = 2 * n + extra;
    let mut normals = Matrix::zeros(m, n);
    let mut offsets = vec![1.0; m];
    for k in 0..n {
        normals[(2 * k, k)] = 1.0 / unit(entries, k);
        normals[(2 * k + 1, k)] = -1.0 / unit(entries, k);
    }
    for i in 2 * n..m {
        for k in 0..n {
            normals[(i, k)] = draw(random, entries) / unit(entries, k);
        }
        offsets[i] = if entries == Entries::Coarse {
            random.between(1, 4) as f64 / 4.0
        } else {
            0.3 + 0.3 * draw(random, entries).abs()
        };
    }
    HPolytope::new(normals, &offsets).unwrap()
}

/// A point of the hull of the columns: `k` random weights with sum 64, in 64ths.
pub(crate) fn weights(random: &mut Random, columns: usize) -> Vec<(usize, f64)> {
    let mut left = 64;
    let mut weights = Vec::new();
    while left > 0 {
        let share = if weights.len() == 4 { left } else { random.between(1, left) };
        weights.push((random.below(columns), share as f64 / 64.0));
        left -= share;
    }
    weights
}
