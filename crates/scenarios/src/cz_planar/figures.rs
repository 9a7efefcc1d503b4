//! Figures 2 and 3 of paper 003.

use super::Study;
use super::snapshots::{STEPS, Snapshots};
use crate::figure::{Figure, Look, Panel, Series};
use crate::set_study::RADIUS;
use crate::set_study::figures::{curves, look};

/// The sets of the first steps: on the left all of them, on the right those of constrained zonotopes.
#[must_use]
pub fn figure_2(snapshots: &Snapshots) -> Figure {
    let panel = |title: String, k: usize, shown: &dyn Fn(&str) -> bool| {
        let drawn = snapshots.sets.iter().filter(|(method, _)| shown(method));
        let panel = drawn.filter_map(|(method, sets)| Some((method, sets.get(k)?))).fold(
            Panel::new(title, "x1", "x2"),
            |panel, (method, set)| {
                panel.with(Series::outline(&**method, look(method), set.iter().map(|&[x, y]| (x, y))))
            },
        );
        panel.with(Series::points("true state", Look::REFERENCE, snapshots.truth.get(k).map(|&[x, y]| (x, y))))
    };
    let title = "Sets of the first steps (paper 003: Figure 2)";
    (0..STEPS).fold(Figure::new("figure-2", title, 2), |figure, k| {
        figure.with(panel(format!("k = {k}"), k, &|method| method != "rcz/cheap")).with(panel(
            format!("k = {k}, without zonotopes"),
            k,
            &|method| method.contains("cz"),
        ))
    })
}

/// Radii, mean over the runs: uniform noises and noises at their bounds.
#[must_use]
pub fn figure_3(studies: &[Study]) -> Figure {
    let title = "Radii of the sets, mean over the runs (paper 003: Figure 3)";
    studies.iter().fold(Figure::new("figure-3", title, 2), |figure, study| {
        figure.with(curves(study.kind.name(), &study.cells, (0, RADIUS), look))
    })
}
