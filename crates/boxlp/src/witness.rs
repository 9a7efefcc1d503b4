//! Proof that a set is not empty: a point with a radius within which an exactly feasible point exists.

use crate::problem::Problem;
use crate::rounding::{add_down, add_up, dot_enclosure, mul_down, mul_up};
use crate::tableau::Tableau;
use crate::workspace::Workspace;

/// An exactly feasible point `x` exists with `|x - point|_max <= radius`.
///
/// The radius is 0 if the point itself was proven feasible; it is of rounding size if rows of (nearly) zero width, which
/// no floating-point number need satisfy, were solved by a fixed-point argument.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Witness {
    pub(crate) point: Vec<f64>,
    pub(crate) radius: f64,
}

impl Witness {
    /// Centre of the ball.
    #[must_use]
    pub fn point(&self) -> &[f64] {
        &self.point
    }

    /// Radius of the ball in the maximum norm.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }
}

impl Witness {
    /// Tries to prove the set non-empty near the vertex of `tableau`, whose point `workspace` has read.
    ///
    /// If the point satisfies every row in real arithmetic, done. Otherwise, with `J` the basic structural and `R` the
    /// nonbasic logical variables (as many), the tableau holds an approximate inverse `C` of `A_RJ`. For the residual
    /// `rho = s_R - A_R x` of the values `s_R` the logicals stand at, `|I - C A_RJ|_max <= q < 1` proves that
    /// `A_RJ e = rho` has one solution, `e = C rho + (I - C A_RJ) e`, with `|e|_max <= |C rho|_max / (1 - q)`; then
    /// `x + e` satisfies the rows `R` exactly, and it remains to see that the box and the other rows hold around `x`.
    /// Source: the fixed-point argument of Krawczyk and Rump, with a norm.
    pub(crate) fn prove(
        &mut self,
        problem: &Problem,
        tableau: &Tableau,
        workspace: &mut Workspace,
    ) -> bool {
        let n = problem.variables();
        let Workspace {
            point,
            displacement,
            ..
        } = workspace;
        self.point.clone_from(point);
        self.radius = 0.0;
        if (0..problem.rows()).all(|i| holds(problem, i, point, &[])) {
            return true;
        }
        // |C rho| into the displacements of J, and the row sums of |I - C A_RJ|, whose largest is q.
        displacement.fill((0.0, 0.0));
        let (mut most, mut q) = (0.0_f64, 0.0_f64);
        for (r, &b) in tableau
            .rows
            .variable
            .iter()
            .enumerate()
            .filter(|&(_, &v)| (v as usize) < n)
        {
            let row = tableau.row(r);
            let inverse = || {
                let entries = tableau
                    .columns
                    .variable
                    .iter()
                    .zip(row)
                    .zip(&tableau.columns.value);
                entries.filter_map(|((&v, &t), &s)| (v as usize).checked_sub(n).map(|i| (i, t, s)))
            };
            let mut shift = 0.0;
            for (i, t, s) in inverse() {
                let range = &problem.ranges()[i];
                let (low, high) = dot_enclosure(problem.row(i), point);
                let target = s / range.scale;
                let rho = add_up(target, -low).max(add_up(high, -target));
                shift = add_up(shift, mul_up((t * range.scale).abs(), rho));
            }
            let mut sum = 0.0;
            for &k in tableau.rows.variable.iter().filter(|&&v| (v as usize) < n) {
                let unit = if k == b { 1.0 } else { 0.0 };
                let (mut low, mut high) = (unit, unit);
                for (i, t, _) in inverse() {
                    let c = t * problem.ranges()[i].scale;
                    let a = problem.row(i)[k as usize];
                    low = add_down(low, -mul_up(c, a));
                    high = add_up(high, -mul_down(c, a));
                }
                sum = add_up(sum, high.max(-low));
            }
            displacement[b as usize] = (shift, sum);
            most = most.max(shift);
            q = q.max(sum);
        }
        if !(q <= 0.5 && most.is_finite()) {
            return false;
        }
        // |e|_max <= most / (1 - q) <= 2 most, and componentwise |e| <= |C rho| + |I - C A_RJ| |e|_max.
        for (shift, sum) in displacement.iter_mut() {
            *shift = add_up(*shift, mul_up(*sum, 2.0 * most));
            self.radius = self.radius.max(*shift);
        }
        let in_box = point
            .iter()
            .zip(&*displacement)
            .all(|(x, d)| d.0 == 0.0 || add_up(x.abs(), d.0) <= 1.0);
        let solved = |i: usize| {
            let logical = (n + i) as u32;
            tableau
                .columns
                .variable
                .iter()
                .position(|&v| v == logical)
                .is_some_and(|j| {
                    let target = tableau.columns.value[j] / problem.ranges()[i].scale;
                    let (lower, upper) = problem.range(i);
                    lower <= target && target <= upper
                })
        };
        in_box && (0..problem.rows()).all(|i| solved(i) || holds(problem, i, point, displacement))
    }
}

/// Whether row `i` holds, in real arithmetic, for all points within the displacements of `point`.
fn holds(problem: &Problem, i: usize, point: &[f64], displacement: &[(f64, f64)]) -> bool {
    let row = problem.row(i);
    let (low, high) = dot_enclosure(row, point);
    let mut reach = 0.0;
    for (a, d) in row.iter().zip(displacement) {
        if d.0 != 0.0 {
            reach = add_up(reach, mul_up(a.abs(), d.0));
        }
    }
    let (lower, upper) = problem.range(i);
    let (low, high) = if reach == 0.0 {
        (low, high)
    } else {
        (add_down(low, -reach), add_up(high, reach))
    };
    lower <= low && high <= upper
}
