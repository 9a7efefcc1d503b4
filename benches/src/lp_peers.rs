//! The LP solvers our hulls are timed against, each used as well as its interface allows.
//!
//! Both maximise the generator coordinates' linear functions over `|xi| <= 1`, `A xi in [b]`; a hull is `2 n` of them. Neither
//! returns a proven bound: what is timed is their plain answer.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettingsBuilder, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use microlp::{ComparisonOp, OptimizationDirection};
use setrep::ConstrainedZonotope;

/// The objectives of a hull over the coordinates: both signs of every row of the generators.
pub fn hull_objectives(set: &ConstrainedZonotope) -> Vec<Vec<f64>> {
    let row = |i: usize, sign: f64| (0..set.num_generators()).map(|j| sign * set.generators().col(j)[i]).collect();
    (0..set.dim()).flat_map(|i| [row(i, 1.0), row(i, -1.0)]).collect()
}

/// Row `i` of the constraints.
fn constraint(set: &ConstrainedZonotope, i: usize) -> Vec<f64> {
    (0..set.num_generators()).map(|j| set.constraints().col(j)[i]).collect()
}

/// Clarabel, an interior point method: the problem is set up and its pattern factorised once, then only the objective changes.
pub struct Clarabel {
    solver: DefaultSolver<f64>,
    negated: Vec<f64>,
}

impl Clarabel {
    /// Sets the problem up.
    pub fn new(set: &ConstrainedZonotope) -> Self {
        let n = set.num_generators();
        let (mut equal, mut below) = (Vec::new(), Vec::new());
        for (i, range) in set.ranges().iter().enumerate() {
            let row = constraint(set, i);
            if range.lo() == range.hi() {
                equal.push((row, range.hi()));
            } else {
                below.push((row.iter().map(|a| -a).collect(), -range.lo()));
                below.push((row, range.hi()));
            }
        }
        for j in 0..n {
            for sign in [1.0, -1.0] {
                let mut row = vec![0.0; n];
                row[j] = sign;
                below.push((row, 1.0));
            }
        }
        let cones = [SupportedConeT::ZeroConeT(equal.len()), SupportedConeT::NonnegativeConeT(below.len())];
        let rows: Vec<(Vec<f64>, f64)> = equal.into_iter().chain(below).collect();
        let entries = rows
            .iter()
            .enumerate()
            .flat_map(|(i, (row, _))| row.iter().enumerate().filter(|(_, a)| **a != 0.0).map(move |(j, &a)| (i, j, a)));
        let (mut is, mut js, mut values) = (Vec::new(), Vec::new(), Vec::new());
        for (i, j, a) in entries {
            is.push(i);
            js.push(j);
            values.push(a);
        }
        let a = CscMatrix::new_from_triplets(rows.len(), n, is, js, values);
        let b: Vec<f64> = rows.iter().map(|r| r.1).collect();
        // Presolve forbids changing the objective.
        let settings = DefaultSettingsBuilder::default().verbose(false).presolve_enable(false).build();
        let settings = settings.expect("default settings");
        let solver = DefaultSolver::new(&CscMatrix::zeros((n, n)), &vec![1.0; n], &a, &b, &cones, settings);
        Self { solver: solver.expect("a valid problem"), negated: vec![0.0; n] }
    }

    /// The maximum of one objective.
    pub fn maximize(&mut self, objective: &[f64]) -> f64 {
        for (q, c) in self.negated.iter_mut().zip(objective) {
            *q = -c;
        }
        self.solver.update_q(&self.negated).expect("presolve is off");
        self.solver.solve();
        debug_assert_eq!(self.solver.solution.status, SolverStatus::Solved);
        -self.solver.solution.obj_val
    }
}

/// microlp, a sparse simplex method, as one problem per objective: it can not change an objective. The problems are built
/// beforehand, so only its solves are timed.
pub struct Microlp {
    problems: Vec<microlp::Problem>,
}

impl Microlp {
    /// Builds the problems.
    pub fn new(set: &ConstrainedZonotope, objectives: &[Vec<f64>]) -> Self {
        let build = |objective: &Vec<f64>| {
            let mut problem = microlp::Problem::new(OptimizationDirection::Maximize);
            let x: Vec<_> = objective.iter().map(|&c| problem.add_var(c, (-1.0, 1.0))).collect();
            for (i, range) in set.ranges().iter().enumerate() {
                let terms: Vec<_> = x.iter().copied().zip(constraint(set, i)).collect();
                if range.lo() == range.hi() {
                    problem.add_constraint(terms.as_slice(), ComparisonOp::Eq, range.hi());
                } else {
                    problem.add_constraint(terms.as_slice(), ComparisonOp::Le, range.hi());
                    problem.add_constraint(terms.as_slice(), ComparisonOp::Ge, range.lo());
                }
            }
            problem
        };
        Self { problems: objectives.iter().map(build).collect() }
    }

    /// The maximum of the `k`-th objective.
    pub fn maximum(&self, k: usize) -> f64 {
        let outcome = self.problems[k].solve().expect("the sets are not empty");
        outcome.into_solution().expect("no limit was set").objective()
    }
}
