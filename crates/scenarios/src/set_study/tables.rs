//! Tables of reports: matrices of ratios, times, and what containment comes to.

use super::Cell;
use crate::report::significant;
use crate::{Row, Table};

/// Rows as a matrix, their `row` down and their method across, in order of first appearance; the paper's number in brackets, round where the
/// settings are the paper's.
pub fn matrix<'a>(rows: impl Iterator<Item = &'a Row>) -> Table {
    let rows: Vec<&Row> = rows.collect();
    let (mut down, mut across): (Vec<&str>, Vec<&str>) = (Vec::new(), Vec::new());
    for row in &rows {
        if !down.contains(&row.row_name()) {
            down.push(row.row_name());
        }
        if !across.contains(&row.method_name()) {
            across.push(row.method_name());
        }
    }
    let cell = |down: &str, across: &str| {
        let found = rows.iter().find(|row| row.row_name() == down && row.method_name() == across);
        found.map_or_else(String::new, |row| Table::cell(row))
    };
    down.iter().fold(Table::new(std::iter::once("").chain(across.iter().copied())), |table, down| {
        let cells = across.iter().map(|across| cell(down, across));
        table.row(std::iter::once((*down).to_owned()).chain(cells))
    })
}

/// Rows of [`timing`](super::timing) as a table in milliseconds.
#[must_use]
pub fn times(rows: &[Row]) -> Table {
    let metrics = ["ART", "ART(prediction)", "ART(update)", "ART(consistency)", "ART(reduction)"];
    let mut methods: Vec<&str> = Vec::new();
    for row in rows {
        if !methods.contains(&row.method_name()) {
            methods.push(row.method_name());
        }
    }
    let cell = |method: &str, metric: &str| {
        let found = rows.iter().find(|row| row.method_name() == method && row.metric_name() == metric);
        let Some((row, seconds)) = found.and_then(|row| Some((row, row.get_value()?))) else { return String::new() };
        let paper = row.paper_number().map_or_else(String::new, |s| format!(" [{}]", significant(1e3 * s, 3)));
        significant(1e3 * seconds, 3) + &paper
    };
    let header = ["method", "total", "prediction", "update", "consistency", "reduction"];
    methods.iter().fold(Table::new(header), |table, method| {
        let cells = metrics.iter().map(|metric| cell(method, metric));
        table.row(std::iter::once((*method).to_owned()).chain(cells))
    })
}

/// One sentence on all containment studies.
#[must_use]
pub fn containment_verdict<'a>(studies: impl Iterator<Item = (&'a str, &'a [Cell])>) -> String {
    let (mut points, mut lost, mut proven, mut contradictions, mut runs) = (0, 0, 0_usize, 0, 0_usize);
    let mut names = Vec::new();
    for (name, cells) in studies {
        names.push(name);
        for cell in cells {
            contradictions += cell.contradictions();
            runs += cell.runs.len();
            for run in &cell.runs {
                points += run.containment.points;
                lost += run.containment.points - run.containment.not_outside;
                proven += run.containment.inside;
            }
        }
    }
    format!(
        "The truth is proven lost at {lost} of {points} steps of {runs} runs ({}), proven inside at {:.2} %; {contradictions} runs end with a proven \
         contradiction.",
        names.join(", "),
        100.0 * proven as f64 / points.max(1) as f64
    )
}
