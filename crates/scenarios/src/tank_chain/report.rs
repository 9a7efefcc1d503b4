//! Rows and text of the experiment.

use super::cases::Outcome;
use super::contenders::METHODS;
use super::plant::{OUTPUT_NOISE, PROCESS_NOISE, START, TRUE_START};
use super::scaling::{Point, STEPS, exponent};
use crate::noise::NoiseKind;
use crate::report::significant;
use crate::set_study::rows::{CONTAINMENT, at_steps, containment};
use crate::set_study::{Cell, RADIUS};
use crate::{Mode, Report, Results, Row, Table};

/// Radii of the yardstick in an independent computation, by number of tanks and step: means over three runs, one run of thirty tanks.
const NOTED_IDEALS: [(usize, usize, f64); 3] = [(6, 100, 0.326), (6, 200, 0.167), (30, 50, 0.692)];

/// Name of the table of the cases.
const RADII: &str = "Radii";
/// Name of the table over the number of tanks.
const SIZES: &str = "Sizes";
/// Name of the table of times.
const TIMES: &str = "Times";

/// The rows of a case: radii at the listed steps, containment.
#[must_use]
pub fn rows(outcome: &Outcome) -> Vec<Row> {
    let (case, label) = (outcome.case, outcome.case.label());
    let mut rows: Vec<Row> =
        outcome.cells.iter().flat_map(|cell| at_steps(RADII, &label, cell, (0, RADIUS), case.listed)).collect();
    for (index, k) in case.listed.iter().enumerate().filter(|_| !outcome.ideal.is_empty()) {
        let radii: Vec<f64> = outcome.ideal.iter().map(|run| run[index]).collect();
        rows.push(Row::new(RADII, &*label, "ideal").metric(format!("radius@{k}"), "").mean_of(&radii));
    }
    rows.extend(outcome.cells.iter().flat_map(|cell| containment(&label, cell)));
    rows
}

/// The rows over the number of tanks.
#[must_use]
pub fn size_rows(points: &[Point]) -> Vec<Row> {
    let row = |point: &Point| {
        let row = Row::new(SIZES, format!("n={}", point.n), &*point.method).mode(Mode::Rigorous);
        row.metric(format!("radius@{STEPS}"), "").value(point.radius)
    };
    points.iter().map(row).collect()
}

/// Times of a step, and the exponent of their growth with the number of tanks.
#[must_use]
pub fn timings(points: &[Point]) -> Vec<Row> {
    let row = |point: &Point| {
        let row = Row::new(TIMES, format!("n={}", point.n), &*point.method).mode(Mode::Rigorous);
        row.metric("ns_per_step", "ns").value(1e9 * point.step_s)
    };
    let mut rows: Vec<Row> = points.iter().map(row).collect();
    for (method, _) in METHODS {
        let of_method = points.iter().filter(|point| point.method == method);
        let times: Vec<(f64, f64)> = of_method.map(|point| (point.n as f64, point.step_s)).collect();
        let exponents = exponent(&times).into_iter();
        let row = Row::new(TIMES, "growth with n", method).mode(Mode::Rigorous);
        rows.extend(exponents.map(|exponent| row.clone().metric("exponent", "").value(exponent)));
    }
    rows
}

/// The report.
#[must_use]
pub fn report(outcomes: &[Outcome], results: &Results, timings: &[Row]) -> Report {
    let mut report = Report::new("tank-chain: a long, slow, weakly measured chain");
    report
        .paragraph(
            "Tanks drain into each other by Torricelli's law, `x_i+ = x_i + h kappa (sqrt x_{i-1} - sqrt x_i) + w_i`; the first is filled at \
             a rate that the last one controls. Every third level is measured. A filter has to remember: what is known of the levels between \
             comes from the flows of many steps.",
        )
        .heading("Settings")
        .list(settings(outcomes))
        .heading("What is found")
        .list(findings(outcomes))
        .heading("Radii")
        .paragraph(
            "Half the longest side of the hull after the measurement of step k. `ideal`: all levels that agree with every measurement so far \
             if the dynamics were those linearised at the true levels; a guaranteed filter can be at it, seldom below.",
        )
        .table(Table::pivot(results.table(RADII)))
        .figure("radii", "Radii over the steps, mean over the runs")
        .heading("Containment")
        .paragraph("The exact levels against set and hull, at every step of every run.")
        .table(Table::pivot(results.table(CONTAINMENT)))
        .heading("Number of tanks")
        .paragraph(format!("One run of {STEPS} steps each, uniform noise."))
        .table(Table::pivot(results.table(SIZES)))
        .figure("sizes", "Radius over the number of tanks")
        .heading("Times")
        .paragraph("A prediction and an update with the reductions that fall due; times differ from machine to machine.")
        .table(Table::pivot(timings));
    report
}

/// Methods with a ratio each; none without any.
fn ratios<'a>(of: impl Iterator<Item = (&'a Cell, f64)>) -> Option<String> {
    let ratios: Vec<String> = of.map(|(cell, ratio)| format!("`{}` {}", cell.method, significant(ratio, 3))).collect();
    (!ratios.is_empty()).then(|| ratios.join(", "))
}

fn settings(outcomes: &[Outcome]) -> Vec<String> {
    let mut settings = vec![format!(
        "`h = 0.5`, `kappa = 0.015 sqrt(2 * 9.81)`, `|w_i| <= {PROCESS_NOISE}`, measured levels 1, 3, 6, 9, .. with `|v_i| <= {OUTPUT_NOISE}`. \
         First set: the box {START:?} a level; true levels at the start uniform in {TRUE_START:?}."
    )];
    settings.extend(METHODS.map(|(method, what)| format!("`{method}`: {what}.")));
    settings.extend(outcomes.iter().map(|outcome| {
        let case = outcome.case;
        format!("{}: {} runs of {} steps.", case.label(), case.runs, case.steps)
    }));
    settings
}

fn findings(outcomes: &[Outcome]) -> Vec<String> {
    let runs = || outcomes.iter().flat_map(|outcome| &outcome.cells).flat_map(|cell| &cell.runs);
    let (all, lost) = runs().fold((0, 0), |(all, lost), run| {
        let counts = run.containment;
        (all + counts.points, lost + counts.points - counts.not_outside)
    });
    let mut findings = vec![format!("The levels were proven outside at {lost} of {all} steps of all filters.")];
    for outcome in outcomes {
        let label = outcome.case.label();
        for (index, &k) in outcome.case.listed.iter().enumerate() {
            let to_ideal = outcome.cells.iter().filter_map(|cell| Some((cell, outcome.ratio_to_ideal(cell, index)?)));
            if let Some(ratios) = ratios(to_ideal) {
                findings.push(format!(
                    "{label}: radius at step {k} over that of the yardstick, in the first {} runs: {ratios}.",
                    outcome.ideal.len()
                ));
            }
            let noted = NOTED_IDEALS.iter().find(|(n, step, _)| (*n, *step) == (outcome.case.n, k));
            if let (Some((.., ideal)), NoiseKind::Uniform) = (noted, outcome.case.kind)
                && let Some(ratios) = ratios(outcome.cells.iter().map(|cell| (cell, cell.curve(0)[k] / ideal)))
            {
                findings.push(format!(
                        "{label}: radius at step {k} over the yardstick of an independent computation with other noises, {ideal}: {ratios}."
                    ));
            }
        }
    }
    findings
}
