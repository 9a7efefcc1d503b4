//! The figures: radii over the steps, and over the number of tanks.

use super::cases::Outcome;
use super::contenders::{METHODS, look};
use super::scaling::{Point, STEPS};
use crate::figure::{Figure, Look, Panel, Series};
use crate::set_study::RADIUS;
use crate::set_study::figures::curves;

/// Mean radius over the steps, a panel a case.
#[must_use]
pub fn radii(outcomes: &[Outcome]) -> Figure {
    let figure = Figure::new("radii", "Radius of the hull of all tank levels after each measurement", 2);
    outcomes.iter().fold(figure, |figure, outcome| {
        let panel = curves(&outcome.case.label(), &outcome.cells, (0, RADIUS), look);
        let steps = outcome.case.listed.iter().enumerate();
        let ideal = steps.filter_map(|(index, &k)| Some((k as f64, outcome.mean_ideal(index)?)));
        figure.with(panel.with(Series::points("ideal", Look::REFERENCE, ideal)))
    })
}

/// Radius after some steps over the number of tanks.
#[must_use]
pub fn sizes(points: &[Point]) -> Figure {
    let panel = Panel::new(format!("after {STEPS} steps"), "number of tanks", "radius").log_x();
    let panel = METHODS.iter().fold(panel, |panel, (method, _)| {
        let of_method = points.iter().filter(|point| point.method == *method);
        panel.with(Series::line(*method, look(method), of_method.map(|point| (point.n as f64, point.radius))))
    });
    Figure::new("sizes", "Longer chains", 1).with(panel)
}
