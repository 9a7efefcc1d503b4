//! The text of the experiment's report.

use super::autonomy::{AUTONOMY, ESTIMATES};
use super::filters::Method;
use super::study::Cell;
use super::tables::{ERRORS, PAPER_RUNS, TABLE_1, VARIANTS, label};
use crate::report::significant;
use crate::{Report, Results, Row, Table};

/// Puts text, tables and figure together.
#[must_use]
pub fn report(main: &[Cell], variants: &[Cell], results: &Results, timings: &[Row]) -> Report {
    let mut report =
        Report::new("wheel-lever: a robot with unknown wheel radius and antenna (paper 002, section VI-B)");
    report
        .paragraph(
            "Gyro, wheels and satellite receiver; neither the first heading, nor the wheel radius, nor the place of the antenna is known. \
             Three extended Kalman filters of one model differ in what they call the error: plain differences (`ekf`), SE(2) with plain \
             differences beside it (`iekf-imperfect`), and the two-frame group (`tfg-iekf`), where the error is a function of itself.",
        )
        .heading("What holds")
        .list(verdicts(main, variants, results))
        .heading("Settings")
        .list(settings())
        .heading("Table I")
        .paragraph(
            "Convergence as in the paper: the heading error, wrapped, stays within three standard deviations at every step from 20 s on. \
             So a late excursion counts as much as a divergence; the share of runs that end with the right heading stands beside it. The \
             normalised estimation error squared (NEES) over its dimension is 1 for a filter that knows how good it is.",
        )
        .paragraph(Table::LEGEND)
        .table(Table::pivot(results.table(TABLE_1)))
        .heading("Figure 2")
        .figure(
            "figure-2",
            "Top: root mean square errors, first heading off by 100 degrees (one standard deviation). Bottom: heading errors of single runs \
             with their bounds, 200 degrees; blue where they stay within from 20 s on, red where not",
        )
        .heading("Errors")
        .paragraph(
            "On the circle scale, position and lever arm are hardly observable together: errors stall until the robot goes straight. The \
             paper's \"behave likewise asymptotically\" of the imperfect filter holds for the median, not for the root mean square, which the \
             runs that end the wrong way round decide.",
        )
        .table(Table::pivot(results.table(ERRORS)))
        .heading("Other settings")
        .paragraph("What the paper leaves open, in other readings, always with headings drawn with 200 degrees.")
        .table(Table::pivot(results.table(VARIANTS)))
        .heading("Propositions 1 to 4")
        .paragraph(format!(
            "The same error on {ESTIMATES} random estimates: largest difference of the errors after the same step, of the innovations, and of the \
             errors after an update by the same gain. Rounding, where the error is a function of itself."
        ))
        .table(Table::pivot(results.table(AUTONOMY)))
        .heading("Misprints of the paper")
        .list([
            "(28): what stands in the second brace is `E^s E^R E^X = -(E^-1)^X`, not `E^X`; the same to first order.",
            "(30): the updated error is `E^X - ((E^g)^-1 L_g) * L_X'`; the paper has a plus sign and the inverse of `L_g`.",
            "Section VI-A, second bullet: the position moves by `s R e_x`, as (29) says; `R e_x` lacks the scale.",
            "The error is a function of itself only without gyro noise: that noise moves `E^X` by `(J Xhat / shat) n_theta`, and is put there.",
        ])
        .heading("Time")
        .paragraph("Ten predictions and an update, one thread.")
        .table(Table::pivot(timings));
    report
}

fn settings() -> Vec<String> {
    vec![
        "Circle at pi/25 rad/s for 50 s, then straight for 10 s, 5 m/s; increments at 10 Hz, fixes at 1 Hz from 1 s on. Noises: 0.05 rad/s, \
         0.1 m/s along and across, 1 m. The truth moves with the noises, the filters suppose them as they are."
            .to_owned(),
        "The paper does not say the true lever arm, the first spreads of scale, position and lever arm, whether noises are rates or \
         densities, and how long the parts of the drive are. `BEST`: X = (0.5, 0) m, spreads 0.5, 10 m, 20 m, noises as rates (sd times the \
         period). `ALT`: X = (5, 0) m, spreads 0.2, 3 m, 20 m."
            .to_owned(),
        "Estimates start at the true position with scale 1 and lever arm 0; only the heading is drawn. All filters see the same noises."
            .to_owned(),
    ]
}

/// The value of a row.
fn value(results: &Results, table: &str, row: &str, method: &str, metric: &str) -> Option<f64> {
    let mut rows = results.table(table).filter(|r| r.row_name() == row && r.method_name() == method);
    rows.find(|r| r.metric_name() == metric).and_then(Row::get_value)
}

fn verdicts(main: &[Cell], variants: &[Cell], results: &Results) -> Vec<String> {
    let number = |table: &str, row: &str, method: Method, metric: &str| {
        value(results, table, row, method.name(), metric).map_or("-".to_owned(), |x| significant(x, 3))
    };
    let mut verdicts = Vec::new();
    for cell in main.iter().filter(|cell| cell.heading_deg == 200.0) {
        let mut counts = vec![cell.runs.len().min(PAPER_RUNS), cell.runs.len()];
        counts.dedup();
        for runs in counts {
            let row = label(cell, runs);
            let [tfg, imperfect, ekf] = Method::ALL.map(|method| number(TABLE_1, &row, method, "convergence"));
            verdicts.push(format!(
                "{row}: convergent {tfg} % (`tfg-iekf`), {imperfect} % (`iekf-imperfect`), {ekf} % (`ekf`); paper, 50 runs: 98, 34, 14 %."
            ));
        }
    }
    if let Some(cell) = main.iter().find(|cell| cell.heading_deg == 200.0) {
        let row = label(cell, cell.runs.len());
        let [tfg, imperfect, ekf] = Method::ALL.map(|method| {
            value(results, TABLE_1, &row, method.name(), "scale negative at the end").unwrap_or(f64::NAN)
        });
        verdicts.push(format!(
            "Runs that end with a negative scale, trying to make up for a heading that is half a turn off ({row}): {tfg} (`tfg-iekf`), {imperfect} \
             (`iekf-imperfect`), {ekf} (`ekf`). The two-frame filter cannot, by construction: its least scale of all steps was {}.",
            number(TABLE_1, &row, Method::Tfg, "least scale")
        ));
    }
    let all = main.iter().filter(|cell| cell.heading_deg == 200.0).map(|cell| (TABLE_1, cell));
    let settings: Vec<[f64; 3]> = all
        .chain(variants.iter().map(|cell| (VARIANTS, cell)))
        .map(|(table, cell)| {
            let row = label(cell, cell.runs.len());
            Method::ALL.map(|m| value(results, table, &row, m.name(), "convergence").unwrap_or(f64::NAN))
        })
        .collect();
    let least = settings.iter().map(|[_, _, ekf]| *ekf).fold(f64::INFINITY, f64::min);
    let ahead = settings.iter().map(|[tfg, imperfect, ekf]| tfg - imperfect.max(*ekf)).fold(f64::INFINITY, f64::min);
    verdicts.push(format!(
        "The paper's 14 % for the EKF was not reached. Tried here: `BEST`, `ALT` and the table of other settings (least: {} %); and, by an \
         independent program, some 360 settings of 64 runs each (lever arm, spreads, rates or densities, yaw wrapped or not): 12 to 20 % come out \
         only where the two-frame filter falls to 80 %, and 30 % with the yaw of the EKF left unwrapped. How many runs the other two lose \
         depends on the setting (with a first spread of the lever arm of 1 m they keep most), and so does which of them is the better one; \
         the two-frame filter is ahead of both by at least {} percentage points in every setting.",
        significant(least, 3),
        significant(ahead, 2)
    ));
    let spread = |method: &str, fold: fn(f64, f64) -> f64, start: f64| {
        let rows = results.table(AUTONOMY).filter(|row| row.method_name() == method);
        significant(rows.filter_map(Row::get_value).fold(start, fold), 2)
    };
    verdicts.push(format!(
        "Propositions 1 to 4: largest spread of the two-frame error {}; least spread of the imperfect one {}, of the plain one {}.",
        spread("tfg-iekf", f64::max, 0.0),
        spread("iekf-imperfect", f64::min, f64::INFINITY),
        spread("ekf", f64::min, f64::INFINITY)
    ));
    verdicts
}
