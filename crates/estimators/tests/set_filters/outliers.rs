//! Outliers: a contradiction is proven where the rows of the last pass have no solution, and nowhere else. The oracles are another LP
//! solver and exact rationals.

use estimators::{Culprit, Estimator, EstimatorError, Evidence, Inconsistency, Rcz, RczOptions, System};
use microlp::{ComparisonOp, OptimizationDirection};
use num_rational::BigRational;
use scalars::Interval;
use setrep::{ConstrainedZonotope, Contradiction, Membership, Workspace};

use crate::plants::{
    Draw, PlanarOutput, attitude, attitude_run, attitude_start, planar, planar_run, planar_start, value,
};
use crate::support::{Random, cases};

/// The least `t` for which some `|xi| <= 1` keeps every row within its range `+- t`.
fn least_violation(set: &ConstrainedZonotope) -> f64 {
    let mut program = microlp::Problem::new(OptimizationDirection::Minimize);
    let xi: Vec<_> = (0..set.num_generators()).map(|_| program.add_var(0.0, (-1.0, 1.0))).collect();
    let t = program.add_var(1.0, (0.0, f64::INFINITY));
    for (i, range) in set.ranges().iter().enumerate() {
        let row = |sign: f64| {
            let terms = xi.iter().enumerate().map(|(j, &xi)| (xi, set.constraints()[(i, j)]));
            terms.chain([(t, sign)]).collect::<Vec<_>>()
        };
        if range.hi().is_finite() {
            program.add_constraint(row(-1.0), ComparisonOp::Le, range.hi());
        }
        if range.lo().is_finite() {
            program.add_constraint(row(1.0), ComparisonOp::Ge, range.lo());
        }
    }
    program.solve().unwrap().into_solution().unwrap().objective()
}

/// Whether the multipliers prove that no `|xi| <= 1` keeps all rows: `sum_i max(y_i lo_i, y_i hi_i) + |A'y|_1 < 0`, exactly.
fn proves_empty(set: &ConstrainedZonotope, certificate: &Contradiction) -> bool {
    let rational = |x: f64| BigRational::from_float(x).unwrap();
    let zero = rational(0.0);
    let mut sums = vec![zero.clone(); set.num_generators()];
    let mut bound = zero.clone();
    for &(row, y) in certificate.multipliers() {
        let range = set.ranges()[row];
        let end = if y > 0.0 { range.hi() } else { range.lo() };
        bound += rational(y) * rational(end);
        for (j, sum) in sums.iter_mut().enumerate() {
            *sum += rational(y) * rational(set.constraints()[(row, j)]);
        }
    }
    bound += sums.iter().map(|sum| if *sum < zero { -sum.clone() } else { sum.clone() }).sum::<BigRational>();
    bound < zero
}

/// What became of outliers.
#[derive(Debug, Default)]
struct Tally {
    /// Proven, by which evidence.
    by_rows: usize,
    disjoint: usize,
    by_values: usize,
    /// Not proven though the rows of the last pass are infeasible by 1e-6.
    missed: usize,
    /// Not proven, and the rows have solutions.
    feasible: usize,
}

impl Tally {
    /// Updates the filter with a wrong measurement; afterwards it is as before.
    fn add(&mut self, filter: &mut Rcz, wrong: &[f64]) {
        let before = filter.state().clone();
        match filter.update(wrong) {
            Ok(()) => {
                let violation = least_violation(filter.enclosure());
                *if violation >= 1e-6 { &mut self.missed } else { &mut self.feasible } += 1;
                filter.restore(&before).unwrap();
            }
            Err(EstimatorError::Inconsistent(proof)) => {
                self.add_proof(&proof, filter.system());
                assert_eq!(filter.state(), &before);
            }
            Err(error) => panic!("{error}"),
        }
    }

    fn add_proof(&mut self, proof: &Inconsistency, system: &System) {
        assert!(proof.culprits.contains(&Culprit::Prediction) && proof.culprits.len() > 1, "{proof}");
        match &proof.evidence {
            Evidence::Rows { set, certificate } => {
                assert!(proof.verify() && proof.margin() > 0.0);
                assert!(proves_empty(set, certificate), "{proof}");
                assert!(least_violation(set) > 0.0, "{proof}");
                self.by_rows += 1;
            }
            Evidence::Disjoint { predicted, required } => {
                assert!(proof.verify() && proof.margin() > 0.0);
                assert!(predicted.hi() < required.lo() || required.hi() < predicted.lo());
                self.disjoint += 1;
            }
            _ => {
                assert!(proof.verify_with(system) && !proof.verify(), "{proof}");
                self.by_values += 1;
            }
        }
    }

    fn proven(&self) -> usize {
        self.by_rows + self.disjoint + self.by_values
    }
}

/// An outlier of five times the bound in one output, after a few steps.
#[test]
fn outliers_are_proven_where_the_rows_have_no_solution() {
    let mut random = Random::new(81);
    let (mut attitudes, mut planes) = (Tally::default(), Tally::default());
    for _ in 0..cases(20) {
        let mut filter = Rcz::new(attitude(0.15), attitude_start(), RczOptions::fast(4)).unwrap();
        let run = attitude_run(0.15, Draw::Uniform, 12, &mut random);
        for (k, (_, y, _)) in run.iter().enumerate() {
            if k > 0 {
                filter.predict(&run[k - 1].2).unwrap();
            }
            let mut wrong = y.clone();
            wrong[random.below(6)] += 5.0 * 0.15 * random.sign();
            attitudes.add(&mut filter, &wrong);
            filter.update(y).unwrap();
        }
        let mut filter = Rcz::new(planar(), planar_start(), RczOptions::fast(2)).unwrap();
        for (k, (_, y)) in planar_run(Draw::Uniform, 10, &mut random).iter().enumerate() {
            if k > 0 {
                filter.predict(&[]).unwrap();
            }
            let mut wrong = y.clone();
            wrong[random.below(2)] += 5.0 * 0.4 * random.sign();
            planes.add(&mut filter, &wrong);
            filter.update(y).unwrap();
        }
    }
    println!("5.2: {attitudes:?}\n5.1: {planes:?}");
    for tally in [attitudes, planes] {
        assert!(tally.proven() * 100 >= 95 * (tally.proven() + tally.missed), "{tally:?}");
        assert!(tally.proven() >= tally.feasible, "{tally:?}");
    }
}

/// What some state of the set would have measured is never refuted, however unlikely that state is.
#[test]
fn measurements_of_any_state_of_the_set_are_consistent() {
    let (mut random, mut workspace, mut tried) = (Random::new(82), Workspace::new(), 0);
    for _ in 0..cases(20) {
        let mut filter = Rcz::new(planar(), planar_start(), RczOptions::fast(2)).unwrap();
        for (k, (_, y)) in planar_run(Draw::Uniform, 10, &mut random).iter().enumerate() {
            if k > 0 {
                filter.predict(&[]).unwrap();
            }
            let before = filter.state().clone();
            for _ in 0..4 {
                let x: Vec<f64> = before.hull.iter().map(|side| side.mid() + side.rad() * random.unit()).collect();
                let point: Vec<Interval> = x.iter().map(|&x| Interval::point(x)).collect();
                if before.set.membership(&point, &mut workspace).unwrap() != Membership::ProvenInside {
                    continue;
                }
                let v = [(); 2].map(|()| Draw::Vertex.noise(0.4, &mut random));
                filter.update(&value(&PlanarOutput, &[&x[..], &v].concat(), &[])).unwrap();
                filter.restore(&before).unwrap();
                tried += 1;
            }
            filter.update(y).unwrap();
        }
    }
    println!("{tried} measurements of other states");
    assert!(tried >= cases(200));
}
