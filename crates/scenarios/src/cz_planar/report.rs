//! The text of the experiment.

use super::Study;
use super::plant::START_RADIUS;
use super::tables::{AVERAGED, CONVERGED, RADII, RATIOS};
use crate::noise::NoiseKind;
use crate::report::significant;
use crate::set_study::ratios::average_ratios;
use crate::set_study::rows::CONTAINMENT;
use crate::set_study::{Cell, tables};
use crate::{Report, Results, Row, Table};

/// The report.
#[must_use]
pub fn report(results: &Results, timings: &[Row], studies: &[Study], truth_width: f64, steps: usize) -> Report {
    let mut report = Report::new("cz-planar: nonlinear measurements (paper 003, Example 5.1)");
    report
        .paragraph(
            "A planar system with two nonlinear measurements and no invariant. ZMV and ZFO are the zonotope filters that the paper compares with, \
             CZMV and CZFO its own (8 generators, 3 constraints), Rcz ours (2 generators and 3 ranged constraints after a reduction). All of them \
             are rigorous here: remainders and rounding are enclosed.",
        )
        .heading("What holds")
        .list(verdicts(studies))
        .heading("Settings")
        .list([
            format!("{} runs of {steps} steps a kind of noise; sets are those after the update, `k = 0` is `X_0` after the first one.", results.runs),
            "The paper does not say where the true state starts; `(5.2, 0.65)` is that of its authors' later demonstration.".to_owned(),
            format!(
                "The truth is one exact trajectory: every state is a pair of floats (widest enclosure {truth_width:.0e}), every step is proven to need a \
                 noise inside its bounds. Noises `at their bounds` are within 1e-12 of them."
            ),
            format!(
                "`convergence`: runs whose radius at `k = {AVERAGED}` is at most {} (a third of that of `X_0`).",
                significant(CONVERGED * START_RADIUS, 3)
            ),
        ])
        .heading("Figure 2")
        .figure("figure-2", "Figure 2: sets of the first steps of one run with uniform noises")
        .heading("Figure 3: radii")
        .paragraph(Table::LEGEND)
        .table(Table::pivot(results.table(RADII)))
        .figure("figure-3", "Figure 3: radii over the steps, mean over the runs; a curve ends where the first of its runs has no finite set")
        .heading("Average radius ratios")
        .paragraph("Radius of the column's filter over that of the row's, averaged over steps and runs (uniform noises).")
        .table(tables::matrix(results.table(RATIOS)))
        .heading("Table 2: time of a step")
        .paragraph("Milliseconds on one thread; [the paper's, in MATLAB on another machine].")
        .table(tables::times(timings))
        .heading("Containment")
        .paragraph(
            "Shares of the steps at which the truth is not proven to have left the set, and at which it is proven inside; runs that ended with a \
             proven contradiction, which would be false, and runs that ended without a finite set.",
        )
        .table(Table::pivot(results.table(CONTAINMENT)));
    report
}

fn verdicts(studies: &[Study]) -> Vec<String> {
    let Some(uniform) = studies.iter().find(|study| study.kind == NoiseKind::Uniform) else { return Vec::new() };
    let find = |method: &str| uniform.cells.iter().find(|cell| cell.method == method);
    let mut verdicts = Vec::new();
    for (method, paper) in [("zmv", "2.000, 4.020, 10.69, 58.3"), ("zfo", "2.000, 3.015, 5.515, 13.95")] {
        if let Some(cell) = find(method) {
            let radii: Vec<String> = cell.curve(0).iter().take(4).map(|&radius| significant(radius, 4)).collect();
            verdicts.push(format!(
                "{}: radii {} at `k = 0..3` whatever the noise (independent computation: {paper}); {} of {} runs end without a finite set, as in the \
                 paper.",
                method.to_uppercase(),
                radii.join(", "),
                cell.diverged(),
                cell.runs.len()
            ));
        }
    }
    let average = |cell: &Cell| {
        let averages = cell.averages(0, 0, AVERAGED);
        significant(averages.iter().sum::<f64>() / averages.len() as f64, 4)
    };
    for method in ["czmv", "czfo", "rcz"] {
        if let Some(cell) = find(method) {
            verdicts.push(format!(
                "{}: radius {} on average over `k <= {AVERAGED}`.",
                method.to_uppercase(),
                average(cell)
            ));
        }
    }
    if let (Some(rcz), Some(czfo)) = (find("rcz"), find("czfo")) {
        let ratios = average_ratios(rcz, czfo);
        verdicts.push(format!(
            "Rcz is at {} of the radius of CZFO, averaged over steps and runs; the largest of {} runs is {}.",
            significant(ratios.iter().sum::<f64>() / ratios.len() as f64, 3),
            ratios.len(),
            significant(ratios.iter().copied().fold(0.0, f64::max), 3)
        ));
    }
    verdicts.push(tables::containment_verdict(studies.iter().map(|study| (study.kind.name(), &*study.cells))));
    verdicts
}
