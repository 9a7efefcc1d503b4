//! The text of the experiment.

use super::plane::Measured;
use super::tightness::Task;
use crate::report::significant;
use crate::{Report, Results, Row, Table};

/// The report.
#[must_use]
pub fn report(results: &Results, timings: &[Row], figure_1: &[Measured], figure_4: &[Measured]) -> Report {
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
        .table(Table::pivot(results.table("Lemma 2")))
        .heading("Tightness")
        .paragraph(format!(
            "Every method on {} random functions and sets a column; sizes are half-widths of the hull in the scale of the function. Sets: \
             `zonotope` with `n + 2` generators, `cz` the same with two strips, `v` the vertices of the `cz`. Widths are means over many \
             directions, against those of the hull of a sampled image (or of sampled solutions): 1 is the best possible for a convex set. \
             Times of a call include the interval hull of the set and differ from machine to machine.",
            results.runs
        ));
    for task in Task::ALL {
        report.heading(task.table());
        for (caption, metrics) in [
            ("Width of the enclosure over the sampled width", &["width ratio"][..]),
            ("Area of the enclosure over the sampled area (in the plane)", &["area ratio"]),
            ("Generators (vertices for `v`) added", &["generators added", "vertices added"]),
        ] {
            let rows = results.table(task.table()).filter(|row| metrics.contains(&row.metric_name()));
            report.paragraph(format!("{caption}:")).table(by_method(rows));
        }
        let times = timings.iter().filter(|row| row.table_name() == task.table());
        report.paragraph("Nanoseconds a call:").table(by_method(times));
    }
    report
}

/// One line a method, one column for each family and size, means only.
fn by_method<'a>(rows: impl Iterator<Item = &'a Row>) -> Table {
    let rows: Vec<&Row> = rows.collect();
    let (mut methods, mut columns): (Vec<&str>, Vec<&str>) = (Vec::new(), Vec::new());
    for row in &rows {
        if !methods.contains(&row.method_name()) {
            methods.push(row.method_name());
        }
        if !columns.contains(&row.row_name()) {
            columns.push(row.row_name());
        }
    }
    let cell = |method: &str, column: &str| {
        let found = rows.iter().find(|row| row.method_name() == method && row.row_name() == column);
        found.and_then(|row| row.get_value()).map_or_else(|| "-".to_owned(), |value| significant(value, 4))
    };
    methods.iter().fold(Table::new(std::iter::once("method").chain(columns.iter().copied())), |table, method| {
        let cells = columns.iter().map(|column| cell(method, column));
        table.row(std::iter::once((*method).to_owned()).chain(cells))
    })
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
            shape.method.clone(),
            shape.mode.map_or("", crate::Mode::name).to_owned(),
            significant(set.area, 6),
            shape.reference.map_or_else(|| "-".to_owned(), |area| significant(area, 6)),
            shape.set.region().columns().to_string(),
            shape.set.region().constraints().to_string(),
            share(|shares| shares.0),
            share(|shares| shares.1),
        ])
    })
}
