//! Figure 2 of the paper: errors over time, headings and their bounds of single runs.

use super::filters::Method;
use super::study::{Cell, ENVELOPE, Track};
use super::tables::{NAMES, PAPER_RUNS, rmse};
use crate::figure::{Figure, Look, Panel, Series};

/// Root mean squares for the smaller spread of headings, single runs for the larger one; the cells of the first setting.
#[must_use]
pub fn figure_2(cells: &[Cell]) -> Figure {
    let mut figure = Figure::new("figure-2", "Errors over time, and headings of single runs (paper: Figure 2)", 3);
    let [small, large, ..] = cells else { return figure };
    for (name, unit, value) in [NAMES[0], NAMES[2], NAMES[3]] {
        let label = if unit.is_empty() { format!("RMSE({name})") } else { format!("RMSE({name}) [{unit}]") };
        let panel = Panel::new(format!("{name}, sigma {} deg", small.heading_deg), "t [s]", label).log_y();
        figure = figure.with(Method::ALL.into_iter().fold(panel, |panel, method| {
            let seconds = small.runs.first().map_or(0, |tracks| tracks[0].samples.len());
            let points = (1..=seconds).map(|second| (second as f64, rmse(small, method, second, value)));
            panel.with(Series::line(method.name(), Look::nth(method as usize).solid(), points))
        }));
    }
    for method in Method::ALL {
        figure = figure.with(headings(large, method));
    }
    figure
}

/// Heading errors and their bounds: blue if convergent, red if not, as in the paper.
fn headings(cell: &Cell, method: Method) -> Panel {
    let title = format!("{}, sigma {} deg", method.name(), cell.heading_deg);
    let mut panel = Panel::new(title, "t [s]", "yaw error [deg]").y_range(-200.0, 200.0);
    for track in cell.tracks(method, PAPER_RUNS) {
        let look = Look::nth(usize::from(!track.convergent)).solid();
        panel = panel.with(Series::line("", look, curve(track, |_, heading| heading)));
        for sign in [-1.0, 1.0] {
            let bound = curve(track, move |sd, _| sign * ENVELOPE * sd);
            panel = panel.with(Series::line("", look.dashed(2), bound));
        }
    }
    panel
}

/// Points of a track: of the heading's deviation and error, degrees.
fn curve(track: &Track, value: impl Fn(f64, f64) -> f64) -> impl Iterator<Item = (f64, f64)> {
    let degrees = track.samples.iter().map(|sample| (sample.heading_sd.to_degrees(), sample.heading_rad.to_degrees()));
    degrees.enumerate().map(move |(k, (sd, heading))| ((k + 1) as f64, value(sd, heading)))
}
