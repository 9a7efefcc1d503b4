//! Rows of the robot logs.

use crate::guaranteed_invariant::lever_run::{LeverRun, LeverStep};
use crate::guaranteed_invariant::planar::STRIPS;
use crate::guaranteed_invariant::robot_study::{RobotCell, RobotLog};
use crate::guaranteed_invariant::tables::containment_of;
use crate::results::Status;
use crate::{Mode, Row};

/// Table of the logs: scales and bounds.
pub const LOGS: &str = "robot, logs";
/// Table of the widths.
pub const WIDTHS: &str = "robot, widths";

/// Seconds at which the widths are looked at; the last second of a log is added.
const LOOKED_AT_S: [usize; 3] = [10, 30, 60];

/// Windows of the spans whose bounds are shown.
const SHOWN_SPANS: [usize; 3] = [5, 10, 40];

/// All rows.
#[must_use]
pub fn rows(logs: &[RobotLog]) -> Vec<Row> {
    logs.iter()
        .flat_map(|log| {
            log_rows(log)
                .into_iter()
                .chain(span_rows(log))
                .chain(log.cells.iter().flat_map(|cell| cell_rows(log, cell)))
        })
        .collect()
}

/// The name of a log read by a rule.
#[must_use]
pub fn log_label(log: &RobotLog) -> String {
    format!("log {};{};{} s windows", log.log.number, log.rule.name(), log.log.window_s)
}

fn log_rows(log: &RobotLog) -> Vec<Row> {
    let row = |metric: &str, unit: &str| Row::new(LOGS, log_label(log), "odometry").metric(metric, unit);
    let bounds = log.log.stated_bounds(0.0);
    vec![
        row("least-squares scale", "").value(log.log.scale),
        row("gain of the gyro", "").value(log.log.gyro_gain),
        row("bound(theta)", "rad").value(bounds.turn_rad),
        row("bound(U1)", "m").value(bounds.shift_m[0]),
        row("bound(U2)", "m").value(bounds.shift_m[1]),
        row("windows", "").value(log.log.increments.len() as f64),
        row("marker arm 1", "m").value(log.log.marker_m[0]),
        row("marker arm 2", "m").value(log.log.marker_m[1]),
    ]
}

/// The bounds of some spans.
fn span_rows(log: &RobotLog) -> Vec<Row> {
    let spans = log.cells.iter().find(|cell| !cell.spans.is_empty()).map_or(&[][..], |cell| &cell.spans);
    let shown = spans.iter().filter(|span| SHOWN_SPANS.contains(&span.windows));
    shown
        .flat_map(|span| {
            let over = format!("over {} s", span.windows as f64 * log.log.window_s);
            let row = |of: &str, unit: &str, bound: f64| {
                Row::new(LOGS, log_label(log), "odometry").metric(format!("bound({of}) {over}"), unit).value(bound)
            };
            let [along, across] = span.chord_m;
            [row("theta", "rad", span.turn_rad), row("chord along", "m", along), row("chord across", "m", across)]
        })
        .collect()
}

fn cell_rows(log: &RobotLog, cell: &RobotCell) -> Vec<Row> {
    let label = format!("{};{};fixes within {} m", log_label(log), cell.source.name(), cell.bounds.fix_m);
    let row = |metric: String, unit: &str| Row::new(WIDTHS, &*label, STRIPS).mode(Mode::Rigorous).metric(metric, unit);
    let end = log.log.increments.len();
    let mut rows = Vec::new();
    let mut width = |name: &str, unit: &str, window: usize, of: fn(&LeverStep) -> f64| {
        let samples: Vec<f64> = cell.runs.iter().filter_map(|run| run.at(window)).map(of).collect();
        let at = if window == end { "end".to_owned() } else { format!("{}s", window as f64 * log.log.window_s) };
        rows.push(row(format!("width({name})@{at}"), unit).mean_of(&samples));
    };
    let per_window = log.log.window_s as usize;
    for window in LOOKED_AT_S.into_iter().map(|second| second / per_window).chain([end]) {
        width("theta", "rad", window, |step| step.heading_rad);
        width("s", "", window, |step| step.scale.width());
    }
    width("X1", "m", end, |step| step.arm_m[0].width());
    width("X2", "m", end, |step| step.arm_m[1].width());
    width("x area", "m^2", end, |step| step.area);
    rows.extend(scale_rows(cell, log.log.scale, end, &row));
    rows.extend(verdict_rows(log.log.window_s, cell, &row));
    rows
}

/// The scale at the end: its ends, whether it holds the least-squares one, and the width that the bound on the speed implies.
fn scale_rows(cell: &RobotCell, scale: f64, end: usize, row: &dyn Fn(String, &str) -> Row) -> Vec<Row> {
    let last: Vec<&LeverStep> = cell.runs.iter().filter_map(|run| run.at(end)).collect();
    let samples = |of: fn(&LeverStep) -> f64| last.iter().map(|step| of(step)).collect::<Vec<f64>>();
    let holds = last.iter().filter(|step| step.scale.contains(scale)).count();
    let limit = row("width(s) of the bound on the speed".to_owned(), "");
    vec![
        row("s/low@end".to_owned(), "").mean_of(&samples(|step| step.scale.lo())),
        row("s/high@end".to_owned(), "").mean_of(&samples(|step| step.scale.hi())),
        row("least-squares scale held@end".to_owned(), "runs").value(holds as f64),
        cell.admissible.map_or(limit.clone().status(Status::Undefined), |[lo, hi]| limit.value(hi - lo)),
    ]
}

/// With bounds that hold: containment. With others: when the filter proves that they do not, and whether the reference was lost before.
fn verdict_rows(window_s: f64, cell: &RobotCell, row: &dyn Fn(String, &str) -> Row) -> Vec<Row> {
    let mut rows: Vec<Row> = containment_of(&cell.runs)
        .into_iter()
        .map(|(metric, unit, value)| row(metric.to_owned(), unit).value(value))
        .collect();
    if !cell.source.holds() {
        let seconds = |of: fn(&LeverRun) -> Option<usize>| -> Vec<f64> {
            cell.runs.iter().filter_map(of).map(|window| window as f64 * window_s).collect()
        };
        rows.push(row("contradiction-step".to_owned(), "s").mean_of(&seconds(|run| run.contradiction)));
        let lost = seconds(LeverRun::lost);
        rows.push(row("reference lost at".to_owned(), "s").mean_of(&lost));
        rows.push(row("reference lost".to_owned(), "runs").value(lost.len() as f64));
    }
    rows
}
