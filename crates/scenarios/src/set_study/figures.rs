//! Curves of a study, and the looks of the filters in all figures.

use super::{Cell, Measure};
use crate::figure::{Look, Panel, Series};

/// Colour by family, dash by what is added to it.
#[must_use]
pub fn look(method: &str) -> Look {
    let (method, compared) = method.strip_suffix("/compared").map_or((method, false), |method| (method, true));
    let (family, part) = method.split_once(['+', '/']).unwrap_or((method, ""));
    let color = match family {
        _ if compared => 3,
        "zmv" => 4,
        "zfo" => 5,
        "czmv" => 2,
        "czfo" => 1,
        "rcz" => 0,
        _ => 6,
    };
    let dash = match part {
        "" => 0,
        "c" => 1,
        "f" => 2,
        _ => 3,
    };
    Look::nth(color).dashed(dash)
}

/// A measure over the steps, mean over the runs, one line a cell; the look of a cell is chosen by its name.
#[must_use]
pub fn curves<'a>(
    title: &str,
    cells: impl IntoIterator<Item = &'a Cell>,
    (measure, of): (usize, Measure),
    look: impl Fn(&str) -> Look,
) -> Panel {
    let y_label = if of.unit.is_empty() { of.name.to_owned() } else { format!("{} [{}]", of.name, of.unit) };
    cells.into_iter().fold(Panel::new(title, "k", y_label).log_y(), |panel, cell| {
        let points = cell.curve(measure).into_iter().enumerate().map(|(k, value)| (k as f64, value));
        panel.with(Series::line(&*cell.method, look(&cell.method), points))
    })
}
