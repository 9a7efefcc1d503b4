//! Rows and text of the experiment.

use crate::data::wifibot::HOW_TO_GET;
use crate::report::significant;
use crate::wifibot::figures::caption;
use crate::wifibot::filters::{FIX_BOUND_M, Method, REDUCTION};
use crate::wifibot::odometry::{Course, SAFETY};
use crate::wifibot::study::{HEADING_ERRORS_DEG, SETTLED, Study, Summary};
use crate::wifibot::wheels;
use crate::{Mode, Report, Results, Row, Table};

/// The name of a log in the rows.
#[must_use]
pub fn log_name(course: &Course) -> String {
    format!("log {}", course.number)
}

/// Name of the table of the odometry's bounds.
const BOUNDS: &str = "odometry";

/// The rows of a log: bounds of its odometry, then errors, hulls and containment of every filter and first heading.
#[must_use]
pub fn rows(course: &Course, study: &Study) -> Vec<Row> {
    let names = [("bound(theta)", "rad"), ("bound(x1)", "m"), ("bound(x2)", "m")];
    let bounds = names.iter().zip(course.bounds());
    let mut rows: Vec<Row> = bounds
        .map(|((name, unit), bound)| Row::new(BOUNDS, log_name(course), "odometry").metric(*name, *unit).value(bound))
        .collect();
    for (index, degrees) in HEADING_ERRORS_DEG.iter().enumerate() {
        for method in Method::ALL {
            let runs: Vec<Summary> = study.tracks(index, method).map(|track| Summary::of(track)).collect();
            let row =
                Row::new(log_name(course), format!("heading error {degrees} deg"), method.name()).mode(Mode::Sound);
            rows.extend(METRICS.iter().map(|(name, unit, value)| {
                row.clone().metric(*name, *unit).mean_of(&runs.iter().map(value).collect::<Vec<_>>())
            }));
        }
    }
    rows
}

/// Name, unit and value of each metric.
type Metric = (&'static str, &'static str, fn(&Summary) -> f64);

const METRICS: [Metric; 10] = [
    ("RMSE(theta)", "rad", |run| run.whole.rmse_heading),
    ("RMSE(x)", "m", |run| run.whole.rmse_position),
    ("AAR(theta)", "rad", |run| run.whole.aar_heading),
    ("AAR(x)/world-hull", "m^2", |run| run.whole.aar_position),
    ("RMSE(theta)@20..", "rad", |run| run.settled.rmse_heading),
    ("RMSE(x)@20..", "m", |run| run.settled.rmse_position),
    ("AAR(theta)@20..", "rad", |run| run.settled.aar_heading),
    ("AAR(x)/world-hull@20..", "m^2", |run| run.settled.aar_position),
    ("containment", "", |run| run.containment),
    ("contained_proven", "", |run| run.contained_proven),
];
// The names above say the step.
const _: () = assert!(SETTLED == 20);

/// The report over all logs.
#[must_use]
pub fn report(studies: &[(Course, Study)], wheels: &[wheels::Study], results: &Results, timings: &[Row]) -> Report {
    let mut report = Report::new("Real robot: set-valued and Kalman filters on wheel odometry and position fixes");
    report
        .paragraph(
            "A wheeled robot drives indoors; a motion-capture system gives its reference pose. The filters get the wheel speed and the gyro, \
             integrated over one second, and a position fix once a second. The first heading is not known: the first set holds every heading.",
        )
        .heading("What is found")
        .list(findings(studies))
        .heading("Settings")
        .list(settings(studies, results.runs))
        .heading("Results")
        .paragraph("Cells: mean ± standard deviation over the draws of noise. `@20..` counts from second 20 on.");
    for (course, _) in studies {
        report
            .heading(format!("Log {}", course.number))
            .figure(format!("log-{}", course.number), caption(course))
            .table(Table::pivot(results.table(&log_name(course))));
    }
    report.heading("Bounds on the odometry").table(Table::pivot(results.table(BOUNDS)));
    wheels::report::describe(&mut report, wheels, results);
    report
        .heading("Time of a step")
        .paragraph("One prediction and one correction, one thread.")
        .table(Table::pivot(timings));
    report.heading("The data").paragraph(format!(
        "Logs 2 and 3 of the wifibot data, Copyright (c) 2019 CAOR, MinesParistech, BSD 3-Clause. To get them, {HOW_TO_GET}."
    ));
    report
}

fn settings(studies: &[(Course, Study)], runs: usize) -> Vec<String> {
    let (reduction, order) = REDUCTION;
    let mut settings = vec![
        format!("Fixes: the reference position plus noise, uniform in a box of ±{FIX_BOUND_M} m, {runs} draws; the same draws for all filters."),
        format!(
            "First estimate: the first fix, and the reference heading turned by {} degrees. First set: heading ±pi; position as the fix says, \
             and in the tangent coordinates of InZSMF every value that position and heading allow.",
            HEADING_ERRORS_DEG.map(|degrees| degrees.to_string()).join(", ")
        ),
        format!("Gain: F-radius optimal. Order reduction: {reduction:?} to {order} generators, a valid enclosure. Mode `sound`: the terms of second order are dropped."),
        "`inzsmf/transport` moves the set to the coordinates of the corrected estimate; `inzsmf` leaves it where the paper leaves it.".to_owned(),
        "Hull: of ZSMF the interval hull; of InZSMF a superset of the positions of all poses of the set, so that a wide heading shows in the position and its `AAR(x)/world-hull` is not the first-order `AAR(x)` of paper 000.".to_owned(),
        "Truth: the reference, taken as exact (motion capture is good to less than a millimetre). So `containment` is about the reference pose, and the errors \
         of the reference count as errors of the odometry."
            .to_owned(),
        "A step counts as lost if the reference, in every full turn of its heading, is proven outside the set."
            .to_owned(),
    ];
    settings.push(
        "Odometry: speed and rate of a sample hold over the interval that ends with it (in the logs, speed times interval is smooth and the \
         speed alone is not)."
            .to_owned(),
    );
    settings.extend(studies.iter().map(|(course, _)| {
        let [turn, x1, x2] = course.worst();
        let [bound_turn, bound_x1, bound_x2] = course.bounds().map(|bound| significant(bound, 3));
        format!(
            "Log {}: {} windows of one second. Worst error of an increment {} rad, {} m along, {} m across; bounds {SAFETY} times that: \
             {bound_turn} rad, {bound_x1} m, {bound_x2} m.",
            course.number,
            course.windows.len(),
            significant(turn, 3),
            significant(x1, 3),
            significant(x2, 3)
        )
    }));
    settings
}

/// What the numbers say, computed from them.
fn findings(studies: &[(Course, Study)]) -> Vec<String> {
    let mut findings = Vec::new();
    for (course, study) in studies {
        for method in Method::ALL {
            let by_heading = (0..HEADING_ERRORS_DEG.len())
                .map(|index| study.tracks(index, method).map(|track| Summary::of(track)).collect::<Vec<_>>());
            let (mut kept, mut lost, mut worst) = (Vec::new(), Vec::new(), 1.0_f64);
            for (degrees, runs) in HEADING_ERRORS_DEG.iter().zip(by_heading) {
                let least = runs.iter().map(|run| run.containment).fold(1.0, f64::min);
                worst = worst.min(least);
                if least == 1.0 { kept.push(degrees.to_string()) } else { lost.push(degrees.to_string()) }
            }
            let name = format!("Log {}, `{}`", course.number, method.name());
            findings.push(match (kept.is_empty(), lost.is_empty()) {
                (_, true) => format!("{name}: the reference stayed in the set at every step, from every first heading."),
                (true, false) => format!(
                    "{name}: the reference left the set from every first heading (in the worst run it was inside {} % of the steps).",
                    significant(100.0 * worst, 3)
                ),
                (false, false) => format!(
                    "{name}: the reference stayed in the set from first headings off by {} degrees, and left it from {} degrees (in the \
                     worst run it was inside {} % of the steps).",
                    kept.join(", "),
                    lost.join(", "),
                    significant(100.0 * worst, 3)
                ),
            });
        }
    }
    findings
}
