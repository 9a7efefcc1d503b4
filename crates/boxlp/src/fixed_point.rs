//! Exact solutions near a point: the rows that a vertex stands on have one, enclosed by a fixed-point argument.
//!
//! Let `J` be the free basic structural variables and `R` the rows, as many, whose nonbasic logicals stand at the values `s_R`.
//! The tableau holds an approximate inverse `C` of `A_RJ`. For the residual `rho = s_R - A_R x`, `|I - C A_RJ|_max <= q < 1`
//! proves that `A_RJ e = rho` has one solution,
//!
//! `e = C rho + (I - C A_RJ) e`, with `|e|_max <= |C rho|_max / (1 - q)`,
//!
//! and `x + e` satisfies the rows `R` exactly. It remains to see that the box and the other rows hold there.
//! Source: the argument of Krawczyk and Rump, with a norm.

use crate::dependence::is_implied;
use crate::problem::Problem;
use crate::rounding::{Bounds, add_down, add_scaled, add_up, difference_up, dot_enclosure, magnitude, mul_up};
use crate::tableau::Tableau;
use crate::witness::holds;

/// Scratch of the argument.
#[derive(Clone, Debug, Default)]
pub(crate) struct FixedPoint {
    /// `J`, each with its row of the tableau.
    unknowns: Vec<(usize, usize)>,
    /// `R`.
    equations: Vec<Equation>,
    /// `C rho`, then `e`, one entry a variable: zero outside `J`.
    displacements: Vec<Bounds>,
    /// Row sums of `|I - C A_RJ|`, one entry a variable.
    defects: Vec<f64>,
}

/// A row that is solved exactly.
#[derive(Clone, Copy, Debug)]
struct Equation {
    row: usize,
    /// Where its logical is nonbasic.
    column: usize,
    /// The value its activity shall have.
    target: f64,
    /// `rho`, how far it is from that.
    residual: Bounds,
}

impl FixedPoint {
    pub(crate) fn resize(&mut self, variables: usize) {
        self.unknowns.clear();
        self.unknowns.reserve(variables);
        self.equations.clear();
        self.equations.reserve(variables);
        self.displacements.resize(variables, (0.0, 0.0));
        self.defects.resize(variables, 0.0);
    }

    /// A radius around `point` within which a feasible point exists, if that can be proven; `is_free` says of a coordinate
    /// whether it may move.
    pub(crate) fn prove(
        &mut self,
        problem: &Problem,
        tableau: &Tableau<f64>,
        point: &[f64],
        is_free: impl Fn(f64) -> bool,
    ) -> Option<f64> {
        self.choose(problem, tableau, point, is_free);
        let Self { unknowns, equations, displacements, defects } = &mut *self;
        if unknowns.len() != equations.len() {
            return None;
        }
        displacements.fill((0.0, 0.0));
        defects.fill(0.0);
        let mut most = 0.0_f64;
        for &(variable, r) in &*unknowns {
            let entry = |e: &Equation| tableau.row(r)[e.column] * problem.ranges()[e.row].scale;
            let shift = equations.iter().fold((0.0, 0.0), |sum, e| add_scaled(sum, entry(e), e.residual));
            let mut defect = 0.0;
            for &(other, _) in &*unknowns {
                let unit = if other == variable { 1.0 } else { 0.0 };
                let products = equations.iter().map(|e| (entry(e), problem.row(e.row)[other]));
                defect = add_up(defect, difference_up(unit, products));
            }
            // NaN, from an overflow, proves nothing.
            if !(defect <= 0.5 && magnitude(shift) < f64::MAX) {
                return None;
            }
            displacements[variable] = shift;
            defects[variable] = defect;
            most = most.max(magnitude(shift));
        }
        // |e|_max <= most / (1 - q) <= 2 most, and each e is within its row of |I - C A_RJ| times that of C rho.
        let mut radius = 0.0_f64;
        for ((e, defect), x) in displacements.iter_mut().zip(defects).zip(point) {
            let spread = mul_up(*defect, 2.0 * most);
            if spread > 0.0 {
                *e = (add_down(e.0, -spread), add_up(e.1, spread));
            }
            radius = radius.max(magnitude(*e));
            if *e != (0.0, 0.0) && !(e.1 <= room(*x) && -e.0 <= room(-x)) {
                return None;
            }
        }
        self.rows_hold(problem, tableau, point).then_some(radius)
    }

    /// Chooses `J`, and as `R` the rows with nonbasic logicals that involve any of it.
    fn choose(&mut self, problem: &Problem, tableau: &Tableau<f64>, point: &[f64], is_free: impl Fn(f64) -> bool) {
        self.unknowns.clear();
        for (r, &v) in tableau.rows.variable.iter().enumerate() {
            if point.get(v as usize).is_some_and(|&x| is_free(x)) {
                self.unknowns.push((v as usize, r));
            }
        }
        self.equations.clear();
        for (column, &v) in tableau.columns.variable.iter().enumerate() {
            let Some(row) = (v as usize).checked_sub(point.len()) else { continue };
            let entries = problem.row(row);
            if self.unknowns.iter().any(|&(variable, _)| entries[variable] != 0.0) {
                let target = tableau.columns.value[column] / problem.ranges()[row].scale;
                let (low, high) = dot_enclosure(-target, entries, point);
                self.equations.push(Equation { row, column, target, residual: (-high, -low) });
            }
        }
    }

    /// Whether all rows hold at the exact point `x + e`.
    fn rows_hold(&self, problem: &Problem, tableau: &Tableau<f64>, point: &[f64]) -> bool {
        let n = point.len();
        let within = |e: &Equation| {
            let (lower, upper) = problem.range(e.row);
            lower <= e.target && e.target <= upper
        };
        // The exact activity of a row, if it is solved.
        let activity = |row: usize| self.equations.iter().find(|e| e.row == row).map(|e| e.target);
        let others = tableau.columns.variable.iter().filter_map(|&v| (v as usize).checked_sub(n));
        let mut basic = tableau.rows.variable.iter().enumerate();
        self.equations.iter().all(within)
            && others.filter(|&i| activity(i).is_none()).all(|i| self.holds_around(problem, i, point))
            && basic.all(|(r, &v)| match (v as usize).checked_sub(n) {
                None => true,
                Some(i) => self.holds_around(problem, i, point) || is_implied(problem, tableau, r, activity),
            })
    }

    /// Whether row `i` holds for all points within the displacements.
    fn holds_around(&self, problem: &Problem, i: usize, point: &[f64]) -> bool {
        let row = problem.row(i);
        let moved = row.iter().zip(&self.displacements).filter(|(a, e)| **a != 0.0 && **e != (0.0, 0.0));
        if moved.clone().next().is_none() {
            return holds(problem, i, point);
        }
        let reach = moved.fold((0.0, 0.0), |sum, (&a, &e)| add_scaled(sum, a, e));
        let (lower, upper) = problem.range(i);
        let above_lower = || add_down(dot_enclosure(-lower, row, point).0, reach.0) >= 0.0;
        let below_upper = || add_up(dot_enclosure(-upper, row, point).1, reach.1) <= 0.0;
        (lower == f64::NEG_INFINITY || above_lower()) && (upper == f64::INFINITY || below_upper())
    }
}

/// Lower bound of the exact `1 - x`, for `|x| <= 1`.
fn room(x: f64) -> f64 {
    // The difference of numbers within a factor of two of each other is exact.
    if x >= 0.5 { 1.0 - x } else { add_down(1.0, -x) }
}
