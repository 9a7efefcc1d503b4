//! Steps of the set-valued filters on the attitude of paper 003, section 5.2: against Clarabel, against each other, phase by phase.

use std::hint::black_box;
use std::rc::Rc;
use std::time::Duration;

use estimators::{
    CzFilter, CzOptions, Estimator, Method, Phase, Rcz, RczOptions, RczState, Relation, SetFilter, System,
};
use nalgebra::DMatrix;
use scenarios::cz_attitude::plant::{AttitudeStep, start, system};
use scenarios::cz_attitude::simulation::simulate;
use scenarios::monte_carlo;
use scenarios::noise::NoiseKind;
use scenarios::set_study::Trajectory;
use setrep::{Complexity, ConstrainedZonotope, Workspace};

use crate::lp_peers::{Clarabel, hull_objectives};
use crate::timing::{Bench, processor_time};

/// Bound on the noise of the measurements, as the paper prints it.
const NOISE: f64 = 0.15;
/// Steps of the run: the sets are small from about the tenth on.
const STEPS: usize = 60;
/// The paper's limit of the size of sets.
const LIMIT: Option<Complexity> = Some(Complexity { generators: 12, constraints: 5 });
/// The steps that are timed against Clarabel.
const REPLAYED: std::ops::Range<usize> = 20..28;

/// The rows `rcz-step/*` and `filter-step/*`.
pub fn benches() -> Vec<Bench> {
    let run = Rc::new(run());
    let (rcz, czfo_c) = (rcz(RczOptions::fast(4)), paper(CzOptions::czfo(LIMIT).with_consistency()));
    let mut benches = vec![against_clarabel(&run), duel("filter-step/rcz", &rcz, "czfo+c", &czfo_c, &run)];
    for (name, options) in [("czmv+c", CzOptions::czmv(LIMIT)), ("czfo", CzOptions::czfo(LIMIT))] {
        let options = if name == "czmv+c" { options.with_consistency() } else { options };
        benches.push(duel(&format!("filter-step/{name}"), &paper(options), "czfo+c", &czfo_c, &run));
    }
    benches.extend(phases("rcz", &rcz, &run));
    benches.extend(phases("czmv+c", &paper(CzOptions::czmv(LIMIT).with_consistency()), &run));
    benches.extend(phases("czfo+c", &czfo_c, &run));
    benches
}

/// A filter of the paper.
fn paper(options: CzOptions) -> CzFilter {
    let start = start().expect("the start is a zonotope");
    CzFilter::new(attitude(), start.into(), options).expect("the sizes fit")
}

fn attitude() -> System {
    system(Relation::new(AttitudeStep), NOISE).expect("the sizes fit")
}

fn run() -> Trajectory {
    simulate(NOISE, NoiseKind::Uniform, STEPS, &mut monte_carlo::stream(1, "bench", 0)).expect("the steps are proven")
}

fn rcz(options: RczOptions) -> Rcz {
    let start = start().expect("the start is a zonotope");
    Rcz::new(attitude(), start.into(), options).expect("the sizes fit")
}

/// One step of a filter: where it starts, what it gets, and the linear programs that it solves.
struct Replay {
    state: RczState,
    input: Vec<f64>,
    output: Vec<f64>,
    programs: Vec<(ConstrainedZonotope, Vec<Vec<f64>>)>,
}

/// The steps of the run with their linear programs.
///
/// The sets behind the programs are those that the filter shows: the set to be reduced, the predicted set, the updated set of each
/// pass (seen by a filter with so many passes). Of a reduction only the programs along the axes, the new frame and the directions that
/// were chosen are kept: the filter also solves those of the directions that were not.
fn replays(run: &Trajectory) -> Vec<Replay> {
    let (mut filter, mut workspace, mut replays) = (rcz(RczOptions::fast(4)), Workspace::new(), Vec::new());
    filter.update(&run.outputs[0]).expect("the noises keep their bounds");
    for k in 0..REPLAYED.end {
        let (input, output) = (&run.inputs[k], &run.outputs[k + 1]);
        let state = filter.state().clone();
        let mut programs = vec![reduction(&filter, &mut workspace)];
        filter.predict(input).expect("the model is smooth");
        programs.push(hull(filter.enclosure()));
        let predicted = filter.state().clone();
        let passes = filter.options().passes;
        for pass in 1..=passes {
            filter.options_mut().passes = pass;
            filter.restore(&predicted).expect("a state of this filter");
            filter.update(output).expect("the noises keep their bounds");
            let updated = hull(filter.enclosure());
            // The passes may have ended before.
            if programs.last().is_some_and(|(set, _)| *set == updated.0) {
                break;
            }
            programs.push(updated);
        }
        filter.options_mut().passes = passes;
        if REPLAYED.contains(&k) {
            replays.push(Replay { state, input: input.clone(), output: output.clone(), programs });
        }
    }
    replays
}

/// The programs of a hull.
fn hull(set: &ConstrainedZonotope) -> (ConstrainedZonotope, Vec<Vec<f64>>) {
    (set.clone(), hull_objectives(set))
}

/// The programs of the reduction that is due.
fn reduction(filter: &Rcz, workspace: &mut Workspace) -> (ConstrainedZonotope, Vec<Vec<f64>>) {
    let mut reduced = filter.clone();
    reduced.reduce().expect("the entries are moderate");
    let mut set = filter.enclosure().clone();
    set.rescale(workspace).expect("the entries are moderate");
    let mut objectives = hull_objectives(&set);
    let n = set.dim();
    let frame = DMatrix::from_column_slice(n, n, reduced.enclosure().generators().as_slice());
    let inverse = frame.try_inverse().expect("a set with an inside");
    let rows = (0..n).map(|i| inverse.row(i).iter().copied().collect::<Vec<f64>>());
    let chosen = reduced.state().memory.directions.iter().map(<[f64]>::to_vec);
    for direction in rows.chain(chosen) {
        let along = |sign: f64| {
            let dot = |column: &[f64]| sign * column.iter().zip(&direction).map(|(g, d)| g * d).sum::<f64>();
            set.generators().columns().map(dot).collect()
        };
        objectives.extend([along(1.0), along(-1.0)]);
    }
    (set, objectives)
}

/// Whole steps, everything included, against Clarabel solving their linear programs and nothing else.
fn against_clarabel(run: &Trajectory) -> Bench {
    let replays = Rc::new(replays(run));
    let (mut filter, ours) = (rcz(RczOptions::fast(4)), replays.clone());
    let steps = ours.len();
    let step = move || {
        for replay in ours.iter() {
            filter.restore(&replay.state).expect("a state of this filter");
            filter.predict(&replay.input).expect("the model is smooth");
            filter.update(&replay.output).expect("the noises keep their bounds");
            black_box(filter.hull());
        }
    };
    let programs = move || {
        for (set, objectives) in replays.iter().flat_map(|replay| &replay.programs) {
            let mut solver = Clarabel::new(set);
            for objective in objectives {
                black_box(solver.maximize(objective));
            }
        }
    };
    Bench::new("rcz-step/attitude", "clarabel-lps", step, programs).batched(steps)
}

/// A filter that goes along the run again and again.
struct Runner<M: Method> {
    filter: SetFilter<M>,
    fresh: SetFilter<M>,
    run: Rc<Trajectory>,
    outputs: Vec<Vec<Option<f64>>>,
    k: usize,
}

impl<M: Method> Runner<M> {
    fn new(filter: &SetFilter<M>, run: &Rc<Trajectory>) -> Self {
        let outputs = run.outputs.iter().map(|y| y.iter().copied().map(Some).collect()).collect();
        Self { filter: filter.clone(), fresh: filter.clone(), run: run.clone(), outputs, k: 0 }
    }

    /// The next update and prediction.
    fn step(&mut self, trace: &mut dyn FnMut(Phase)) {
        if self.k == self.run.inputs.len() {
            self.filter.restore(self.fresh.state()).expect("a state of this filter");
            self.k = 0;
        }
        self.filter.update_traced(&self.outputs[self.k], &[], trace).expect("the noises keep their bounds");
        self.filter.predict_traced(&self.run.inputs[self.k], trace).expect("the model is smooth");
        self.k += 1;
    }

    /// Processor time of one phase of the next step; of all of it without a phase.
    fn time(&mut self, of: Option<Phase>) -> Duration {
        let (mut mark, mut sum) = (processor_time(), Duration::ZERO);
        self.step(&mut |phase| {
            let now = processor_time();
            if of.is_none_or(|of| of == phase) {
                sum += now - mark;
            }
            mark = now;
        });
        sum
    }
}

/// Each phase of a step along the whole run against the step.
fn phases<M: Method + 'static>(name: &str, filter: &SetFilter<M>, run: &Rc<Trajectory>) -> Vec<Bench> {
    let all = [
        ("prediction", Phase::Prediction),
        ("update", Phase::Update),
        ("consistency", Phase::Consistency),
        ("reduction", Phase::Reduction),
    ];
    let mut seen = Vec::new();
    let mut runner = Runner::new(filter, run);
    for _ in 0..STEPS {
        runner.step(&mut |phase| seen.push(phase));
    }
    let row = |(label, phase): (&str, Phase)| {
        let (mut part, mut whole) = (Runner::new(filter, run), Runner::new(filter, run));
        let steps = run.inputs.len();
        let part = move || (0..steps).map(|_| part.time(Some(phase))).sum();
        let whole = move || (0..steps).map(|_| whole.time(None)).sum();
        Bench::clocked(format!("filter-step/{name}-{label}"), "whole-step", part, whole).batched(steps)
    };
    all.into_iter().filter(|(_, phase)| seen.contains(phase)).map(row).collect()
}

/// Whole steps along the run, of one filter against another.
fn duel<M: Method + 'static, P: Method + 'static>(
    name: &str,
    ours: &SetFilter<M>,
    peer: &'static str,
    theirs: &SetFilter<P>,
    run: &Rc<Trajectory>,
) -> Bench {
    let (mut ours, mut theirs) = (Runner::new(ours, run), Runner::new(theirs, run));
    let steps = run.inputs.len();
    let ours = move || (0..steps).for_each(|_| ours.step(&mut |_| {}));
    Bench::new(name, peer, ours, move || (0..steps).for_each(|_| theirs.step(&mut |_| {}))).batched(steps)
}
