//! One figure a log: course, errors with their bounds, size of the set, containment.

use setrep::Membership;

use crate::figure::{Figure, Look, Panel, Series};
use crate::wifibot::filters::Method;
use crate::wifibot::odometry::{Course, WINDOW_S};
use crate::wifibot::study::{HEADING_ERRORS_DEG, Step, Study};

/// The first heading that is drawn: far off.
const DRAWN: usize = 3;

/// The figure of a log.
#[must_use]
pub fn figure(course: &Course, study: &Study) -> Figure {
    let title = format!("Robot log {}, first heading off by {} degrees", course.number, HEADING_ERRORS_DEG[DRAWN]);
    Figure::new(format!("log-{}", course.number), title, 2)
        .with(map(course, study))
        .with(heading_error(study))
        .with(rms(study, "position error", "RMS over the draws [m]", |step| {
            step.position_error[0].hypot(step.position_error[1])
        }))
        .with(rms(study, "heading error", "RMS over the draws [rad]", |step| step.heading_error_rad))
        .with(rms(study, "size of the set", "side of the position box [m]", |step| {
            (step.widths[1] * step.widths[2]).sqrt()
        }))
        .with(containment(study))
}

/// What the figure of a log shows, in a line.
#[must_use]
pub fn caption(course: &Course) -> String {
    format!(
        "Log {}: course and heading error of the first draw of noise (dashed: bounds of the set), root mean squares over the draws of \
         the errors and of the side of the position box, share of draws and first headings that have not lost the reference.",
        course.number
    )
}

fn look(method: Method) -> Look {
    Look::nth(method as usize).solid()
}

fn time_s(k: usize) -> f64 {
    (k + 1) as f64 * WINDOW_S
}

fn first_run(study: &Study, method: Method) -> &[Step] {
    study.tracks(DRAWN, method).next().map_or(&[], Vec::as_slice)
}

fn map(course: &Course, study: &Study) -> Panel {
    let xy = |position: [f64; 2]| (position[0], position[1]);
    let poses = std::iter::once(&course.start).chain(course.windows.iter().map(|window| &window.end));
    let panel = Panel::new("course", "x1 [m]", "x2 [m]")
        .equal_aspect()
        .with(Series::points("fix", Look::nth(5), study.first_fixes.iter().map(|fix| xy(*fix))))
        .with(Series::line("reference", Look::REFERENCE, poses.map(|pose| xy(pose.position))));
    Method::ALL.into_iter().fold(panel, |panel, method| {
        let points = first_run(study, method).iter().map(|step| xy(step.center.position));
        panel.with(Series::line(method.name(), look(method), points))
    })
}

fn heading_error(study: &Study) -> Panel {
    let panel = Panel::new("heading error and bounds", "t [s]", "heading error [rad]").y_range(-3.2, 3.2);
    Method::ALL.into_iter().fold(panel, |panel, method| {
        let curve = |value: fn(&Step) -> f64| {
            first_run(study, method).iter().enumerate().map(move |(k, step)| (time_s(k), value(step)))
        };
        panel
            .with(Series::line(method.name(), look(method), curve(|step| step.heading_error_rad)))
            .with(Series::line("", look(method).dashed(1), curve(|step| 0.5 * step.widths[0])))
            .with(Series::line("", look(method).dashed(1), curve(|step| -0.5 * step.widths[0])))
    })
}

/// Root mean square over the draws, on a logarithmic axis.
fn rms(study: &Study, title: &str, label: &str, value: fn(&Step) -> f64) -> Panel {
    let panel = Panel::new(title, "t [s]", label).log_y();
    Method::ALL.into_iter().fold(panel, |panel, method| {
        let steps = first_run(study, method).len();
        let at = |k: usize| {
            let squares: f64 = study.tracks(DRAWN, method).map(|track| value(&track[k]).powi(2)).sum();
            (time_s(k), (squares / study.len() as f64).sqrt())
        };
        panel.with(Series::line(method.name(), look(method), (0..steps).map(at)))
    })
}

fn containment(study: &Study) -> Panel {
    let panel = Panel::new("reference not lost, all first headings", "t [s]", "share of draws").y_range(0.0, 1.05);
    Method::ALL.into_iter().fold(panel, |panel, method| {
        let tracks = || (0..HEADING_ERRORS_DEG.len()).flat_map(|heading| study.tracks(heading, method));
        let (steps, of) = (first_run(study, method).len(), tracks().count() as f64);
        let share = |k: usize| {
            let kept = tracks().filter(|track| track[k].membership != Membership::ProvenOutside).count();
            (time_s(k), kept as f64 / of)
        };
        panel.with(Series::line(method.name(), look(method), (0..steps).map(share)))
    })
}
