//! The text of the experiment's report.

use crate::inzsmf::cases::{FIGURE_2_CASES, STEPS, TABLE_I};
use crate::inzsmf::containment::{self, KINDS, Tally, Watched};
use crate::inzsmf::tables::{CONTAINMENT, ORDERS};
use crate::report::significant;
use crate::{Mode, Report, Results, Row, Table};

/// What was run.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    /// Runs of the tables and figures.
    pub runs: usize,
    /// Runs of the other orders and reductions, and without any reduction.
    pub order_runs: [usize; 2],
    /// Runs of the containment study.
    pub containment_runs: usize,
    /// Every so many steps of it are looked at.
    pub containment_stride: usize,
    /// Width of the enclosure of the true states, rad or m.
    pub truth_width: f64,
}

/// Puts verdicts, tables and figures together.
#[must_use]
pub fn report(scale: &Scale, verdicts: Vec<String>, results: &Results, timings: &[Row], tallies: &[Tally]) -> Report {
    let mut report = Report::new("inzsmf: the invariant zonotopic set-membership filter (paper 000)");
    report
        .paragraph(
            "A vehicle on a circle of 20 m measures its position within 1 m, 100 times a second. Two zonotopic filters estimate \
             heading and position: ZSMF with the error `x - xhat` in the world, InZSMF with the left-invariant error `log(Xhat^-1 X)` \
             on SE(2). The paper compares them from eight initial estimates.",
        )
        .heading("What holds")
        .list(verdicts)
        .heading("Settings")
        .list(settings(scale))
        .heading("Table I: F-radius gain")
        .paragraph(Table::LEGEND)
        .table(Table::pivot(results.table("Table I")))
        .heading("Table II: placed poles and F-radius gain")
        .paragraph(
            "The paper's `RMSE(x)` of the F-radius rows contradicts its Table I, where the same runs have 0.2371 and 0.2068 m and all \
             other columns agree; ours is that of Table I.",
        )
        .table(Table::pivot(results.table("Table II")))
        .heading("Time of a step")
        .paragraph("One thread, metrics included; the paper's times are Python's on another machine.")
        .table(Table::pivot(timings.iter().filter(|row| row.metric_name() == "ART")));
    for mode in [Mode::Published, Mode::Sound] {
        report
            .heading(format!("Figures 2 and 3, {} mode", mode.name()))
            .figure(
                format!("figure-2-{}", mode.name()),
                format!(
                    "Figure 2, {} mode: left {}, right {}; bounds are the half widths of the heading interval",
                    mode.name(),
                    TABLE_I[FIGURE_2_CASES[0]].label,
                    TABLE_I[FIGURE_2_CASES[1]].label
                ),
            )
            .figure(format!("figure-3-{}", mode.name()), format!("Figure 3, {} mode", mode.name()));
    }
    report
        .heading("Sound mode with other orders and reductions")
        .paragraph(
            "Valid reductions of different methods and orders. With few generators the reduction, not the noise, makes most of the set.",
        )
        .table(Table::pivot(results.table(ORDERS)))
        .heading("Containment")
        .paragraph(format!(
            "Both filters start with `H_0 = diag(1.05 |e_0| + 0.05)` in their own coordinates, so the initial error is inside. {} runs of {} \
             steps; {} is looked at. Cells: runs in which truth and set are proven disjoint at some step, share of such \
             steps, largest gauge (1 is the boundary). Rows of `{CONTAINMENT}` in `results.json` have all numbers.",
            scale.containment_runs,
            containment::STEPS,
            every(scale.containment_stride),
        ))
        .table(containment_table(tallies));
    report
}

/// Which steps, in words.
fn every(stride: usize) -> String {
    if stride == 1 { "every step".to_owned() } else { format!("every {stride}th step") }
}

fn settings(scale: &Scale) -> Vec<String> {
    vec![
        format!(
            "{} runs of {STEPS} steps (one turn; the paper does not say), metrics over `k = 1..N` of the one-step predictor; run `i` has \
             the same noises in every row.",
            scale.runs
        ),
        format!(
            "Noises uniform in their boxes. The truth is `X exp(delta u) exp(delta w)` (18), one exact trajectory known to {:.0e} (widest \
             enclosure of a state): every step is proven to need a noise inside its bounds, and every output to be within 1 m.",
            scale.truth_width
        ),
        "`published`: what the paper's numbers imply, found by search: `H_0 = I` in all rows, one turn, box of the order reduction \
         summed with signs (not a bound), position box of InZSMF in the body frame, centre of InZSMF corrected with the gain of the \
         previous step. `inzsmf/current-gain` and `inzsmf/world-box` undo the last and the last but one."
            .to_owned(),
        "`sound`: the equations of the paper with a valid reduction (Combastel, 30 generators), `Phi = Ad_exp(-delta u)` instead of \
         `I - delta ad_u`, and the world-frame box of both sets, that of InZSMF with the exponential replaced by its linear part. \
         Still first order, so not a bound either."
            .to_owned(),
        format!(
            "Other orders and reductions: {} runs; no reduction (up to {} generators): {} runs.",
            scale.order_runs[0],
            5 * STEPS + 3,
            scale.order_runs[1]
        ),
    ]
}

/// Noise and filter down, initial estimates across.
fn containment_table(tallies: &[Tally]) -> Table {
    let header = ["noise", "method", "mode"].into_iter().chain(TABLE_I.iter().map(|row| row.label));
    let mut table = Table::new(header);
    for kind in KINDS {
        for watched in Watched::ALL {
            let (method, mode) = watched.name();
            let cells = tallies.iter().filter(|tally| tally.kind == kind && tally.watched == watched).map(|tally| {
                let steps: usize = tally.runs.iter().map(|run| run.steps).sum();
                let violated: usize = tally.runs.iter().map(|run| run.violated).sum();
                let share = 100.0 * violated as f64 / steps.max(1) as f64;
                let gauge = significant(tally.largest_gauge(), 3);
                format!("{} of {}; {share:.1} %; {gauge}", tally.runs_violated(), tally.runs.len())
            });
            let head = [kind.name(), method, mode.name()].map(str::to_owned);
            table = table.row(head.into_iter().chain(cells));
        }
    }
    table
}
