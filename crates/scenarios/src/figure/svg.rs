//! The drawing of a figure. The only file that knows the plotting library.

use std::sync::Arc;

use kuva::backend::svg::SvgBackend;
use kuva::plot::legend::{LegendEntry, LegendShape};
use kuva::plot::{BandPlot, LinePlot, LineStyle, MarkerShape, ScatterPlot};
use kuva::render::figure::{Figure as Sheet, FigureLegendPosition};
use kuva::render::layout::{Layout, TickFormat};
use kuva::render::plots::Plot;

use super::{Figure, Mark, Panel, Series};

/// Width and height of a panel in pixels.
const PANEL: (f64, f64) = (480.0, 340.0);

impl Figure {
    /// The drawing.
    #[must_use]
    pub fn to_svg(&self) -> String {
        let columns = self.columns.min(self.panels.len()).max(1);
        let rows = self.panels.len().div_ceil(columns).max(1);
        let plots: Vec<Vec<Plot>> =
            self.panels.iter().map(|panel| panel.series.iter().flat_map(|s| plots_of(s, panel)).collect()).collect();
        let layouts = self.panels.iter().zip(&plots).map(|(panel, plots)| layout_of(panel, plots)).collect();
        let sheet = Sheet::new(rows, columns)
            .with_title(&*self.title)
            .with_cell_size(PANEL.0, PANEL.1)
            .with_plots(plots)
            .with_layouts(layouts)
            .with_shared_legend_entries(self.legend())
            .with_shared_legend_position(FigureLegendPosition::RightTop);
        renumber(&SvgBackend::new().render_scene(&sheet.render()), "kuva-clip-")
    }

    /// One entry per label, in order of first appearance.
    fn legend(&self) -> Vec<LegendEntry> {
        let mut entries: Vec<LegendEntry> = Vec::new();
        for series in self.panels.iter().flat_map(|panel| &panel.series) {
            if series.label.is_empty() || entries.iter().any(|entry| entry.label == series.label) {
                continue;
            }
            let shape = match series.mark {
                Mark::Line | Mark::Outline => LegendShape::Line,
                Mark::Band => LegendShape::Rect,
                Mark::Points => LegendShape::Circle,
            };
            let (label, color) = (series.label.clone(), series.look.color.to_owned());
            entries.push(LegendEntry { label, color, shape, dasharray: series.look.dash.map(str::to_owned) });
        }
        entries
    }
}

/// Numbers the ids that start with `prefix` in order of appearance: the library counts them through the life of the process.
fn renumber(svg: &str, prefix: &str) -> String {
    let mut seen: Vec<&str> = Vec::new();
    let mut pieces = svg.split(prefix);
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (id, rest) = piece.split_at(piece.find(|c: char| !c.is_ascii_digit()).unwrap_or(piece.len()));
        let number = seen.iter().position(|known| *known == id).unwrap_or(seen.len());
        if number == seen.len() {
            seen.push(id);
        }
        out += &format!("{prefix}{number}{rest}");
    }
    out
}

/// The drawable pieces of a series: runs of finite points within the panel's range.
fn plots_of(series: &Series, panel: &Panel) -> Vec<Plot> {
    let visible = |point: &[f64; 3]| {
        point.iter().all(|v| v.is_finite())
            && !(panel.log_x && point[0] <= 0.0)
            && !(panel.log_y && (point[1] <= 0.0 || point[2] <= 0.0))
    };
    let clamp = |y: f64| panel.y_range.map_or(y, |(low, high)| y.max(low).min(high));
    let look = series.look;
    let runs = series.points.split(|point| !visible(point)).filter(|run| !run.is_empty());
    let draw = |run: &[[f64; 3]]| {
        let points = run.iter().map(|p| (p[0], clamp(p[1])));
        match series.mark {
            Mark::Line | Mark::Outline => {
                let closing = run.first().filter(|_| series.mark == Mark::Outline).map(|p| (p[0], clamp(p[1])));
                let style = look.dash.map_or(LineStyle::Solid, |dash| LineStyle::Custom(dash.to_owned()));
                let line = LinePlot::new().with_data(points.chain(closing)).with_color(look.color);
                Plot::Line(line.with_stroke_width(1.6).with_line_style(style))
            }
            Mark::Band => {
                let band = BandPlot::new(
                    run.iter().map(|p| p[0]),
                    run.iter().map(|p| clamp(p[1])),
                    run.iter().map(|p| clamp(p[2])),
                );
                Plot::Band(band.with_color(look.color).with_opacity(0.18))
            }
            Mark::Points => Plot::Scatter(
                ScatterPlot::new()
                    .with_data(points)
                    .with_color(look.color)
                    .with_size(2.5)
                    .with_marker(MarkerShape::Circle),
            ),
        }
    };
    runs.map(draw).collect()
}

fn layout_of(panel: &Panel, plots: &[Plot]) -> Layout {
    let mut layout = Layout::auto_from_plots(plots)
        .with_title(&*panel.title)
        .with_title_size(14)
        .with_x_label(&*panel.x_label)
        .with_y_label(&*panel.y_label)
        .with_label_size(12)
        .with_tick_size(10);
    if panel.log_x {
        layout = layout.with_log_x().with_x_tick_format(TickFormat::Custom(Arc::new(log_tick)));
    }
    if panel.log_y {
        layout = layout.with_log_y().with_y_tick_format(TickFormat::Custom(Arc::new(log_tick)));
    }
    if panel.equal_aspect {
        layout = layout.with_equal_aspect();
    }
    if let Some((low, high)) = panel.y_range {
        layout = layout.with_y_axis_min(low).with_y_axis_max(high);
    }
    layout
}

fn log_tick(value: f64) -> String {
    if (1e-3..1e4).contains(&value) { format!("{value}") } else { format!("{value:e}") }
}
