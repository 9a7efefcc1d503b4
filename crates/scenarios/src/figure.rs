//! Figures as data, drawn as SVG.
//!
//! A [`Figure`] is a grid of [`Panel`]s with one legend; a panel is a list of [`Series`]. The numbers stay with the figure, so each is
//! written as CSV beside its SVG. A [`Look`] fixes colour and dash of a method once, through all panels and figures of a report.

use crate::Curve;

mod svg;

/// Colours that stay apart for colour-blind readers (Okabe and Ito), darkest contrast first.
const COLORS: [&str; 7] = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"];
/// Dashes, so that curves stay apart without colours, too.
const DASHES: [Option<&str>; 4] = [None, Some("7 4"), Some("2 3"), Some("8 3 2 3")];

/// Colour and dash of a series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Look {
    color: &'static str,
    dash: Option<&'static str>,
}

impl Look {
    /// Grey and solid: references such as the truth or a bound of zero.
    pub const REFERENCE: Self = Self { color: "#555555", dash: None };

    /// The `index`-th look: colours repeat after seven, dashes after four.
    #[must_use]
    pub fn nth(index: usize) -> Self {
        Self { color: COLORS[index % COLORS.len()], dash: DASHES[index % DASHES.len()] }
    }

    /// The same colour with a solid line.
    #[must_use]
    pub fn solid(self) -> Self {
        Self { dash: None, ..self }
    }

    /// The same colour with the `index`-th dash (0 is solid).
    #[must_use]
    pub fn dashed(self, index: usize) -> Self {
        Self { dash: DASHES[index % DASHES.len()], ..self }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mark {
    Line,
    Band,
    Points,
    Outline,
}

/// Curve, band, point cloud or closed outline.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    label: String,
    mark: Mark,
    look: Look,
    /// x, y and, for a band, its upper edge (elsewhere equal to y).
    points: Vec<[f64; 3]>,
}

impl Series {
    /// A line through the points (x, y); it has a gap at a point that is not finite. An empty label keeps it out of the legend.
    #[must_use]
    pub fn line(label: impl Into<String>, look: Look, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self::new(label, Mark::Line, look, points.into_iter().map(|(x, y)| [x, y, y]))
    }

    /// A filled band between lower and upper edge: (x, lower, upper).
    #[must_use]
    pub fn band(label: impl Into<String>, look: Look, points: impl IntoIterator<Item = (f64, f64, f64)>) -> Self {
        Self::new(label, Mark::Band, look, points.into_iter().map(|(x, lower, upper)| [x, lower, upper]))
    }

    /// Single points.
    #[must_use]
    pub fn points(label: impl Into<String>, look: Look, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self::new(label, Mark::Points, look, points.into_iter().map(|(x, y)| [x, y, y]))
    }

    /// A closed polygon through the vertices in order.
    #[must_use]
    pub fn outline(label: impl Into<String>, look: Look, vertices: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self::new(label, Mark::Outline, look, vertices.into_iter().map(|(x, y)| [x, y, y]))
    }

    fn new(label: impl Into<String>, mark: Mark, look: Look, points: impl Iterator<Item = [f64; 3]>) -> Self {
        Self { label: label.into(), mark, look, points: points.collect() }
    }
}

/// One pair of axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    title: String,
    x_label: String,
    y_label: String,
    log_x: bool,
    log_y: bool,
    equal_aspect: bool,
    y_range: Option<(f64, f64)>,
    series: Vec<Series>,
}

impl Panel {
    /// Axes with a title and labels; units belong in the labels (`t [s]`).
    #[must_use]
    pub fn new(title: impl Into<String>, x_label: impl Into<String>, y_label: impl Into<String>) -> Self {
        let (title, x_label, y_label) = (title.into(), x_label.into(), y_label.into());
        Self {
            title,
            x_label,
            y_label,
            log_x: false,
            log_y: false,
            equal_aspect: false,
            y_range: None,
            series: Vec::new(),
        }
    }

    /// Adds a series; later ones are drawn over earlier ones.
    #[must_use]
    pub fn with(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    /// Logarithmic x axis; values that are not positive are left out.
    #[must_use]
    pub fn log_x(mut self) -> Self {
        self.log_x = true;
        self
    }

    /// Logarithmic y axis; values that are not positive are left out.
    #[must_use]
    pub fn log_y(mut self) -> Self {
        self.log_y = true;
        self
    }

    /// The same scale on both axes (maps, sets).
    #[must_use]
    pub fn equal_aspect(mut self) -> Self {
        self.equal_aspect = true;
        self
    }

    /// Shows y from `low` to `high`; curves are cut there.
    #[must_use]
    pub fn y_range(mut self, low: f64, high: f64) -> Self {
        self.y_range = Some((low, high));
        self
    }
}

/// A grid of panels with a title and one legend.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    name: String,
    title: String,
    columns: usize,
    panels: Vec<Panel>,
}

impl Figure {
    /// A figure; `name` is the file name without its ending, `columns` the panels per row.
    #[must_use]
    pub fn new(name: impl Into<String>, title: impl Into<String>, columns: usize) -> Self {
        Self { name: name.into(), title: title.into(), columns: columns.max(1), panels: Vec::new() }
    }

    /// Adds a panel, row by row.
    #[must_use]
    pub fn with(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// File name without its ending.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The numbers in long form: panel, series, x, y and, for bands, the upper edge.
    #[must_use]
    pub fn data(&self) -> Curve {
        let rows = || {
            let series = |(index, panel): (usize, _)| std::iter::repeat(index).zip(panel);
            let panels = self.panels.iter().enumerate().map(|(index, panel)| (index + 1, &panel.series));
            panels
                .flat_map(series)
                .flat_map(|(panel, series)| series.points.iter().map(move |point| (panel, series, point)))
        };
        let upper = |(_, series, point): (usize, &Series, &[f64; 3])| {
            if series.mark == Mark::Band { point[2] } else { f64::NAN }
        };
        Curve::new(&*self.name)
            .column("panel", rows().map(|(panel, ..)| panel as f64))
            .labels("series", rows().map(|(_, series, _)| &*series.label))
            .column("x", rows().map(|(.., point)| point[0]))
            .column("y", rows().map(|(.., point)| point[1]))
            .column("y_upper", rows().map(upper))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample() -> Figure {
        let t = |k: i32| f64::from(k) * 0.1;
        let wave = |k: i32| (t(k), if k == 20 { f64::NAN } else { t(k).sin() });
        let curves = Panel::new("curves", "t [s]", "y [m]")
            .with(Series::band("hull", Look::nth(0), (0..60).map(|k| (t(k), t(k).sin() - 0.5, t(k).sin() + 0.5))))
            .with(Series::line("zsmf", Look::nth(0), (0..60).map(wave)))
            .with(Series::line("inzsmf", Look::nth(1), (0..60).map(|k| (t(k), t(k).cos()))));
        let decay = Panel::new("decay", "t [s]", "width [m]").log_y().with(Series::line(
            "zsmf",
            Look::nth(0),
            (0..60).map(|k| (t(k), (-t(k)).exp())),
        ));
        let map = Panel::new("map", "x1 [m]", "x2 [m]")
            .equal_aspect()
            .with(Series::outline("set", Look::nth(2), [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)]))
            .with(Series::points("fix", Look::nth(3), [(0.5, 0.5), (1.5, 0.2)]));
        Figure::new("sample", "A sample", 2).with(curves).with(decay).with(map)
    }

    #[test]
    fn the_same_figure_gives_the_same_bytes() {
        let svg = sample().to_svg();
        assert!(svg == sample().to_svg());
        assert!(svg.starts_with("<svg") && svg.contains("inzsmf") && svg.contains("x1 [m]"));
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }

    #[test]
    fn data_is_the_long_form_with_gaps() {
        let csv = sample().data().to_csv().unwrap();
        assert_eq!(csv.lines().next(), Some("panel,series,x,y,y_upper"));
        assert_eq!(csv.lines().count(), 1 + 60 * 4 + 6);
        assert!(csv.contains("\n1,zsmf,2,,\n") && csv.contains("\n3,fix,0.5,0.5,\n"));
    }

    /// Nothing to draw is drawn as empty axes, not as a panic.
    #[test]
    fn empty_and_degenerate_figures_are_drawn() {
        let nan = Panel::new("nan", "x", "y").log_x().log_y().with(Series::line(
            "a",
            Look::nth(0),
            [(0.0, -1.0), (1.0, f64::NAN)],
        ));
        let point = Panel::new("point", "x", "y").with(Series::line("a", Look::nth(0), [(1.0, 1.0)]));
        for figure in [Figure::new("none", "none", 0), Figure::new("nan", "nan", 3).with(nan).with(point)] {
            assert!(figure.to_svg().starts_with("<svg"));
        }
    }
}
