//! Rows, figure and text of the filters with unknown wheel scale and lever arm.

use super::fit::ADDED_LEVER_M;
use super::study::{Case, FIXES_M, SAFETY, SPREADS, Study};
use crate::figure::{Figure, Look, Panel, Series};
use crate::report::significant;
use crate::wheel_lever::filters::Method;
use crate::wheel_lever::study::{Sample, Track};
use crate::wifibot::odometry::Rule;
use crate::{Report, Results, Row, Table};

/// A scale within this of the least-squares one is right.
pub const CLOSE: f64 = 0.02;
/// Name of the table of least-squares fits.
pub const FITS: &str = "scale and lever arm by least squares";

/// Name of the table of a log.
#[must_use]
pub fn table(number: u32) -> String {
    format!("log {number}, unknown wheels and antenna")
}

fn label(case: &Case) -> String {
    format!("fixes {} m, {}", case.fix_m, case.rule.name())
}

/// The rows of a log.
#[must_use]
pub fn rows(study: &Study) -> Vec<Row> {
    let mut rows = Vec::new();
    for case in study.cases.iter().filter(|case| case.fix_m == FIXES_M[0]) {
        let values =
            [("scale", "", case.fit.scale), ("lever 1", "m", case.fit.lever[0]), ("lever 2", "m", case.fit.lever[1])];
        let rests =
            [("rest(turn)", "rad"), ("rest(along)", "m"), ("rest(across)", "m")].into_iter().zip(case.fit.residuals);
        let values = values.into_iter().chain(rests.map(|((name, unit), value)| (name, unit, value)));
        rows.extend(values.map(|(metric, unit, value)| {
            Row::new(FITS, format!("log {}, {}", study.number, case.rule.name()), "least-squares")
                .metric(metric, unit)
                .value(value)
        }));
    }
    for case in &study.cases {
        for method in Method::ALL {
            rows.extend(of_method(case, method, &table(study.number)));
        }
        let bound = Row::new(table(study.number), label(case), "cramer-rao bound");
        rows.push(bound.metric("sd(scale)", "").value(case.bound));
    }
    rows
}

fn of_method(case: &Case, method: Method, table: &str) -> Vec<Row> {
    let row = |metric: &str, unit: &str| Row::new(table, label(case), method.name()).metric(metric, unit);
    let percent = |is: &dyn Fn(&Track) -> bool| {
        100.0 * case.tracks(method).filter(|track| is(track)).count() as f64 / case.runs.len() as f64
    };
    let last = |value: fn(&Sample) -> f64| -> Vec<f64> {
        case.tracks(method).filter_map(|track| track.samples.last().map(value)).collect()
    };
    let right = |track: &Track| track.samples.last().is_some_and(|last| (last.scale - case.fit.scale).abs() <= CLOSE);
    vec![
        row("convergence", "%").value(percent(&|track| track.convergent)),
        row("heading within 10 deg at the end", "%").value(percent(&Track::close)),
        row("scale within 0.02 at the end", "%").value(percent(&right)),
        row("scale", "").mean_of(&last(|sample| sample.scale)),
        row("sd(scale)", "").mean_of(&last(|sample| sample.scale_sd)),
        row("error(X)", "m").mean_of(&last(|sample| sample.errors[2])),
        row("error(x)", "m").mean_of(&last(|sample| sample.errors[1])),
        row("scale negative at the end", "runs")
            .value(case.tracks(method).filter(|track| track.reversed()).count() as f64),
    ]
}

/// Label and value of a curve.
type Curve = (&'static str, fn(&Sample) -> f64);

/// Median errors over the draws, for the log as it is read.
#[must_use]
pub fn figure(study: &Study) -> Figure {
    let name = format!("log-{}-wheels", study.number);
    let title = format!("Robot log {}: unknown heading, wheels and antenna; medians over the draws", study.number);
    let errors: [Curve; 3] = [
        ("heading error [rad]", |sample| sample.heading_rad.abs()),
        ("scale error", |sample| sample.errors[0]),
        ("lever arm error [m]", |sample| sample.errors[2]),
    ];
    errors.into_iter().fold(Figure::new(name, title, 3), |figure, (label, value)| {
        let mut panel = Panel::new(label.split(" [").next().unwrap_or_default(), "t [s]", label).log_y();
        for case in study.cases.iter().filter(|case| case.rule == Rule::Ends) {
            for method in Method::ALL {
                let look = Look::nth(method as usize).dashed(usize::from(case.fix_m == FIXES_M[0]));
                let series = format!("{}, fixes {} m", method.name(), case.fix_m);
                panel = panel.with(Series::line(series, look, medians(case, method, value)));
            }
        }
        figure.with(panel)
    })
}

fn medians(case: &Case, method: Method, value: fn(&Sample) -> f64) -> Vec<(f64, f64)> {
    let seconds = case.tracks(method).map(|track| track.samples.len()).min().unwrap_or(0);
    let median = |k: usize| {
        let mut values: Vec<f64> = case.tracks(method).map(|track| value(&track.samples[k])).collect();
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    (0..seconds).map(|k| ((k + 1) as f64, median(k))).collect()
}

/// Adds the section to the report of the logs.
pub fn describe(report: &mut Report, studies: &[Study], results: &Results) {
    let [heading, scale, position, lever] = SPREADS;
    let runs = studies.first().and_then(|study| study.cases.first()).map_or(0, |case| case.runs.len());
    report
        .heading("Unknown wheels and antenna (paper 002)")
        .paragraph(format!(
            "The three Kalman filters of paper 002 on the same logs: first heading anywhere, wheel scale and place of the antenna unknown. The \
             fixes are those of an antenna at {} m ahead and {} m to the left of the reference point, put there with the reference heading, plus \
             Gaussian noise; {runs} draws of noise and first heading, the same for all filters and readings. First spreads: heading {heading} rad, \
             scale {scale}, position {position} m, lever arm {lever} m. Process noises: {SAFETY} times the root mean square of what the \
             increments of a second miss of the reference.",
            ADDED_LEVER_M[0], ADDED_LEVER_M[1]
        ))
        .list(findings(studies, results))
        .paragraph(
            "Two readings of the logs. If a speed belongs to the interval that ends with its sample, the wheels are off by half a per cent; if to the \
             one that begins, by five: the intervals are uneven, and the speeds of these logs are ways divided by the interval before. Speed times \
             interval is smooth in the first reading only, so that one is used everywhere else; a filter finds the scale of the reading it is given.",
        )
        .table(Table::pivot(results.table(FITS)));
    for study in studies {
        report
            .paragraph(format!(
                "Log {}. Convergence: heading within three standard deviations from second 20 on. The Cramer-Rao bound is that of fixes alone, \
                 with exact increments and nothing known before; the first spread of the scale is knowledge, so a filter may say a little less.",
                study.number
            ))
            .table(Table::pivot(results.table(&table(study.number))))
            .figure(
                format!("log-{}-wheels", study.number),
                format!("Log {}: median errors over the draws, speeds of the interval that ends", study.number),
            );
    }
}

fn findings(studies: &[Study], results: &Results) -> Vec<String> {
    let mut findings = Vec::new();
    for study in studies {
        for case in study.cases.iter().filter(|case| case.rule == Rule::Ends) {
            let (table, label) = (table(study.number), label(case));
            let number = |method: Method, metric: &str| {
                let mut rows =
                    results.table(&table).filter(|r| r.row_name() == label && r.method_name() == method.name());
                let value = rows.find(|r| r.metric_name() == metric).and_then(Row::get_value);
                value.map_or("-".to_owned(), |x| significant(x, 3))
            };
            let three = |metric: &str| Method::ALL.map(|method| number(method, metric)).join(", ");
            findings.push(format!(
                "Log {}, fixes {} m, in the order tfg-iekf, iekf-imperfect, ekf: convergent {} %; heading right at the end {} %; scale within {CLOSE} of the \
                 least-squares {} in {} % (best possible standard deviation {}).",
                study.number,
                case.fix_m,
                three("convergence"),
                three("heading within 10 deg at the end"),
                significant(case.fit.scale, 3),
                three("scale within 0.02 at the end"),
                significant(case.bound, 2)
            ));
        }
    }
    findings
}
