//! Bad input, unbounded ranges, contradictions and their names, memory.

use allocation_counter::measure;
use nonlin_bounds::{
    BoundError, Conflict, Contraction, ForwardBackward, Function, IntervalNewton, Operand, Smoothness, Tape, Workspace,
};
use scalars::{Interval, Scalar};

use crate::common::functions::{AttitudeOutput, Landmarks, UnitNorm};

fn interval(lo: f64, hi: f64) -> Interval {
    Interval::new(lo, hi).unwrap()
}

/// Outputs `x0 + x1`, `sqrt(x0)`, `x0 / x1`, `|x1|`.
struct Mixed;

impl Function for Mixed {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        4
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0] + x[1];
        y[1] = x[0].sqrt();
        y[2] = x[0] / x[1];
        y[3] = x[1].abs();
    }
}

const ALL: Interval = Interval::ENTIRE;

fn propagate(x: &mut [Interval], y: &[Interval]) -> Result<Contraction, BoundError> {
    ForwardBackward::default().contract(&Tape::record(&Mixed), x, &[], y, &mut Workspace::new())
}

#[test]
fn wrong_lengths_and_empty_sides_are_errors() {
    let (tape, mut workspace) = (Tape::record(&Landmarks), Workspace::new());
    let (x, p, y) = ([interval(-1.0, 1.0); 3], [Interval::ONE; 4], [ALL; 4]);
    let nan = [Interval::ONE, Interval::EMPTY, Interval::ONE, Interval::ONE];
    let dimension = |operand, expected, found| BoundError::Dimension { operand, expected, found };
    let empty = |operand| BoundError::EmptyInterval { operand, index: 1 };
    for (x, p, y, error) in [
        (&x[..2], &p[..], &y[..], dimension(Operand::Variables, 3, 2)),
        (&x, &p[..3], &y, dimension(Operand::Parameters, 4, 3)),
        (&x, &p, &y[..1], dimension(Operand::Outputs, 4, 1)),
        (&nan[..3], &p, &y, empty(Operand::Variables)),
        (&x, &nan, &y, empty(Operand::Parameters)),
        (&x, &p, &nan, empty(Operand::Outputs)),
    ] {
        let mut copy = x.to_vec();
        let result = ForwardBackward::default().contract(&tape, &mut copy, p, y, &mut workspace);
        assert_eq!(result, Err(error.clone()));
        let result = IntervalNewton::default().contract(&Landmarks, &mut copy, p, y, &mut workspace);
        assert_eq!(result, Err(error));
        assert_eq!(copy, x);
    }
}

#[test]
fn newton_refuses_what_is_not_smooth_or_not_bounded() {
    let mut workspace = Workspace::new();
    for (start, smooth) in [([interval(1.0, 2.0), interval(-1.0, 1.0)], false), ([interval(1.0, 2.0), ALL], true)] {
        let mut x = start;
        let result = IntervalNewton::default().contract(&Mixed, &mut x, &[], &[ALL; 4], &mut workspace);
        match result.unwrap_err() {
            BoundError::NotSmooth { required, .. } => assert!(!smooth && required == Smoothness::C1),
            BoundError::NonFinite { operand, index } => assert!(smooth && (operand, index) == (Operand::Variables, 1)),
            error => panic!("{error}"),
        }
        assert_eq!(x, start);
    }
}

/// Domains restrict, also where nothing is required of the output.
#[test]
fn solutions_are_points_where_all_outputs_are_defined() {
    let mut x = [ALL, ALL];
    assert!(!propagate(&mut x, &[ALL; 4]).unwrap().is_empty());
    assert_eq!(x, [interval(0.0, f64::INFINITY), ALL]);
    let mut x = [interval(-2.0, -1.0), ALL];
    let conflict = Conflict::Output { output: 1, sweep: 1 };
    assert_eq!(propagate(&mut x, &[ALL; 4]).unwrap(), Contraction::ProvenEmpty(conflict));
    assert_eq!(x, [interval(-2.0, -1.0), ALL]);
    // x0 / 0 is not defined.
    let mut x = [ALL, Interval::ZERO];
    let conflict = Conflict::Output { output: 2, sweep: 1 };
    assert_eq!(propagate(&mut x, &[ALL; 4]).unwrap(), Contraction::ProvenEmpty(conflict));
}

/// What states nothing may be defined nowhere; what it shares with stated outputs still counts.
#[test]
fn outputs_without_a_statement_are_not_asked_for() {
    let stated = |x: &mut [Interval], y: &[Interval]| {
        ForwardBackward::default().contract_stated(&Tape::record(&Mixed), x, &[], y, &mut Workspace::new()).unwrap()
    };
    let start = [interval(-2.0, -1.0), Interval::ZERO];
    let mut x = start;
    assert!(!stated(&mut x, &[ALL; 4]).is_empty());
    assert_eq!(x, start);
    let mut y = [ALL; 4];
    for output in [1, 2] {
        y = [ALL; 4];
        y[output] = interval(-1e300, 1e300);
        assert_eq!(stated(&mut x, &y), Contraction::ProvenEmpty(Conflict::Output { output, sweep: 1 }));
        assert_eq!(x, start);
    }
    // All stated: nothing changes.
    y.fill(interval(0.25, 1.0));
    let (mut one, mut other) = ([ALL; 2], [ALL; 2]);
    assert_eq!(stated(&mut one, &y), propagate(&mut other, &y).unwrap());
    assert_eq!(one, other);
}

#[test]
fn one_sided_ranges_bound_unbounded_boxes() {
    let mut x = [ALL, ALL];
    let y = [interval(f64::NEG_INFINITY, 5.0), interval(1.0, f64::INFINITY), ALL, interval(0.0, 2.0)];
    assert!(!propagate(&mut x, &y).unwrap().is_empty());
    assert!(x[0].contains(1.0) && x[0].contains(7.0) && x[0].subset_of(&interval(1.0 - 1e-14, 7.0 + 1e-14)));
    assert_eq!(x[1], interval(-2.0, 2.0));
}

#[test]
fn a_contradiction_names_the_output() {
    let ok = [interval(-10.0, 10.0), interval(0.0, 3.0), interval(-9.0, 9.0), interval(0.0, 2.0)];
    let start = [interval(0.5, 4.0), interval(1.0, 2.0)];
    for (output, impossible) in [(0, 7.0), (1, 2.5), (2, -1.0), (3, 0.5)] {
        let mut y = ok;
        y[output] = interval(impossible, impossible);
        let mut x = start;
        let outcome = propagate(&mut x, &y).unwrap();
        assert_eq!(outcome, Contraction::ProvenEmpty(Conflict::Output { output, sweep: 1 }));
        assert_eq!(x, start);
    }
    // Both are possible alone, not together: the one revised last is named.
    let mut x = start;
    let y = [Interval::point(5.5), interval(0.0, 1.5), ALL, ALL];
    let outcome = propagate(&mut x, &y).unwrap();
    assert!(matches!(outcome, Contraction::ProvenEmpty(Conflict::Output { output: 0 | 1, .. })), "{outcome:?}");
    assert_eq!(x, start);
}

#[test]
fn no_sweep_no_change() {
    let mut x = [interval(0.0, 4.0), interval(1.0, 2.0)];
    let start = x;
    let contractor = ForwardBackward { sweeps: 0, least_gain: f64::NAN };
    let outcome = contractor.contract(&Tape::record(&Mixed), &mut x, &[], &[Interval::ONE; 4], &mut Workspace::new());
    assert_eq!((outcome, x), (Ok(Contraction::Undecided { sweeps: 0 }), start));
}

#[test]
fn a_warm_contraction_allocates_nothing() {
    let (tape, norm, mut workspace) = (Tape::record(&AttitudeOutput), UnitNorm { dim: 4 }, Workspace::new());
    let start = [0.1, 0.9, 0.05, -0.1].map(|x| Interval::point(x).inflate(0.18));
    let y = [-0.8, 0.2, -0.1, 0.2, 0.8, 0.1].map(|y| Interval::point(y).inflate(0.3));
    let mut run = || {
        let mut x = start;
        let mut sum = 0;
        for outcome in [
            ForwardBackward::default().contract(&tape, &mut x, &[], &y, &mut workspace),
            IntervalNewton::default().contract(&AttitudeOutput, &mut x, &[], &y, &mut workspace),
            IntervalNewton::default().contract(&norm, &mut x, &[], &[Interval::ZERO], &mut workspace),
        ] {
            sum += usize::from(outcome.unwrap().is_empty());
        }
        sum
    };
    let mut empty = run();
    assert_eq!(measure(|| empty += run()).count_total, 0);
    assert_eq!(empty, 0);
}
