//! Figures 5 and 6 of paper 003.

use super::studies::Studies;
use crate::figure::{Figure, Panel};
use crate::set_study::RADIUS;
use crate::set_study::figures::{curves, look};

/// Radii of the filters that go by the mean value theorem, and ours.
#[must_use]
pub fn figure_5(studies: &Studies) -> Figure {
    figure("figure-5", "Radii, mean value extensions (paper 003: Figure 5)", studies, |method| method.contains("mv"))
}

/// Radii of the filters that go by Taylor's theorem, and ours.
#[must_use]
pub fn figure_6(studies: &Studies) -> Figure {
    figure("figure-6", "Radii, first-order extensions (paper 003: Figure 6)", studies, |method| method.contains("fo"))
}

fn figure(name: &str, title: &str, studies: &Studies, shown: fn(&str) -> bool) -> Figure {
    studies.tables.iter().fold(Figure::new(name, title, 2), |figure, bound| {
        let cells = bound.table().into_iter().filter(|cell| shown(&cell.method) || cell.method == "rcz");
        let panel: Panel = curves(&bound.label(), cells, (0, RADIUS), look);
        figure.with(panel)
    })
}
