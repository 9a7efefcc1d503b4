//! Experiment `cz-attitude`: Example 5.2 of paper 003, an attitude with nonlinear measurements and the invariant `|x| = 1`.
//!
//! Reading order: [`plant`], [`textbook`] (the dynamics as printed), [`simulation`], [`contenders`], [`studies`], [`paper`] (its tables),
//! [`tables`], [`figures`], [`verdicts`], [`report`].

pub mod contenders;
pub mod figures;
pub mod paper;
pub mod plant;
pub mod report;
pub mod simulation;
pub mod studies;
pub mod tables;
pub mod textbook;
pub mod verdicts;

use crate::set_study::timing;
use crate::{Context, Experiment, Output, Results, Row, ScenarioError};
use contenders::{PRINTED_NOISE, all, rigorous};
use studies::{Scale, Studies};

/// Steps of a timed run.
const TIMED_STEPS: usize = 40;

/// Example 5.2 of paper 003: Tables 3 and 4, Figures 5 and 6.
#[derive(Clone, Copy, Debug)]
pub struct AttitudeExperiment;

impl Experiment for AttitudeExperiment {
    fn name(&self) -> &'static str {
        "cz-attitude"
    }

    fn describe(&self) -> &'static str {
        "paper 003, Example 5.2: attitude with an invariant, all filters (Tables 3 and 4, Figures 5 and 6)"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let scale = Scale::of(context);
        let studies = Studies::run(context, &scale)?;
        let timings = timings(context, &scale)?;
        let mut results = Results::new(self.name(), context.seed, scale.runs);
        results.rows = tables::rows(&studies);
        let truth_width = studies::trajectory_of(context, PRINTED_NOISE, &scale, 0)?.widest();
        let report = report::report(&results, &timings, &scale, &studies, truth_width);
        let figures = vec![figures::figure_5(&studies), figures::figure_6(&studies)];
        Ok(Output { results, timings, report, figures, curves: Vec::new() })
    }
}

/// Times of a step at the printed bound, one filter after the other on one thread.
fn timings(context: &Context<'_>, scale: &Scale) -> Result<Vec<Row>, ScenarioError> {
    let some = Scale { steps: scale.steps.min(TIMED_STEPS), ..*scale };
    let trajectory = studies::trajectory_of(context, PRINTED_NOISE, &some, 0)?;
    let mut rows = Vec::new();
    for contender in rigorous(PRINTED_NOISE, &all())? {
        let times = timing::phase_times(&trajectory, &contender)?;
        let paper = paper::index_of(&contender.method).map(|index| paper::TABLE_4[index]);
        rows.extend(timing::rows("Table 4", "|v|<=0.15", &contender, &times, paper));
    }
    Ok(rows)
}
