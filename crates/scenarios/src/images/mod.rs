//! Experiment `images`: what encloses the image of a set under a function, or the solutions in it, how tightly and at what cost.
//!
//! Reading order: [`models`], [`enclosure`], [`outline`] and [`plane`] (what is enclosed and measured), [`figure_1`], [`figure_4`] and
//! [`lemma_2`] (paper 003), [`figures`], [`report`].

pub mod enclosure;
pub mod figure_1;
pub mod figure_4;
pub mod figures;
pub mod lemma_2;
pub mod models;
pub mod outline;
pub mod plane;
pub mod report;

use setrep::Workspace;

use crate::{Context, Experiment, Output, Results, ScenarioError};
use plane::Measured;

/// Figures 1 and 4 of paper 003, the counterexample to its Lemma 2 as printed.
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
        let mut workspace = Workspace::new();
        let images = figure_1::images()?;
        let figure_1 = measure(figure_1::published()?, &images, &mut workspace)?;
        let figure_4 = measure(figure_4::published(&mut workspace)?, &figure_4::arc(), &mut workspace)?;

        let mut results = Results::new(self.name(), context.seed, 1);
        results.rows.extend(figure_1.iter().flat_map(|set| set.rows("Figure 1", "")));
        results.rows.extend(figure_4.iter().flat_map(|set| set.rows("Figure 4", "")));
        results.rows.extend(lemma_2::rows(&mut workspace)?);
        let figures = vec![figures::figure_1(&figure_1, &images, &mut workspace)?, figures::figure_4(&figure_4)];
        let report = report::report(&results, &figure_1, &figure_4);
        Ok(Output { results, timings: Vec::new(), report, figures, curves: Vec::new() })
    }
}

fn measure(
    shapes: Vec<plane::Shape>,
    points: &[Vec<scalars::Interval>],
    workspace: &mut Workspace,
) -> Result<Vec<Measured>, ScenarioError> {
    shapes.into_iter().map(|shape| Measured::of(shape, points, workspace)).collect()
}
