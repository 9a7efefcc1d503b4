//! Figures 2 and 3 of the paper.

use crate::Mode;
use crate::figure::{Figure, Look, Panel, Series};
use crate::inzsmf::cases::{FIGURE_2_CASES, TABLE_I, TABLE_II_CASE};
use crate::inzsmf::courses::{Course, Courses};
use crate::vehicle::{PERIOD_S, TruePose};

/// Steps drawn one by one at the start; after them every [`STRIDE`]-th.
const DENSE_STEPS: usize = 150;
/// Distance of the steps drawn later.
const STRIDE: usize = 5;

/// Draws courses of several methods into one panel with a title.
type DrawPanel = fn(&str, &Courses, &[&Course]) -> Panel;

/// Figure 2 (a) to (h): trajectories, heading error with its bounds, RMS errors; left column good, right column bad initial estimate.
#[must_use]
pub fn figure_2(courses: &Courses, mode: Mode) -> Figure {
    let title = format!("ZSMF and InZSMF with the F-radius gain, {} mode (paper: Figure 2)", mode.name());
    let methods = ["zsmf", "inzsmf"];
    let mut figure = Figure::new(format!("figure-2-{}", mode.name()), title, 2);
    let panels: [DrawPanel; 4] = [trajectories, heading_errors, rms_headings, rms_positions];
    for (row, panel) in panels.iter().enumerate() {
        for (column, &case) in FIGURE_2_CASES.iter().enumerate() {
            let letter = char::from(b'a' + (2 * row + column) as u8);
            let title = format!("({letter}) {}", TABLE_I[case].label);
            figure = figure.with(panel(&title, courses, &of(courses, case, &methods, mode)));
        }
    }
    figure
}

/// Figure 3 (a) to (d): trajectories and heading errors with placed poles (top) and with the F-radius gain (bottom).
#[must_use]
pub fn figure_3(courses: &Courses, mode: Mode) -> Figure {
    let title = format!(
        "Placed poles and F-radius gain, {}, {} mode (paper: Figure 3)",
        TABLE_I[TABLE_II_CASE].label,
        mode.name()
    );
    let poles = of(courses, TABLE_II_CASE, &["zsmf/pole", "inzsmf/pole"], mode);
    let f_radius = of(courses, TABLE_II_CASE, &["zsmf", "inzsmf"], mode);
    Figure::new(format!("figure-3-{}", mode.name()), title, 2)
        .with(trajectories("(a) placed poles", courses, &poles))
        .with(heading_errors("(b) placed poles", courses, &poles))
        .with(trajectories("(c) F-radius gain", courses, &f_radius))
        .with(heading_errors("(d) F-radius gain", courses, &f_radius))
}

fn of<'a>(courses: &'a Courses, case: usize, methods: &[&str], mode: Mode) -> Vec<&'a Course> {
    methods.iter().filter_map(|method| courses.find(case, method, mode)).collect()
}

/// The look of a method: the same for both gains, which never share a panel.
fn look(method: &str) -> Look {
    Look::nth(usize::from(method.starts_with("inzsmf")))
}

/// Label without the gain, so that both gains share the legend.
fn label(method: &str) -> &str {
    method.split_once('/').map_or(method, |(name, _)| name)
}

/// Indices of the steps drawn, of steps `1..=N` at `0..N`.
fn drawn(len: usize) -> impl Iterator<Item = usize> {
    (0..len).filter(|k| *k < DENSE_STEPS || k % STRIDE == 0)
}

fn time_s(k: usize) -> f64 {
    (k + 1) as f64 * PERIOD_S
}

fn trajectories(title: &str, courses: &Courses, of: &[&Course]) -> Panel {
    let panel = Panel::new(format!("{title}: trajectory"), "x1 [m]", "x2 [m]").equal_aspect();
    let panel = of.iter().fold(panel, |panel, course| {
        let positions = drawn(course.first_run.len()).map(|k| course.first_run[k].center.position);
        let line =
            Series::line(label(&course.method), look(&course.method).solid(), positions.map(|[x1, x2]| (x1, x2)));
        panel.with(line)
    });
    let xy = |state: &TruePose| (state.position[0].value(), state.position[1].value());
    let truth = drawn(courses.truth.states.len()).map(|k| xy(&courses.truth.states[k]));
    panel.with(Series::line("truth", Look::REFERENCE.dashed(1), truth))
}

/// The error of the centre, and the bounds that the set puts on the error: the half width of its heading interval, both signs.
fn heading_errors(title: &str, _: &Courses, of: &[&Course]) -> Panel {
    let panel = Panel::new(format!("{title}: heading error"), "t [s]", "theta [rad]");
    of.iter().fold(panel, |panel, course| {
        let bound = |sign: f64| {
            drawn(course.first_run.len()).map(move |k| (time_s(k), sign * 0.5 * course.first_run[k].widths[0]))
        };
        let (name, look) = (label(&course.method), look(&course.method));
        panel
            .with(Series::line(name, look.solid(), without_jumps(course)))
            .with(Series::line(format!("{name} bounds"), look.dashed(1), bound(1.0)))
            .with(Series::line(format!("{name} bounds"), look.dashed(1), bound(-1.0)))
    })
}

/// The heading error over time, with gaps where it passes half a turn.
fn without_jumps(course: &Course) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = Vec::new();
    for k in drawn(course.first_run.len()) {
        let error = course.first_run[k].heading_error_rad;
        if points.last().is_some_and(|last| (error - last.1).abs() > std::f64::consts::PI) {
            points.push((time_s(k), f64::NAN));
        }
        points.push((time_s(k), error));
    }
    points
}

fn rms_headings(title: &str, _: &Courses, of: &[&Course]) -> Panel {
    let panel = Panel::new(format!("{title}: RMSE(theta) over the runs"), "t [s]", "RMSE(theta) [rad]").log_y();
    of.iter().fold(panel, |panel, course| panel.with(rms(course, &course.rms_heading)))
}

fn rms_positions(title: &str, _: &Courses, of: &[&Course]) -> Panel {
    let panel = Panel::new(format!("{title}: RMSE(x) over the runs"), "t [s]", "RMSE(x) [m]").log_y();
    of.iter().fold(panel, |panel, course| panel.with(rms(course, &course.rms_position)))
}

fn rms(course: &Course, values: &[f64]) -> Series {
    let points = drawn(values.len()).map(|k| (time_s(k), values[k]));
    Series::line(label(&course.method), look(&course.method).solid(), points)
}
