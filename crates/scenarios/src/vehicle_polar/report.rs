//! The text of the experiment's report.

use super::setting::STEPS;
use super::tables::{CONTAINMENT, HALF_WIDTHS, READINGS};
use crate::report::significant;
use crate::{Report, Results, Row, Table};

/// Puts text, tables and figures together; `runs` of the table and of other settings, `diverged` the last step at which the filter
/// with a guarantee gave up, from either first set.
#[must_use]
pub fn report(runs: [usize; 2], results: &Results, timings: &[Row], diverged: [Option<usize>; 2]) -> Report {
    let mut report =
        Report::new("vehicle-polar: unscented Kalman filter against zonotopic filter (paper 001, section 5.2)");
    report
        .paragraph(
            "A vehicle of 15 m/s is seen by range and bearing twice a second; no one knows its turns. The zonotopic filter (ZF) of the paper \
             linearises the model at the center of its set and drops the rest, so its set is no bound: this page compares two \
             statistical statements.",
        )
        .heading("What holds")
        .list(verdicts(results, timings, diverged))
        .heading("Settings")
        .list(settings(runs))
        .heading("Table 2")
        .paragraph(Table::LEGEND)
        .table(Table::pivot(results.table("Table 2")))
        .figure("figure-2", "Figure 2: one run; bounds are three standard deviations, or the hull of the set")
        .heading("Why one row for both")
        .paragraph(
            "With linearisation, least segments and no reduction, `G G'` obeys the Kalman recursion with the squared radii as variances: the \
             weights (38) are the Kalman gain of one scalar output, (40) is Joseph's form. The center of ZF is an extended Kalman filter \
             with the variances of UKF times nine, which all cancel in the gain. A test holds the two together to 1e-9.",
        )
        .heading("Other readings of the settings")
        .table(Table::pivot(results.table(READINGS)))
        .heading("Half widths")
        .paragraph(
            "The hull of ZF grows over three standard deviations like the root of the number of generators (four a step): radii of segments \
             add up, standard deviations add up in squares.",
        )
        .table(Table::by_method(results.table(HALF_WIDTHS)))
        .heading("Containment and divergence")
        .paragraph(
            "Every twentieth step is looked at: share with the truth within all intervals (UKF, EKF) or not proven outside the hull (ZF, whose \
             thousands of generators make exact membership dear), and proven inside it. `zf/mean-value` is the filter with a guarantee, tightened strips in the mean value \
             form. The first set holds speed 0 and range 0, where there are no derivatives; from a small set around the truth \
             (`near-truth`) the scaling of the speed from 1.4 to 15 m/s multiplies what is unknown of it by ten, and the remainders by \
             more. No guarantee is claimed for this example.",
        )
        .table(Table::pivot(results.table(CONTAINMENT)))
        .heading("Time of a step")
        .paragraph("One thread, mean over a run in which the set of ZF grows to thousands of generators.")
        .table(Table::pivot(timings));
    report
}

fn settings(runs: [usize; 2]) -> Vec<String> {
    vec![
        format!(
            "{} runs of {STEPS} steps of 0.5 s ({} for other settings), the truth drawn anew for each; root mean squares over all steps. \
             Errors grow with the range, 7.8 km at the end, so Table 2 fixes the length of the runs to about 5 %; the paper does not say it.",
            runs[0], runs[1]
        ),
        "Bearing `atan(x2 / x1)`; the paper prints `tan`. Initial estimate (3, 3, 3, 3); the paper prints three entries for four states."
            .to_owned(),
        "The truth is one exact trajectory of the model: positions move without noise to the last bit, truncated noises are proven within \
         three standard deviations."
            .to_owned(),
        "UKF, EKF: first covariance the identity, noise variances times 1.5. ZF: first set 3 in each state, bounds as printed (three standard \
         deviations, rounded), whole strips, an order of 10,000 that no run reaches."
            .to_owned(),
    ]
}

fn verdicts(results: &Results, timings: &[Row], diverged: [Option<usize>; 2]) -> Vec<String> {
    let worst = results.table("Table 2").filter(|row| row.reproduces_paper());
    let worst = worst.filter_map(|row| Some((row.get_value()? / row.paper_number()? - 1.0).abs())).fold(0.0, f64::max);
    let number = |table: &str, method: &str, metric: &str| {
        let mut rows = results.table(table).filter(|r| r.row_name() == "gaussian" && r.method_name() == method);
        rows.find(|r| r.metric_name() == metric).and_then(Row::get_value)
    };
    let text = |value: Option<f64>| value.map_or("-".to_owned(), |x| significant(x, 3));
    let ratio = |metric: &str| Some(number(HALF_WIDTHS, "zf", metric)? / number(HALF_WIDTHS, "ukf", metric)?);
    let time = timings.iter().find(|row| row.method_name() == "zf" && row.metric_name() == "time/ukf");
    let steps = diverged.map(|step| step.map_or("-".to_owned(), |step| step.to_string()));
    vec![
        format!("The eight entries of Table 2 come out within {:.1} %.", 100.0 * worst),
        format!(
            "The hull of ZF is {} times as wide as three standard deviations of UKF at 50 s and {} times at 500 s, for x1.",
            text(ratio("half-width(x1)@100")),
            text(ratio("half-width(x1)@1000"))
        ),
        format!(
            "Both hold the truth nearly always: ZF in a share of {}, UKF of {} of the steps looked at. For neither is that a guarantee.",
            text(number(CONTAINMENT, "zf", "containment")),
            text(number(CONTAINMENT, "ukf", "containment"))
        ),
        format!(
            "With a guarantee (mean value form) the filter diverges in every run: by step {} from the paper's first set, which holds speed 0, by \
             step {} from a small one around the truth.",
            steps[0], steps[1]
        ),
        format!("A step of ZF takes {} times one of UKF on average (paper: 120).", text(time.and_then(Row::get_value))),
    ]
}
