//! The corpus: 13 kinds of sets, each with objectives.

use super::random::Random;
use super::{dot, norm1};
use boxlp::Problem;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Kind {
    Regular,
    Chain,
    DuplicateGenerators,
    RedundantRows,
    Integers,
    SinglePoint,
    Flat,
    ZeroColumns,
    Scales,
    EmptyByBound,
    EmptyByContradiction,
    Tall4x150,
    Tall6x640,
}

pub(crate) const KINDS: [Kind; 13] = [
    Kind::Regular,
    Kind::Chain,
    Kind::DuplicateGenerators,
    Kind::RedundantRows,
    Kind::Integers,
    Kind::SinglePoint,
    Kind::Flat,
    Kind::ZeroColumns,
    Kind::Scales,
    Kind::EmptyByBound,
    Kind::EmptyByContradiction,
    Kind::Tall4x150,
    Kind::Tall6x640,
];

/// (dimension, variables, rows): twice the dimension objectives a set.
pub(crate) const SIZES: [(usize, usize, usize); 4] = [(2, 8, 3), (4, 12, 5), (10, 40, 10), (20, 200, 40)];

impl Kind {
    pub(crate) fn is_empty(self) -> bool {
        matches!(self, Self::EmptyByBound | Self::EmptyByContradiction)
    }

    pub(crate) fn is_tall(self) -> bool {
        matches!(self, Self::Tall4x150 | Self::Tall6x640)
    }

    /// Sets with interior relative to their equalities, well scaled.
    pub(crate) fn is_regular(self) -> bool {
        matches!(
            self,
            Self::Regular
                | Self::Chain
                | Self::DuplicateGenerators
                | Self::ZeroColumns
                | Self::Tall4x150
                | Self::Tall6x640
        )
    }
}

pub(crate) struct Case {
    pub(crate) kind: Kind,
    pub(crate) problem: Problem,
    pub(crate) objectives: Vec<Vec<f64>>,
}

/// Rows with their ranges, before they become a problem.
struct Rows {
    entries: Vec<Vec<f64>>,
    ranges: Vec<(f64, f64)>,
}

pub(crate) fn case(kind: Kind, size: (usize, usize, usize), seed: u64) -> Case {
    let mut random = Random::new(seed ^ ((kind as u64 + 1) << 40) ^ ((size.1 as u64) << 20));
    let (dimension, n, m) = match kind {
        Kind::Tall4x150 => (4, 4, 150),
        Kind::Tall6x640 => (6, 6, 640),
        _ => size,
    };
    let rows = rows(kind, n, m, &mut random);
    let mut problem = Problem::new(n).unwrap();
    for (row, (lower, upper)) in rows.entries.iter().zip(rows.ranges) {
        problem.push_row(row, lower, upper).unwrap();
    }
    let mut objectives = Vec::new();
    for k in 0..dimension {
        let objective: Vec<f64> = (0..n)
            .map(|_| match kind {
                Kind::Integers => random.below(5) as f64 - 2.0,
                Kind::Tall4x150 | Kind::Tall6x640 if k % 2 == 0 => random.below(2) as f64,
                Kind::Scales => random.normal() * random.scale(-3.0, 3.0),
                _ => random.normal(),
            })
            .collect();
        objectives.push(objective.iter().map(|c| -c).collect());
        objectives.push(objective);
    }
    Case { kind, problem, objectives }
}

fn rows(kind: Kind, n: usize, m: usize, random: &mut Random) -> Rows {
    let inner: Vec<f64> = (0..n).map(|_| 0.8 * random.symmetric()).collect();
    let corner: Vec<f64> = (0..n).map(|_| random.sign()).collect();
    let lattice: Vec<f64> = (0..n).map(|_| random.below(3) as f64 - 1.0).collect();
    let mut entries: Vec<Vec<f64>> = (0..m).map(|_| (0..n).map(|_| random.normal()).collect()).collect();
    let mut through = inner;
    let mut width: Vec<f64> = (0..m).map(|_| if random.below(2) == 0 { 0.0 } else { random.unit() }).collect();
    match kind {
        Kind::Regular => {}
        Kind::Chain => {
            // Row i measures a few of the first columns against a noise column of its own.
            let own = n.saturating_sub(m);
            for (i, row) in entries.iter_mut().enumerate() {
                for (j, a) in row.iter_mut().enumerate() {
                    if j >= own && j != own + i || j < own && random.below(3) > 0 {
                        *a = 0.0;
                    }
                }
                row[random.below(own)] = 1.0;
            }
        }
        Kind::DuplicateGenerators => {
            for row in &mut entries {
                for j in n / 2..n {
                    row[j] = if j % 3 == 0 { -row[j - n / 2] } else { row[j - n / 2] };
                }
            }
        }
        Kind::RedundantRows => {
            for i in m.div_ceil(2)..m {
                let (a, b) = (random.below(m / 2), random.below(m / 2));
                entries[i] = (0..n).map(|j| entries[a][j] + 0.5 * entries[b][j]).collect();
                width[i] = 0.0;
                if random.below(2) == 0 {
                    entries[i] = entries[a].clone();
                    width[i] = width[a];
                }
            }
            width[..m / 2].fill(0.0);
        }
        Kind::Integers => {
            through = lattice;
            for a in entries.iter_mut().flatten() {
                *a = random.below(5) as f64 - 2.0;
            }
            for w in &mut width {
                *w = random.below(2) as f64;
            }
        }
        Kind::SinglePoint => {
            // The first row reaches its bound at one corner of the box only.
            for (a, s) in entries[0].iter_mut().zip(&corner) {
                *a = s * (a.abs() + 0.01);
            }
            through = corner;
            width[0] = 0.0;
        }
        Kind::Flat => {
            // The first row pins half of the variables.
            for (j, a) in entries[0].iter_mut().enumerate() {
                *a = if j < n / 2 { corner[j] * (a.abs() + 0.01) } else { 0.0 };
            }
            through[..n / 2].copy_from_slice(&corner[..n / 2]);
            width[0] = 0.0;
        }
        Kind::ZeroColumns => {
            for row in &mut entries {
                for a in row.iter_mut().skip(1).step_by(2) {
                    *a = 0.0;
                }
            }
        }
        Kind::Scales => {
            let columns: Vec<f64> = (0..n).map(|_| random.scale(-3.0, 3.0)).collect();
            for (row, w) in entries.iter_mut().zip(&mut width) {
                let scale = random.scale(-3.0, 3.0);
                *w *= scale;
                for (a, c) in row.iter_mut().zip(&columns) {
                    *a *= scale * c;
                }
            }
        }
        Kind::EmptyByBound | Kind::EmptyByContradiction | Kind::Tall4x150 | Kind::Tall6x640 => {}
    }
    let mut ranges: Vec<(f64, f64)> = Vec::new();
    for (i, row) in entries.iter().enumerate() {
        let middle = dot(row, &through);
        let w = width[i];
        ranges.push(match kind {
            Kind::Tall4x150 | Kind::Tall6x640 => match i % 3 {
                0 => (f64::NEG_INFINITY, middle + 0.1 + w),
                1 => (middle - 0.1 - w, f64::INFINITY),
                _ => (middle - 0.2 - w, middle + 0.1 + w),
            },
            _ if w == 0.0 => (middle, middle),
            _ => (middle - w, middle + w),
        });
    }
    // Empty sets miss by at least 1e-7 of the 1-norm of a row.
    let miss = random.scale(-7.0, -0.5);
    if kind == Kind::EmptyByBound {
        let i = random.below(m);
        let reach = norm1(&entries[i]);
        let bound = reach * (1.0 + miss);
        ranges[i] = if random.below(2) == 0 { (bound, bound * 2.0) } else { (-bound * 2.0, -bound) };
    }
    if kind == Kind::EmptyByContradiction {
        // The last row is a combination of two others (of one, if there are only two rows), but wants another value.
        let (a, b) = (0, if m > 2 { 1 } else { 0 });
        entries[m - 1] = (0..n).map(|j| entries[a][j] - 0.75 * entries[b][j]).collect();
        let reach: f64 = entries.iter().map(|row| norm1(row)).sum();
        let highest = ranges[a].1 - 0.75 * ranges[b].0;
        ranges[m - 1] = (highest + 4.0 * miss * reach, f64::INFINITY);
    }
    Rows { entries, ranges }
}
