//! Clarabel (interior point) as an oracle: one factorisation pattern a set, the objective updated.

use boxlp::Problem;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, SolverStatus, SupportedConeT,
};

/// The maxima of the objectives; `None` where the status is not `Solved`.
pub(crate) fn maximize(problem: &Problem, objectives: &[Vec<f64>]) -> Vec<Option<f64>> {
    let (n, m) = (problem.variables(), problem.rows());
    let (mut equal, mut below) = (Vec::new(), Vec::new());
    for i in 0..m {
        let (lower, upper) = problem.range(i);
        if lower == upper {
            equal.push((problem.row(i).to_vec(), upper));
            continue;
        }
        if upper.is_finite() {
            below.push((problem.row(i).to_vec(), upper));
        }
        if lower.is_finite() {
            below.push((problem.row(i).iter().map(|a| -a).collect(), -lower));
        }
    }
    for j in 0..n {
        for sign in [1.0, -1.0] {
            let mut row = vec![0.0; n];
            row[j] = sign;
            below.push((row, 1.0));
        }
    }
    let cones = [
        SupportedConeT::ZeroConeT(equal.len()),
        SupportedConeT::NonnegativeConeT(below.len()),
    ];
    let rows: Vec<(Vec<f64>, f64)> = equal.into_iter().chain(below).collect();
    let (mut is, mut js, mut values) = (Vec::new(), Vec::new(), Vec::new());
    for (i, (row, _)) in rows.iter().enumerate() {
        for (j, &a) in row.iter().enumerate().filter(|(_, a)| **a != 0.0) {
            is.push(i);
            js.push(j);
            values.push(a);
        }
    }
    let a = CscMatrix::new_from_triplets(rows.len(), n, is, js, values);
    let b: Vec<f64> = rows.iter().map(|r| r.1).collect();
    let settings = DefaultSettingsBuilder::default()
        .verbose(false)
        .presolve_enable(false)
        .build()
        .unwrap();
    let negated = |c: &[f64]| c.iter().map(|c| -c).collect::<Vec<f64>>();
    let p = CscMatrix::zeros((n, n));
    let mut solver =
        DefaultSolver::new(&p, &negated(&objectives[0]), &a, &b, &cones, settings).unwrap();
    let solve = |c: &Vec<f64>| {
        solver.update_q(&negated(c)).unwrap();
        solver.solve();
        (solver.solution.status == SolverStatus::Solved).then_some(-solver.solution.obj_val)
    };
    objectives.iter().map(solve).collect()
}
