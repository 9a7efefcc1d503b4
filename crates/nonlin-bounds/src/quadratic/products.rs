//! Products of generators and of constraints: the coordinates `xi_i^2 = (1 + zeta_i) / 2` and `xi_i xi_j`.

use scalars::Interval;
use scalars::rounding::add_up;
use setrep::{ConstrainedZonotope, Zonotope};

use super::midpoint;
use super::parts::{Parts, multiply};

impl Parts {
    /// Splits the set into columns, with the large components of the remainder, and a rest.
    pub(super) fn split(&mut self, body: &Zonotope) {
        self.columns.clone_from(body.generators());
        self.rest.clear();
        self.rest.extend_from_slice(body.remainder());
        self.zeros.clear();
        self.zeros.resize(body.dim(), 0.0);
        for k in 0..body.dim() {
            let extent: f64 = body.generators().columns().map(|column| column[k].abs()).sum();
            if is_model_size(self.rest[k], extent, body.center()[k]) {
                self.zeros[k] = self.rest[k];
                // A column of the set's own dimension.
                let _ = self.columns.push_col(&self.zeros);
                self.zeros[k] = 0.0;
                self.rest[k] = 0.0;
            }
        }
    }

    /// Row `i` of the generators from `G'Q G`, `Q` half the packed Hessian: first the squares, then the products `i < j`. Returns the
    /// constant `sum_i q_ii / 2` and a bound of what midpoints leave out.
    pub(super) fn square(&mut self, hessian: &[Interval], i: usize) -> (Interval, f64) {
        let count = self.columns.cols();
        let (mut constant, mut radius) = (Interval::ZERO, 0.0);
        let mut pair = count;
        for a in 0..count {
            self.zeros_as_points(a);
            multiply(hessian, &self.ranges, &mut self.curved);
            if self.curved.iter().all(|v| *v == Interval::ZERO) {
                // The output does not curve along this column; the entries of the row are zero already.
                pair += count - a - 1;
                continue;
            }
            for b in a..count {
                let dot = |g: &[f64]| -> Interval {
                    self.curved.iter().zip(g).fold(Interval::ZERO, |sum, (v, &g)| {
                        if g == 0.0 || *v == Interval::ZERO { sum } else { sum + v.scale(g) }
                    })
                };
                let product = dot(self.columns.col(b));
                if a == b {
                    // q_aa xi^2 = q_aa / 2 + q_aa zeta / 2, q_aa half of the product; what is left of q_aa multiplies xi^2 <= 1.
                    let quarter = 0.25 * product.mid();
                    self.generators[(i, a)] = quarter;
                    constant += Interval::point(quarter);
                    radius = add_up(radius, product.scale(0.5).add_f64(-2.0 * quarter).mag());
                } else {
                    let middle = product.mid();
                    self.generators[(i, pair)] = middle;
                    radius = add_up(radius, product.add_f64(-middle).mag());
                    pair += 1;
                }
            }
        }
        (constant, radius)
    }

    /// Column `a` of the generators as points, in the buffer of the ranges.
    fn zeros_as_points(&mut self, a: usize) {
        self.ranges.clear();
        self.ranges.extend(self.columns.col(a).iter().map(|&g| Interval::point(g)));
    }

    /// Row `i` of the second copy `2 mid(L) G` from column `first` on; returns a bound of its rounding.
    pub(super) fn copy_cross(&mut self, i: usize, first: usize) -> f64 {
        let mut error = 0.0;
        for a in 0..self.columns.cols() {
            let terms = self.cross.iter().zip(self.columns.col(a));
            let product =
                terms.fold(Interval::ZERO, |sum, (entry, &g)| sum + Interval::point(2.0 * midpoint(*entry)).scale(g));
            self.generators[(i, first + a)] = product.mid();
            error = add_up(error, product.rad());
        }
        error
    }

    /// Rows and ranges of `K`: products of all pairs of the set's constraints, and these themselves for a second copy of the coordinates.
    pub(super) fn products(&mut self, set: Option<&ConstrainedZonotope>, count: usize, copied: usize) {
        self.ranges.clear();
        let columns = self.generators.cols();
        let Some(set) = set.filter(|set| set.num_constraints() > 0) else {
            self.rows.reset(0, columns);
            return;
        };
        let (own, constraints) = (set.num_generators(), set.num_constraints());
        let copies = if copied > 0 { constraints } else { 0 };
        self.rows.reset(constraints * (constraints + 1) / 2 + copies, columns);
        let a = set.constraints();
        let mut row = 0;
        for r in 0..constraints {
            for s in r..constraints {
                let (b, d) = (set.ranges()[r], set.ranges()[s]);
                let mut range = if r == s { b.sqr() } else { b * d };
                let mut pair = count;
                for i in 0..count {
                    // Columns behind the set's own are components of the remainder: the constraints do not know them.
                    for j in i..count {
                        let inner = j < own;
                        if i == j && inner {
                            let half = Interval::point(a[(r, i)]).scale(a[(s, i)]).scale(0.5);
                            self.rows[(row, i)] = half.mid();
                            range = (range - half).inflate(half.rad());
                        } else if i < j {
                            if inner {
                                let term = |r: usize, s: usize| Interval::point(a[(r, i)]).scale(a[(s, j)]);
                                let sum = if r == s { term(r, s).scale(2.0) } else { term(r, s) + term(s, r) };
                                self.rows[(row, pair)] = sum.mid();
                                range = range.inflate(sum.rad());
                            }
                            pair += 1;
                        }
                    }
                }
                self.ranges.push(range);
                row += 1;
            }
        }
        for r in 0..copies {
            for j in 0..own {
                self.rows[(row + r, columns - copied + j)] = a[(r, j)];
            }
            self.ranges.push(set.ranges()[r]);
        }
    }

    /// Leaves out the columns that are zero in all outputs and constraints.
    pub(super) fn drop_zero_columns(&mut self, m: usize) {
        self.kept.reset(m, 0);
        self.kept_rows.reset(self.rows.rows(), 0);
        for j in 0..self.generators.cols() {
            let (g, a) = (self.generators.col(j), self.rows.col(j));
            if g.iter().chain(a).any(|&x| x != 0.0) {
                // Columns of the matrices' own sizes.
                let _ = self.kept.push_col(g);
                let _ = self.kept_rows.push_col(a);
            }
        }
    }
}

/// Whether a component of a remainder is more than rounding next to the generators' extent and the center: it is a generator of its own.
pub(crate) fn is_model_size(r: f64, extent: f64, center: f64) -> bool {
    r > 1e-9 * extent && r > 1e-12 * center.abs()
}
