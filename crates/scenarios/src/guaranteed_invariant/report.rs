//! The text of the experiment's report.

use crate::data::wifibot::HOW_TO_GET;
use crate::guaranteed_invariant::figures::{LEVER_CAPTION, MAIN_CAPTION, ROBOT_CAPTION};
use crate::guaranteed_invariant::findings::{Evidence, findings};
use crate::guaranteed_invariant::follow::{HEADING_PRIOR_RAD, POSITION_PRIOR_M};
use crate::guaranteed_invariant::planar::{Scale, WATCH_STRIDE};
use crate::guaranteed_invariant::robot_tables::{LOGS, WIDTHS};
use crate::guaranteed_invariant::settings::{LOOKED_AT_S, SETTINGS};
use crate::guaranteed_invariant::tables::{BROKEN, CONTAINMENT, LEVER, SIZES};
use crate::inzsmf::cases::STEPS;
use crate::{Report, Results, Row, Table};

/// Puts findings, tables and figures together.
#[must_use]
pub fn report(scale: &Scale, evidence: &Evidence<'_>, results: &Results, timings: &[Row]) -> Report {
    let mut report = Report::new("guaranteed-invariant: sets that never lose the state, from an unknown heading");
    report
        .paragraph(
            "Paper 000 asks for sets that contain a state on a group; its filter drops terms of second order and loses it. The filter of strips keeps \
             the left-invariant error in the linear matrix embedding of the group, where motion and measurement are linear for every heading, and keeps \
             past measurements as half-spaces: nothing is linearised, nothing is reduced (derivation: `docs/derivations/invariant-strips.md`).",
        )
        .heading("What is found")
        .list(findings(evidence))
        .heading("Settings")
        .list(settings(scale, results.seed))
        .heading("Sizes")
        .figure("arc-and-hull", MAIN_CAPTION)
        .paragraph(format!(
            "{} In brackets the paper's numbers for uniform noise: those of ZSMF beside ZSMF, of InZSMF beside the others. They differ from ours because \
             the paper's sets are no enclosures: its order reduction sums boxes with signs, and its error dynamics are first order. The sizes \
             of `invariant-strips` are those after the measurement of the step; those of the paper's filters are predictions for the next step \
             by the same measurement, 2 mm and 2 mrad wider at most by the noise of one step.",
            Table::LEGEND
        ))
        .table(Table::pivot(results.table(SIZES)))
        .heading("Containment")
        .paragraph(
            "`containment`: share of steps at which truth and set are not proven disjoint (1 is required); `contained_proven`: share with the truth proven \
             inside. The noise held at a vertex keeps the truth within 1e-12 of the boundary of the set, where the comparison of rounded numbers cannot always decide.",
        )
        .table(Table::pivot(results.table(CONTAINMENT)))
        .heading("Broken bounds")
        .paragraph("The filter is told the paper's bounds; the noises are a multiple of them. A contradiction is reported only with proof.")
        .table(Table::pivot(results.table(BROKEN)))
        .heading("Problem 3: scale and lever arm")
        .paragraph("Rows: turn rate on the circle (rad/s), bounds of gyro (rad/s), speed (m/s) and position (m).")
        .figure("scale-and-arm", LEVER_CAPTION)
        .table(lever_table(results))
        .paragraph("`reference`: one run of an independent computation in plain floating point. Our columns are means over the runs.");
    robot(&mut report, evidence, results);
    report
        .heading("Time of a step")
        .paragraph("Prediction, update, contraction and the comparison with the truth, one thread.")
        .table(Table::pivot(timings));
    report
}

fn robot(report: &mut Report, evidence: &Evidence<'_>, results: &Results) {
    report.heading("Robot logs");
    if evidence.logs.is_empty() {
        report.paragraph(format!("Left out: the logs were not found. To get them, {HOW_TO_GET}."));
        return;
    }
    report
        .paragraph(
            "Increments of one and of five seconds from wheels and gyro, an antenna arm of (0.5, 0.3) m added to the marker's by the reference heading, a fix a window \
             with uniform noise. Unknown: heading, scale in [0.8, 1.25], arm in a box of 6 m. \"Stated bounds\" on the increments are 1.2 times the worst \
             error of the whole log, so they hold by construction and promise nothing about another log; the 50 Hz samples themselves have errors too \
             large to say anything. \"Spans\" are 2 to 40 windows at once, with bounds on their turn and chord found in the same way (all spans of a length, overlapping \
             ones included): the errors of odometry do not add up, and the filter takes that as a fact of its own. The other two sources of \
             bounds show what happens when they are not known to hold.",
        )
        .paragraph(
            "The scale of a log is the least-squares one, together with the arm of the reference's marker (2 cm: the true position is that of the point \
             that the wheels move). It depends on which interval the speed of a sample belongs to: the interval that ends with the sample (as in the \
             experiment `wifibot`), or the one that begins with it; then the gyro seems 4 to 5 % off as the wheels do, and its gain is calibrated by least squares. Each rule has its own bounds, and the scale interval has to hold the least-squares \
             scale of the rule in use.",
        )
        .figure("robot", ROBOT_CAPTION)
        .table(Table::pivot(results.table(LOGS)))
        .table(Table::pivot(results.table(WIDTHS)))
        .paragraph(
            "`width(s) of the bound on the speed`: scales for which the reference itself keeps the bounds on the displacements, so no filter with \
             these bounds can be narrower, even with perfect fixes and headings; neither is given.",
        );
}

fn settings(scale: &Scale, seed: u64) -> Vec<String> {
    vec![
        format!(
            "Paper 000: {STEPS} steps, {} runs a cell, seed {seed}; noises uniform, a random vertex at every step, one random vertex for the whole run, dwelling at \
             vertices for 33 steps on average, and {} single vertices.",
            scale.runs,
            scale.vertices.len()
        ),
        format!(
            "Start: any heading and a position box of ±{POSITION_PRIOR_M} m; or ±{HEADING_PRIOR_RAD} rad and the same box around each initial estimate. The \
             paper's filters start with `H_0 = I` for the sizes, and for the containment (every {WATCH_STRIDE}th step) with `diag(1.05 |e_0| + 0.05)` in their own \
             coordinates, which holds the truth."
        ),
        "Truth: every state is a number known to a few ulp, every step is proven to need noises inside the bounds, every output to be within them. A state counts as \
         lost if it is proven outside."
            .to_owned(),
        "Problem 3: 10 Hz, 5 m/s, a circle for 50 s and a straight line after it, fixes at 1 Hz; position ±10 m, scale in [0.8, 1.25], arm ±3 m. The truth contract \
         is the same."
            .to_owned(),
    ]
}

/// Settings down, our widths beside the reference.
fn lever_table(results: &Results) -> Table {
    let widths: Vec<String> = LOOKED_AT_S
        .iter()
        .map(|second| format!("width(theta)@{second}s"))
        .chain(["width(s)@100s", "width(X1)@100s", "width(X2)@100s"].map(str::to_owned))
        .collect();
    let head = std::iter::once("setting".to_owned()).chain(widths.iter().map(|name| format!("{name} (reference)")));
    let mut table = Table::new(head.chain(["containment".to_owned()]));
    for setting in SETTINGS {
        let reference = setting.reference;
        let reference = reference.heading_rad.into_iter().chain([reference.scale]).chain(reference.arm_m);
        let find = |metric: &str| {
            results
                .table(LEVER)
                .find(|row| row.row_name() == setting.label && row.metric_name() == metric)
                .map_or_else(String::new, Table::cell)
        };
        let cells = widths.iter().zip(reference).map(|(name, reference)| format!("{} ({reference})", find(name)));
        let cells: Vec<String> = cells.collect();
        table = table.row(std::iter::once(setting.label.to_owned()).chain(cells).chain([find("containment")]));
    }
    table
}
