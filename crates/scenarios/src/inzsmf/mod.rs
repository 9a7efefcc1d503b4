//! Experiment `inzsmf`: the invariant zonotopic set-membership filter of paper 000 against its Euclidean counterpart.
//!
//! Reading order: [`cases`] (the paper's tables), [`published`] and [`sound`] (the filters), [`tracking`] and [`study`] (Monte Carlo
//! runs), [`errors`] and [`containment`] (whether the truth is lost), [`courses`] and [`figures`], [`tables`], [`verdicts`] and [`report`].

pub mod cases;
pub mod containment;
pub mod courses;
pub mod errors;
pub mod figures;
pub mod published;
pub mod report;
pub mod sound;
pub mod study;
pub mod tables;
pub mod tracking;
pub mod verdicts;

use setrep::Reduction;

use crate::noise::NoiseKind;
use crate::{Context, Experiment, Mode, Output, Results, Row, ScenarioError};
use cases::{FIGURE_2_CASES, STEPS, TABLE_I, TABLE_II_CASE};
use courses::Courses;
use report::Scale;
use sound::Variant;
use study::{Cell, Contender};

/// Paper 000: Tables I and II, Figures 2 and 3, and how often the filters lose the truth.
#[derive(Clone, Copy, Debug)]
pub struct InZsmfExperiment;

impl Experiment for InZsmfExperiment {
    fn name(&self) -> &'static str {
        "inzsmf"
    }

    fn describe(&self) -> &'static str {
        "paper 000: InZSMF against ZSMF on a planar vehicle (Tables I and II, Figures 2 and 3, containment)"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let scale = scale(context)?;
        let contenders: Vec<Contender> = published::contenders()?
            .into_iter()
            .chain([Variant::of_the_paper(), Variant::pole()].iter().flat_map(Variant::contenders))
            .collect();
        let tables = table_cells(context, &scale, &contenders)?;
        let orders = order_cells(context, &scale)?;
        let courses = courses(context, &scale, &contenders)?;
        let tallies = containment::study(context, scale.containment_runs, scale.containment_stride)?;
        let timings = timings(context, &contenders)?;

        let mut results = Results::new(self.name(), context.seed, scale.runs);
        results.rows.extend(tables::table_i(&tables));
        results.rows.extend(tables::table_ii(&tables));
        results.rows.extend(tables::orders(&orders));
        results.rows.extend(tables::containment(&tallies));
        let cells: Vec<Cell> = tables.into_iter().chain(orders).collect();
        let evidence = verdicts::Evidence { cells: &cells, courses: &courses, containment: &tallies };
        let verdicts = verdicts::verdicts(&evidence);
        let report = report::report(&scale, verdicts, &results, &timings, &tallies);
        let figures = [Mode::Published, Mode::Sound]
            .into_iter()
            .flat_map(|mode| [figures::figure_2(&courses, mode), figures::figure_3(&courses, mode)])
            .collect();
        Ok(Output { results, timings, report, figures, curves: Vec::new() })
    }
}

/// The paper has five runs a cell; a hundred make the means certain to about a percent.
fn scale(context: &Context<'_>) -> Result<Scale, ScenarioError> {
    let runs = context.runs_or(100, 10);
    Ok(Scale {
        runs,
        order_runs: [runs.min(if context.quick { 4 } else { 50 }), runs.min(if context.quick { 1 } else { 20 })],
        containment_runs: runs.min(if context.quick { 4 } else { 20 }),
        containment_stride: if context.quick { 10 } else { 1 },
        truth_width: study::truth_of(context, NoiseKind::Uniform, STEPS, 0)?.widest(),
    })
}

/// Tables I and II: all filters from all initial estimates, those with placed poles from that of Table II.
fn table_cells(context: &Context<'_>, scale: &Scale, contenders: &[Contender]) -> Result<Vec<Cell>, ScenarioError> {
    let pairs: Vec<(usize, &Contender)> = (0..TABLE_I.len())
        .flat_map(|case| contenders.iter().map(move |contender| (case, contender)))
        .filter(|(case, contender)| *case == TABLE_II_CASE || !contender.method.contains("/pole"))
        .collect();
    study::study(context, "inzsmf tables", scale.runs, &pairs)
}

/// Sound reductions of other methods and orders, and none.
fn order_cells(context: &Context<'_>, scale: &Scale) -> Result<Vec<Cell>, ScenarioError> {
    let all: Vec<usize> = if context.quick { FIGURE_2_CASES.into() } else { (0..TABLE_I.len()).collect() };
    let pairs = |contenders: &'_ [Contender]| -> Vec<(usize, usize)> {
        all.iter().flat_map(|&case| (0..contenders.len()).map(move |index| (case, index))).collect()
    };
    let run = |label: &str, runs: usize, variants: &[Variant]| {
        let contenders: Vec<Contender> = variants.iter().flat_map(Variant::contenders).collect();
        let pairs: Vec<_> = pairs(&contenders).into_iter().map(|(case, index)| (case, &contenders[index])).collect();
        study::study(context, label, runs, &pairs)
    };
    let mut variants = Vec::new();
    for method in [Reduction::Combastel, Reduction::Girard, Reduction::Method4] {
        variants.extend([30, 60, 150].map(|order| Variant::reduced(method, order)));
    }
    // Combastel to 30 is the paper's setting: in Table I.
    let mut cells = run("inzsmf orders", scale.order_runs[0], &variants[1..])?;
    cells.extend(run("inzsmf without reduction", scale.order_runs[1], &[Variant::not_reduced()])?);
    Ok(cells)
}

fn courses(context: &Context<'_>, scale: &Scale, contenders: &[Contender]) -> Result<Courses, ScenarioError> {
    let plain = |contender: &&Contender| ["zsmf", "inzsmf"].contains(&&*contender.method);
    let placed = |contender: &&Contender| ["zsmf/pole", "inzsmf/pole"].contains(&&*contender.method);
    let mut pairs: Vec<(usize, &Contender)> = Vec::new();
    for case in FIGURE_2_CASES.into_iter().chain([TABLE_II_CASE]) {
        pairs.extend(contenders.iter().filter(plain).map(|contender| (case, contender)));
    }
    pairs.extend(contenders.iter().filter(placed).map(|contender| (TABLE_II_CASE, contender)));
    courses::record(context, scale.runs, &pairs)
}

/// Times of a step, one after the other on one thread.
fn timings(context: &Context<'_>, contenders: &[Contender]) -> Result<Vec<Row>, ScenarioError> {
    let truth = study::truth_of(context, NoiseKind::Uniform, STEPS, 0)?;
    let mut times = Vec::new();
    for case in 0..TABLE_I.len() {
        let plain = |method: &str| ["zsmf", "inzsmf"].contains(&method);
        let placed = |method: &str| case == TABLE_II_CASE && method.ends_with("/pole");
        for contender in contenders.iter().filter(|c| plain(&c.method) || placed(&c.method)) {
            times.push((case, contender, study::step_time_s(context, &truth, contender, case)?));
        }
    }
    Ok(tables::timings(&times))
}
