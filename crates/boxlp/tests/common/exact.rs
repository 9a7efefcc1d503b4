//! Exact rational arithmetic: a dual simplex method, and the checks of certificates and witnesses.

use boxlp::{Multiplier, Problem};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

pub(crate) fn rational(value: f64) -> BigRational {
    BigRational::from_float(value).expect("finite")
}

/// `a'x` exactly.
pub(crate) fn dot(a: &[f64], x: &[f64]) -> BigRational {
    a.iter()
        .zip(x)
        .map(|(&a, &x)| rational(a) * rational(x))
        .sum()
}

/// Exchange tableau `x_B = T x_N` over the rationals.
pub(crate) struct Exact {
    n: usize,
    t: Vec<Vec<BigRational>>,
    basic: Vec<usize>,
    nonbasic: Vec<usize>,
    bounds: Vec<(BigRational, BigRational)>,
}

impl Exact {
    pub(crate) fn new(problem: &Problem) -> Self {
        let (n, m) = (problem.variables(), problem.rows());
        let one = rational(1.0);
        let mut bounds = vec![(-one.clone(), one); n];
        let mut t = Vec::new();
        for i in 0..m {
            let row: Vec<BigRational> = problem.row(i).iter().map(|&a| rational(a)).collect();
            let reach: BigRational =
                row.iter().map(Signed::abs).sum::<BigRational>() + rational(1.0);
            let (lower, upper) = problem.range(i);
            // An infinite end is replaced by one the box cannot reach.
            let far = |end: f64, near: f64| {
                let near = if near.is_finite() {
                    rational(near).abs()
                } else {
                    BigRational::zero()
                };
                if end.is_finite() {
                    rational(end)
                } else if end > 0.0 {
                    &reach + near
                } else {
                    -(&reach + near)
                }
            };
            bounds.push((far(lower, upper), far(upper, lower)));
            t.push(row);
        }
        Self {
            n,
            t,
            basic: (n..n + m).collect(),
            nonbasic: (0..n).collect(),
            bounds,
        }
    }

    /// The maximum of `c'x`, or `None` if the set is empty. Starts from the basis of the last call.
    pub(crate) fn maximize(&mut self, objective: &[f64]) -> Option<BigRational> {
        let c: Vec<BigRational> = objective.iter().map(|&c| rational(c)).collect();
        let mut d: Vec<BigRational> = (0..self.n)
            .map(|j| {
                let own = c
                    .get(self.nonbasic[j])
                    .cloned()
                    .unwrap_or_else(BigRational::zero);
                self.basic
                    .iter()
                    .zip(&self.t)
                    .filter(|(b, _)| **b < self.n)
                    .fold(own, |s, (&b, row)| s + &c[b] * &row[j])
            })
            .collect();
        let mut x: Vec<BigRational> = (0..self.n)
            .map(|j| {
                let (lower, upper) = &self.bounds[self.nonbasic[j]];
                if d[j].is_negative() {
                    lower.clone()
                } else {
                    upper.clone()
                }
            })
            .collect();
        for pivot in 0_usize.. {
            // The most violated basic variable leaves; after many pivots that of the lowest index (Bland: no cycles).
            let mut leaving: Option<(usize, f64, bool)> = None;
            for (r, row) in self.t.iter().enumerate() {
                let value: BigRational = row
                    .iter()
                    .zip(&x)
                    .filter(|(t, _)| !t.is_zero())
                    .map(|(t, x)| t * x)
                    .sum();
                let (lower, upper) = &self.bounds[self.basic[r]];
                let above = value > *upper;
                if above || value < *lower {
                    let miss = if above { value - upper } else { lower - value }
                        .to_f64()
                        .unwrap_or(f64::MAX);
                    let better = leaving.is_none_or(|(l, most, _)| {
                        if pivot < 200 {
                            miss > most
                        } else {
                            self.basic[r] < self.basic[l]
                        }
                    });
                    if better {
                        leaving = Some((r, miss, above));
                    }
                }
            }
            let Some((r, _, above)) = leaving else {
                return Some(d.iter().zip(&x).map(|(d, x)| d * x).sum());
            };
            let mut entering: Option<(usize, BigRational)> = None;
            for j in 0..self.n {
                let t = &self.t[r][j];
                let (lower, upper) = &self.bounds[self.nonbasic[j]];
                if t.is_zero() || lower == upper {
                    continue;
                }
                let helps = (x[j] == *upper) == (t.is_positive() == above);
                if helps {
                    let ratio = (&d[j] / t).abs();
                    let better = entering.as_ref().is_none_or(|(q, best)| {
                        ratio < *best || ratio == *best && self.nonbasic[j] < self.nonbasic[*q]
                    });
                    if better {
                        entering = Some((j, ratio));
                    }
                }
            }
            let (q, _) = entering?;
            let (lower, upper) = self.bounds[self.basic[r]].clone();
            let target = if above { upper } else { lower };
            self.exchange(r, q, &mut d);
            x[q] = target;
        }
        None
    }

    fn exchange(&mut self, r: usize, q: usize, d: &mut [BigRational]) {
        let inverse = self.t[r][q].recip();
        let pivot_row: Vec<BigRational> = self.t[r].iter().map(|t| t * &inverse).collect();
        let eliminate = |row: &mut [BigRational]| {
            let factor = row[q].clone();
            if factor.is_zero() {
                return;
            }
            for (j, p) in pivot_row.iter().enumerate() {
                if j == q {
                    row[j] = &factor * &inverse;
                } else if !p.is_zero() {
                    row[j] -= &factor * p;
                }
            }
        };
        for (i, row) in self.t.iter_mut().enumerate() {
            if i != r {
                eliminate(row);
            }
        }
        eliminate(d);
        self.t[r] = pivot_row.iter().map(|p| -p).collect();
        self.t[r][q] = inverse;
        std::mem::swap(&mut self.basic[r], &mut self.nonbasic[q]);
    }
}

/// `B(y) = sum max(y lower, y upper) + |c - A'y|_1` exactly; one-sided rows count as clipped to `|A_i|_1`.
pub(crate) fn weak_duality(
    problem: &Problem,
    objective: &[f64],
    multipliers: &[Multiplier],
) -> BigRational {
    let mut residual: Vec<BigRational> = objective.iter().map(|&c| rational(c)).collect();
    let mut bound = BigRational::zero();
    for &(i, y) in multipliers {
        let y = rational(y);
        let reach: BigRational = problem.row(i).iter().map(|&a| rational(a).abs()).sum();
        let (lower, upper) = problem.range(i);
        let (low, high) = (-reach.clone(), reach);
        let (low, high) = match (lower.is_finite(), upper.is_finite()) {
            (true, true) => (rational(lower), rational(upper)),
            (true, false) => (rational(lower), high.max(rational(lower))),
            (false, true) => (low.min(rational(upper)), rational(upper)),
            (false, false) => (low, high),
        };
        bound += (&y * low).max(&y * high);
        for (v, &a) in residual.iter_mut().zip(problem.row(i)) {
            *v -= &y * rational(a);
        }
    }
    bound + residual.iter().map(Signed::abs).sum::<BigRational>()
}
