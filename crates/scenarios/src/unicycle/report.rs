//! The text of the report.

use super::{Setting, Study};
use crate::polytopes::cost::{Cost, cost_list};
use crate::polytopes::tables::{FACES, is_nowhere_larger, pivot};
use crate::report::significant;
use crate::set_study::tables::{containment_verdict, times};
use crate::{Report, Results, Row, Table};

/// Tables, verdicts, figures.
#[must_use]
pub fn report(results: &Results, timings: &[Row], studies: &[Study], costed: &[(Setting, Vec<Cost>)]) -> Report {
    let mut report = Report::new("Example II of paper 004: polytopic sets of a robot");
    report.paragraph(format!(
        "{} runs, `k = 0 .. 4`. Sampling time, landmarks and `X_0` are missing in the paper; here they are those of the authors' code: `T_0 = 1`, landmarks (5, 15) and \
         (15, 15), `X_0 = x_0 +- (10, 10, 20 %)` with a volume of 3.2e-4. Table III is rounded to one digit, so it can be met in magnitude only: the process noise `W` \
         must be in the estimator, and an `X_0` five times wider fits `k = 0`.",
        results.runs
    ));
    report.heading("Table III").table(pivot(&results.rows, "Table III")).paragraph(Table::LEGEND);
    report.heading("What the numbers say").list(verdicts(studies));
    report
        .heading("Figure 3")
        .figure(
            "figure-3-position",
            "Positions: the sets of the first run after each update, images of points of X0, and the state.",
        )
        .figure("figure-3-heading", "Position and heading.");
    report.heading(FACES).table(pivot(&results.rows, FACES));
    report
        .heading("Containment")
        .paragraph(containment_verdict(studies.iter().map(|study| (study.setting.kind.name(), &*study.cells))));
    report.heading("Time of a step in milliseconds").table(times(timings)).paragraph(
        "In brackets the paper's (averages over `k = 1 .. 4`, another machine, MATLAB): a minute a step for V-H.",
    );
    for (setting, costs) in costed {
        report.heading(format!("A step of V-H in interval hulls, {}", setting.label())).list(cost_list(costs));
    }
    report
}

/// Orders and sizes.
fn verdicts(studies: &[Study]) -> Vec<String> {
    let mut lines = Vec::new();
    for study in studies {
        let Some(vh) = study.cell("vh") else { continue };
        for other in ["rrsr", "d-zb", "d-cz", "vh/tight", "rcz", "comb"] {
            let Some(cell) = study.cell(other) else { continue };
            let ratio = |k: usize| {
                cell.curve(0).get(k).copied().unwrap_or(f64::NAN) / vh.curve(0).get(k).copied().unwrap_or(f64::NAN)
            };
            let ratios: Vec<String> = (0..=4).map(|k| significant(ratio(k), 3)).collect();
            let order = if is_nowhere_larger(vh, cell) {
                ", V-H is nowhere larger"
            } else if is_nowhere_larger(cell, vh) {
                ", nowhere larger than V-H"
            } else {
                ""
            };
            lines.push(format!(
                "{}: mean volumes of {other} over those of V-H: {}{order}.",
                study.setting.label(),
                ratios.join(", ")
            ));
        }
    }
    lines
}
