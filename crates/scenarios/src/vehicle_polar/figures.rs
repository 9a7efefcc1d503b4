//! Figure 2 of the paper: one run, estimation errors with their bounds.

use crate::contest::{Course, Named, Truth};
use crate::figure::{Figure, Look, Panel, Series};

/// Every so many steps are drawn.
const STRIDE: usize = 4;
/// Sampling period.
const PERIOD_S: f64 = 0.5;

/// Errors of `x1` and `x4`, each with the bounds of all filters (top), and with the statistical ones alone (bottom).
#[must_use]
pub fn figure_2(truth: &Truth<4, 2>, courses: &[Named<4>]) -> Figure {
    let panel = |title: &str, i: usize, unit: &str, courses: &[Named<4>]| {
        let label = format!("error of x{} [{unit}]", i + 1);
        courses.iter().enumerate().fold(Panel::new(title, "t [s]", label), |panel, (index, (method, course))| {
            let look = Look::nth(index);
            let error = drawn(truth, course, |x, (center, _)| x[i] - center[i]);
            let panel = panel.with(Series::line(*method, look.solid(), error));
            [-1.0, 1.0].into_iter().fold(panel, |panel, sign| {
                let bound = drawn(truth, course, |_, (_, half)| sign * half[i]);
                panel.with(Series::line(format!("{method}: bounds"), look.dashed(2), bound))
            })
        })
    };
    let statistical = &courses[..courses.len().min(1)];
    let title = "Errors with confidence intervals and hulls, one run (paper: Figure 2)";
    Figure::new("figure-2", title, 2)
        .with(panel("(a) x1", 0, "m", courses).y_range(-60.0, 60.0))
        .with(panel("(b) x4", 3, "m/s", courses).y_range(-12.0, 12.0))
        .with(panel("(c) x1, without the set", 0, "m", statistical))
        .with(panel("(d) x4, without the set", 3, "m/s", statistical).y_range(-1.5, 1.5))
}

/// The points of a course that are drawn.
fn drawn(
    truth: &Truth<4, 2>,
    course: &Course<4>,
    value: impl Fn(&[f64; 4], &([f64; 4], [f64; 4])) -> f64,
) -> Vec<(f64, f64)> {
    let steps = truth.states.iter().zip(course).enumerate().filter(|(k, _)| k % STRIDE == 0);
    steps.map(|(k, (x, step))| ((k + 1) as f64 * PERIOD_S, value(x, step))).collect()
}
