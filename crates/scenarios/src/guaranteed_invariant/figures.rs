//! Figures: heading and area over time beside the paper's filters, polygons at chosen times, widths on Problem 3 and on the robot.

use crate::figure::{Figure, Look, Panel, Series};
use crate::guaranteed_invariant::courses::{Courses, POLYGON_STEPS, Reference, Track};
use crate::guaranteed_invariant::lever_run::{LeverRun, LeverStep};
use crate::guaranteed_invariant::lever_study::Runs;
use crate::guaranteed_invariant::planar::STRIPS;
use crate::guaranteed_invariant::robot_study::{FIX_BOUNDS_M, RobotCell, RobotLog, Source};
use crate::guaranteed_invariant::settings::{PERIOD_S, SETTINGS};
use crate::vehicle::PERIOD_S as STEP_S;
use crate::wifibot::odometry::Rule;

/// Steps drawn one by one at the start; after them every [`STRIDE`]-th.
const DENSE_STEPS: usize = 100;
/// Distance of the steps drawn later.
const STRIDE: usize = 10;
/// Settings of Problem 3 that are drawn, as indices in [`SETTINGS`].
const DRAWN_SETTINGS: [usize; 5] = [0, 2, 3, 5, 7];

fn drawn(len: usize) -> impl Iterator<Item = usize> {
    (0..len).filter(|k| *k < DENSE_STEPS || k % STRIDE == 0)
}

fn time_s(k: usize) -> f64 {
    k as f64 * STEP_S
}

/// The main figure: heading, area and polygons of one run with uniform noise and one with a constant vertex.
#[must_use]
pub fn main(uniform: &Courses, constant: &Courses) -> Figure {
    let title = "Unknown heading, position within 1 m: guaranteed strips beside the paper's filters, which start within 90 degrees";
    Figure::new("arc-and-hull", title, 2)
        .with(headings("heading minus truth, uniform noise", uniform))
        .with(headings("heading minus truth, noise held at a vertex", constant))
        .with(sizes("width of the heading, uniform noise", "[rad]", uniform, |widths| widths[0]))
        .with(sizes("area of the position box, uniform noise", "[m^2]", uniform, |widths| widths[1]))
        .with(polygons("positions minus truth, uniform noise", uniform))
        .with(polygons("positions minus truth, noise held at a vertex", constant))
}

/// What the main figure shows.
pub const MAIN_CAPTION: &str = "First run of each noise. Top: bounds on the heading (band: strips, which start from any heading; dashed: \
     centre ± half width of the paper's filters from theta0=0, x0=(5,5)). Middle: sizes over time; `zsmf` and `inzsmf` as published are no \
     bounds, with valid reductions (`sound`) they are still first order. Bottom: all positions that remain possible, around the true one.";

fn look(reference: &Reference) -> Look {
    let published = reference.name.ends_with("published");
    let look = Look::nth(if reference.name.starts_with("zsmf") { 1 } else { 2 });
    if published { look.solid() } else { look.dashed(1) }
}

fn headings(title: &str, courses: &Courses) -> Panel {
    let panel = Panel::new(title, "t [s]", "heading - truth [rad]").y_range(-1.2, 1.2);
    let Track { steps, .. } = &courses.strips;
    let pi = std::f64::consts::PI;
    let band = drawn(steps.len()).map(|k| {
        // An end beyond half a turn from the truth appears on the other side.
        let [lo, hi] = steps[k]
            .heading_off_rad
            .map_or([-pi, pi], |[lo, hi]| [if lo > 0.0 { -pi } else { lo }, if hi < 0.0 { pi } else { hi }]);
        (time_s(k), lo.max(-1.2), hi.min(1.2))
    });
    let panel = panel.with(Series::band(STRIPS, Look::nth(0), band));
    let published = courses.references.iter().filter(|reference| reference.name.ends_with("published"));
    let panel = published.fold(panel, |panel, reference| {
        let end = |sign: f64| {
            drawn(reference.steps.len()).map(move |k| {
                let step = &reference.steps[k];
                (time_s(k + 1), sign.mul_add(0.5 * step.widths[0], -step.heading_error_rad))
            })
        };
        panel.with(Series::line("", look(reference).dashed(1), end(1.0))).with(Series::line(
            "",
            look(reference).dashed(1),
            end(-1.0),
        ))
    });
    panel.with(Series::line("truth", Look::REFERENCE, [(0.0, 0.0), (time_s(steps.len()), 0.0)]))
}

fn sizes(title: &str, unit: &str, courses: &Courses, of: fn([f64; 2]) -> f64) -> Panel {
    let panel = Panel::new(title, "t [s]", unit).log_y();
    let strips = &courses.strips.steps;
    let points = drawn(strips.len()).map(|k| (time_s(k), of([strips[k].heading_width_rad, strips[k].area])));
    let panel = panel.with(Series::line(STRIPS, Look::nth(0), points));
    courses.references.iter().fold(panel, |panel, reference| {
        let steps = &reference.steps;
        let size = |k: usize| of([steps[k].widths[0], steps[k].widths[1] * steps[k].widths[2]]);
        let points = drawn(steps.len()).map(|k| (time_s(k + 1), size(k)));
        panel.with(Series::line(reference.name.clone(), look(reference), points))
    })
}

fn polygons(title: &str, courses: &Courses) -> Panel {
    let panel = Panel::new(title, "x1 [m]", "x2 [m]").equal_aspect();
    let polygons = courses.strips.polygons.iter().zip(POLYGON_STEPS).enumerate();
    let panel = polygons.fold(panel, |panel, (index, (polygon, k))| {
        let label = format!("t = {} s", time_s(k));
        panel.with(Series::outline(label, Look::nth(index).solid(), polygon.iter().map(|&[x, y]| (x, y))))
    });
    panel.with(Series::points("truth", Look::REFERENCE, [(0.0, 0.0)]))
}

/// Problem 3: widths over time, first run of some settings.
#[must_use]
pub fn lever(studies: &[Runs]) -> Figure {
    let title = "Unknown heading, wheel scale and antenna arm (turn rate; bounds of gyro, speed, position)";
    let courses: Vec<Drawn<'_>> = DRAWN_SETTINGS
        .iter()
        .enumerate()
        .filter_map(|(index, &setting)| {
            let run = studies[setting].first()?;
            Some((SETTINGS[setting].label.to_owned(), Look::nth(index).solid(), run, PERIOD_S))
        })
        .collect();
    widths(Figure::new("scale-and-arm", title, 2), &courses)
}

/// What the figure of Problem 3 shows.
pub const LEVER_CAPTION: &str = "Problem 3: widths of the bounds over time, first run of five settings; circle until 50 s, then straight. A fix a second.";

/// The robot: widths over time, first draw of the noise, stated bounds.
#[must_use]
pub fn robot(logs: &[RobotLog]) -> Figure {
    let title = "Robot logs: unknown heading, wheel scale and antenna arm, stated bounds, fixes within 0.05 m";
    let stated = |cell: &&RobotCell| cell.source.holds();
    let mut courses: Vec<Drawn<'_>> = Vec::new();
    for log in logs.iter().filter(|log| log.rule == Rule::Ends) {
        for cell in log.cells.iter().filter(stated).filter(|cell| cell.bounds.fix_m == FIX_BOUNDS_M[1]) {
            let spans = if cell.source == Source::Spans { " and spans" } else { "" };
            let label = format!("log {}, windows of {} s{spans}", log.log.number, log.log.window_s);
            courses.push((label, Look::nth(courses.len()).solid(), &cell.runs[0], log.log.window_s));
        }
    }
    widths(Figure::new("robot", title, 2), &courses)
}

/// What the figure of the robot shows.
pub const ROBOT_CAPTION: &str =
    "Robot logs 2 and 3: widths of the bounds over time, first draw of the position noise. A fix a window.";

/// Title, label and value.
type Width = (&'static str, &'static str, fn(&LeverStep) -> f64);

/// Label, look, run and seconds a state.
type Drawn<'a> = (String, Look, &'a LeverRun, f64);

fn widths(figure: Figure, courses: &[Drawn<'_>]) -> Figure {
    let panels: [Width; 4] = [
        ("heading", "width [rad]", |step| step.heading_rad),
        ("wheel scale", "width", |step| step.scale.width()),
        ("arm, forward", "width [m]", |step| step.arm_m[0].width()),
        ("arm, left", "width [m]", |step| step.arm_m[1].width()),
    ];
    panels.into_iter().fold(figure, |figure, (title, label, of)| {
        let panel =
            courses.iter().fold(Panel::new(title, "t [s]", label).log_y(), |panel, (name, look, run, period_s)| {
                let points = run.steps.iter().map(|step| (step.state as f64 * period_s, of(step)));
                panel.with(Series::line(name.clone(), *look, points))
            });
        figure.with(panel)
    })
}
