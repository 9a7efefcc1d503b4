//! The text of the report.

use super::{PAPER_RUNS, Study, TABLE_II};
use crate::polytopes::cost::{Cost, cost_list};
use crate::polytopes::tables::{FACES, is_nowhere_larger, pivot, standard_errors};
use crate::report::significant;
use crate::set_study::tables::{containment_verdict, times};
use crate::{Report, Results, Row, Table};

/// Largest mean volume at `k = 3, 4` over the paper's V-H that a default filter should have.
const SHARE: f64 = 0.55;

/// Tables, verdicts, figures.
#[must_use]
pub fn report(results: &Results, timings: &[Row], studies: &[Study], costs: &[Cost]) -> Report {
    let mut report = Report::new("Example I of paper 004: polytopic sets in the plane");
    report.paragraph(format!(
        "{} runs, `k = 0 .. 4`, `|w| <= 0.1`, `|v| <= 0.4`, `x_0 = (0.8, 0.65)`. Volumes are those of the sets after the update. The printed `X_0` has an area of \
         0.12, so Table II's 0.3496 at `k = 0` is impossible with it; generators three times as large fit. The Jacobian as a computer algebra system prints it, in \
         natural interval arithmetic, fits the paper's volumes; the same derivatives with each variable nearly once (`tight-jacobian`) halve them.",
        results.runs
    ));
    report.heading("Table II").table(pivot(&results.rows, "Table II")).paragraph(Table::LEGEND);
    report.heading("What reproduces").list(verdicts(studies));
    report.heading("Figure 2").figure("figure-2", "The sets of the first run after each update, those images of points of X0 under the model without noise that are near, and the state.");
    report.heading(FACES).table(pivot(&results.rows, FACES));
    report
        .heading("Containment")
        .paragraph(containment_verdict(studies.iter().map(|study| (study.kind.name(), &*study.cells))));
    report.heading("Time of a step in milliseconds").table(times(timings)).paragraph(
        "In brackets the paper's seconds (averages over `k = 1 .. 4`, another machine, MATLAB). Prediction and update include what a filter needs to bound its sets.",
    );
    report.heading("A step of V-H in interval hulls").list(cost_list(costs));
    report.heading("Why our D-CZ, D-ZB and RRSR differ").list([
        "RRSR here is CZMV with heuristic C2 and no limit on the complexity; the paper's was reduced by Girard's method at every step, which tells from `k = 3` on.",
        "D-CZ and D-ZB take the rows of narrowest residual among more choices, keep the linear part of an output in its row where a derivative has one sign, and are \
         cut by the tight range; the paper's are reduced to three generators before each prediction.",
        "D-ZB goes back from the cut set to a bundle by the facets of the set, one parallelotope each; how the paper splits a polytope into zonotopes is not stated.",
    ]);
    report
}

/// What the numbers say about the paper's.
fn verdicts(studies: &[Study]) -> Vec<String> {
    let mut lines = Vec::new();
    let Some(study) = studies.iter().find(|study| study.reproduces()) else { return lines };
    for (method, printed) in TABLE_II {
        if let Some(cell) = study.cell(method) {
            let errors: Vec<String> =
                standard_errors(cell, printed, PAPER_RUNS).iter().map(|e| format!("{e:+.1}")).collect();
            lines.push(format!(
                "{method}: means are off the paper's by {} standard errors of the difference (`k = 0 .. 4`).",
                errors.join(", ")
            ));
        }
    }
    for study in studies {
        let name = |method: &str| study.cells.iter().find(|cell| cell.method.split('/').next() == Some(method));
        for (smaller, larger) in [("vh", "rrsr"), ("comb", "vh")] {
            if let (Some(small), Some(large)) = (name(smaller), name(larger)) {
                let holds =
                    if is_nowhere_larger(small, large) { "holds in every mean" } else { "does NOT hold in every mean" };
                lines.push(format!("{}, {}: {smaller} <= {larger} {holds}.", study.label(), small.method));
            }
        }
    }
    if let Some(study) = studies.iter().find(|study| study.cell("rcz").is_some() && study.scale != 1.0) {
        let paper = TABLE_II.iter().find(|(name, _)| *name == "vh").map_or([f64::NAN; 5], |(_, volumes)| *volumes);
        for method in ["vh/tight", "rcz"] {
            if let Some(cell) = study.cell(method) {
                let shares: Vec<String> =
                    [3, 4].map(|k| significant(cell.curve(0).get(k).copied().unwrap_or(f64::NAN) / paper[k], 3)).into();
                lines.push(format!(
                    "{method}: mean volumes at `k = 3, 4` are {} of the paper's V-H (aim: at most {SHARE}).",
                    shares.join(" and ")
                ));
            }
        }
    }
    lines
}
