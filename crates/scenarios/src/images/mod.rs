//! Experiment `images`: what encloses the image of a set under a function, or the solutions in it, how tightly and at what cost.
//!
//! Reading order: [`models`], [`enclosure`], [`outline`] and [`plane`] (what is enclosed and measured), [`figure_1`], [`figure_4`] and
//! [`lemma_2`] (paper 003); [`families`], [`sets`], [`methods`] and [`tightness`] (all methods on random functions and sets); [`figures`],
//! [`report`].

pub mod enclosure;
pub mod families;
pub mod figure_1;
pub mod figure_4;
pub mod figures;
pub mod lemma_2;
pub mod methods;
pub mod models;
pub mod outline;
pub mod plane;
pub mod report;
pub mod sets;
pub mod tightness;

use setrep::Workspace;

use crate::{Context, Experiment, Output, Results, ScenarioError};
use plane::Measured;

/// Functions and sets drawn for a cell of the tightness tables: full size, quick.
const RUNS: (usize, usize) = (40, 4);

/// Figures 1 and 4 of paper 003, the counterexample to its Lemma 2 as printed, and the tightness of every method.
#[derive(Clone, Copy, Debug)]
pub struct ImagesExperiment;

impl Experiment for ImagesExperiment {
    fn name(&self) -> &'static str {
        "images"
    }

    fn describe(&self) -> &'static str {
        "images and solution sets of functions: Figures 1 and 4 of paper 003, tightness and cost of every method"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let runs = context.runs_or(RUNS.0, RUNS.1);
        let mut workspace = nonlin_bounds::Workspace::new();
        let images = figure_1::images()?;
        let mut sets = figure_1::published()?;
        sets.extend(figure_1::rigorous()?);
        let figure_1 = measure(sets, &images, &mut workspace.sets)?;
        let mut sets = figure_4::published(&mut workspace.sets)?;
        sets.extend(figure_4::rigorous(&mut workspace)?);
        let figure_4 = measure(sets, &figure_4::arc(), &mut workspace.sets)?;

        let mut results = Results::new(self.name(), context.seed, runs);
        results.rows.extend(figure_1.iter().flat_map(|set| set.rows("Figure 1", "")));
        results.rows.extend(figure_4.iter().flat_map(|set| set.rows("Figure 4", "")));
        results.rows.extend(lemma_2::rows(&mut workspace.sets)?);
        results.rows.extend(tightness::rows(context, runs)?);
        let timings = tightness::timings(context)?;
        let figures = vec![figures::figure_1(&figure_1, &images, &mut workspace.sets)?, figures::figure_4(&figure_4)];
        let report = report::report(&results, &timings, &figure_1, &figure_4);
        Ok(Output { results, timings, report, figures, curves: Vec::new() })
    }
}

fn measure(
    shapes: Vec<plane::Shape>,
    points: &[Vec<scalars::Interval>],
    workspace: &mut Workspace,
) -> Result<Vec<Measured>, ScenarioError> {
    shapes.into_iter().map(|shape| Measured::of(shape, points, workspace)).collect()
}
