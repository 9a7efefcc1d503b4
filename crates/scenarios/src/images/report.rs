//! The text of the experiment.

use super::plane::Measured;
use crate::report::significant;
use crate::{Report, Results, Table};

/// The report.
#[must_use]
pub fn report(results: &Results, figure_1: &[Measured], figure_4: &[Measured]) -> Report {
    let mut report = Report::new("images: enclosures of images and solution sets");
    report
        .heading("Figure 1 of paper 003")
        .paragraph(
            "The image of a triangle whose centre lies outside of it under (15). The paper shows the first set and the second one: \
             Proposition 2 about the centre, and the older Theorem 3 about the point of the triangle next to it, whose remainder is not an \
             enclosure as printed (see below); `sound` is the same with the symmetric cross term.",
        )
        .table(areas(figure_1))
        .figure("figure-1", "Figure 1: the set, its image, and enclosures of it")
        .heading("Figure 4 of paper 003")
        .paragraph(
            "A parallelogram and its intersection with the box `[-1, 1]^2`, both refined by `|x|^2 = 1`: `czmv+c` is Corollary 1 (in the figure \
             of the paper), `czfo+c` Corollary 2 (not in it).",
        )
        .table(areas(figure_4))
        .figure("figure-4", "Figure 4: a parallelogram refined by an invariant")
        .heading("Lemma 2 of paper 003")
        .paragraph(
            "The cross term of the quadratic part is `(c - gamma)' (Q + Q') G xi`; with the upper triangular `Q` of the print, `L = (c - \
             gamma)' Q` gives `2 (c - gamma)' Q G xi`. For `x_1 x_2 = 1` in `[-1, 1]^2` about `(0, -1)` the solution `(1, 1)` is then proven to be lost.",
        )
        .table(Table::pivot(results.table("Lemma 2")));
    report
}

/// Areas beside those of an independent computation, and containment.
fn areas(sets: &[Measured]) -> Table {
    let header = [
        "row",
        "method",
        "mode",
        "area",
        "independent computation",
        "generators",
        "constraints",
        "contained",
        "proven",
    ];
    sets.iter().fold(Table::new(header), |table, set| {
        let share = |pick: fn((f64, f64)) -> f64| {
            set.containment.shares().map_or_else(|| "-".to_owned(), |shares| significant(pick(shares), 4))
        };
        let shape = &set.shape;
        table.row([
            shape.row.to_owned(),
            shape.method.to_owned(),
            shape.mode.map_or("", crate::Mode::name).to_owned(),
            significant(set.area, 6),
            shape.reference.map_or_else(|| "-".to_owned(), |area| significant(area, 6)),
            shape.set.columns().to_string(),
            shape.set.constraints().to_string(),
            share(|shares| shares.0),
            share(|shares| shares.1),
        ])
    })
}
