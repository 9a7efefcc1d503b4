//! The text of an experiment: headings, paragraphs, tables and figures, rendered as Markdown (`report.md`) and as HTML ([`crate::html`]).

use crate::results::{Row, Status};

/// A report, built block by block.
///
/// Text may hold `` `code` `` and `**bold**`; nothing else is markup.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    pub(crate) title: String,
    pub(crate) blocks: Vec<Block>,
}

/// One block of a report.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Block {
    Heading(String),
    Paragraph(String),
    List(Vec<String>),
    Table(Table),
    Figure { name: String, caption: String },
}

impl Report {
    /// A report with nothing but its title.
    #[must_use]
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), blocks: Vec::new() }
    }

    /// Adds a heading.
    pub fn heading(&mut self, text: impl Into<String>) -> &mut Self {
        self.push(Block::Heading(text.into()))
    }

    /// Adds a paragraph.
    pub fn paragraph(&mut self, text: impl Into<String>) -> &mut Self {
        self.push(Block::Paragraph(text.into()))
    }

    /// Adds a list of points.
    pub fn list<T: Into<String>>(&mut self, items: impl IntoIterator<Item = T>) -> &mut Self {
        self.push(Block::List(items.into_iter().map(Into::into).collect()))
    }

    /// Adds a table.
    pub fn table(&mut self, table: Table) -> &mut Self {
        self.push(Block::Table(table))
    }

    /// Adds the figure of that name (without ending) with a caption.
    pub fn figure(&mut self, name: impl Into<String>, caption: impl Into<String>) -> &mut Self {
        self.push(Block::Figure { name: name.into(), caption: caption.into() })
    }

    fn push(&mut self, block: Block) -> &mut Self {
        self.blocks.push(block);
        self
    }

    /// Markdown text; figures are linked as `<name>.svg` beside the report.
    #[must_use]
    pub fn to_markdown(&self) -> String {
        let blocks = self.blocks.iter().map(|block| match block {
            Block::Heading(text) => format!("## {text}\n"),
            Block::Paragraph(text) => format!("{text}\n"),
            Block::List(items) => items.iter().map(|item| format!("- {item}\n")).collect(),
            Block::Table(table) => table.to_markdown(),
            Block::Figure { name, caption } => {
                format!("![{caption}]({name}.svg)\n\n*{caption}* (data: `{name}.csv`)\n")
            }
        });
        std::iter::once(format!("# {}\n", self.title)).chain(blocks).collect::<Vec<_>>().join("\n")
    }
}

/// A table of text cells.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Table {
    pub(crate) header: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

impl Table {
    /// How to read the cells of [`Table::pivot`].
    pub const LEGEND: &str = "Cells: mean ± standard deviation over the runs; (the paper's number, same settings); [the paper's number, for reference].";

    /// A table with a header and no rows.
    #[must_use]
    pub fn new<T: Into<String>>(header: impl IntoIterator<Item = T>) -> Self {
        Self { header: header.into_iter().map(Into::into).collect(), rows: Vec::new() }
    }

    /// Adds a row; missing cells are empty, further ones are left out.
    #[must_use]
    pub fn row<T: Into<String>>(mut self, cells: impl IntoIterator<Item = T>) -> Self {
        let mut cells: Vec<String> = cells.into_iter().map(Into::into).collect();
        cells.resize(self.header.len(), String::new());
        self.rows.push(cells);
        self
    }

    /// Result rows as a table: one line per (row, method, mode), one column per metric, both in order of first appearance.
    ///
    /// Each cell shows our number and the paper's as [`Table::LEGEND`] says.
    pub fn pivot<'a>(rows: impl IntoIterator<Item = &'a Row>) -> Self {
        let mut metrics: Vec<String> = Vec::new();
        let mut lines: Vec<([&str; 3], Vec<String>)> = Vec::new();
        for row in rows {
            let metric = heading_of(row);
            let column = position_or_push(&mut metrics, |m| *m == metric, || metric.clone());
            let key = [row.row_name(), row.method_name(), row.get_mode().map_or("", |mode| mode.name())];
            let line = position_or_push(&mut lines, |(k, _)| *k == key, || (key, Vec::new()));
            let cells = &mut lines[line].1;
            cells.resize(cells.len().max(column + 1), String::new());
            cells[column] = cell_of(row);
        }
        let mut table = Self::new(["row", "method", "mode"].map(str::to_owned).into_iter().chain(metrics));
        for (key, cells) in lines {
            table = table.row(key.map(str::to_owned).into_iter().chain(cells));
        }
        table
    }

    /// Result rows of one case as a table: one line per metric, one column per method, both in order of first appearance.
    pub fn by_method<'a>(rows: impl IntoIterator<Item = &'a Row>) -> Self {
        let (mut methods, mut lines): (Vec<&str>, Vec<(String, Vec<String>)>) = (Vec::new(), Vec::new());
        for row in rows {
            let column = position_or_push(&mut methods, |m| *m == row.method_name(), || row.method_name());
            let metric = heading_of(row);
            let line = position_or_push(&mut lines, |(m, _)| *m == metric, || (metric.clone(), Vec::new()));
            let cells = &mut lines[line].1;
            cells.resize(cells.len().max(column + 1), String::new());
            cells[column] = cell_of(row);
        }
        let table = Self::new(std::iter::once("metric").chain(methods));
        lines.into_iter().fold(table, |table, (metric, cells)| table.row(std::iter::once(metric).chain(cells)))
    }

    /// A row's number, its deviation and the paper's number, as [`Table::LEGEND`] says.
    #[must_use]
    pub fn cell(row: &Row) -> String {
        cell_of(row)
    }

    fn to_markdown(&self) -> String {
        let line = |cells: &[String]| {
            let cells: Vec<String> = cells.iter().map(|cell| cell.replace('|', "\\|")).collect();
            format!("| {} |\n", cells.join(" | "))
        };
        let rule = format!("|{}\n", "---|".repeat(self.header.len()));
        let rows: String = self.rows.iter().map(|cells| line(cells)).collect();
        line(&self.header) + &rule + &rows
    }
}

fn position_or_push<T>(items: &mut Vec<T>, is: impl FnMut(&T) -> bool, new: impl FnOnce() -> T) -> usize {
    items.iter().position(is).unwrap_or_else(|| {
        items.push(new());
        items.len() - 1
    })
}

fn heading_of(row: &Row) -> String {
    if row.unit().is_empty() { row.metric_name().to_owned() } else { format!("{} [{}]", row.metric_name(), row.unit()) }
}

fn cell_of(row: &Row) -> String {
    let mut text = match (row.get_value(), row.get_status()) {
        (Some(count), _) if matches!(row.unit(), "runs" | "steps") && count.fract() == 0.0 => count.to_string(),
        (Some(value), _) => significant(value, 4),
        (None, Some(Status::Diverged)) => "diverged".to_owned(),
        (None, _) => "-".to_owned(),
    };
    if let Some(sd) = row.get_sd() {
        text += &format!(" ± {}", significant(sd, 2));
    }
    match row.paper_number() {
        Some(paper) if row.reproduces_paper() => text += &format!(" ({})", significant(paper, 4)),
        Some(paper) => text += &format!(" [{}]", significant(paper, 4)),
        None => {}
    }
    text
}

/// A number with so many significant digits; very large and very small ones in scientific notation.
#[must_use]
pub fn significant(value: f64, digits: usize) -> String {
    let digits = digits.max(1);
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    // The exponent after rounding to `digits`, so that 9.9996 counts as 10.00.
    let scientific = format!("{value:.*e}", digits - 1);
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok()).unwrap_or(0);
    match usize::try_from(digits as i32 - 1 - exponent) {
        Ok(decimals) if exponent >= -4 => format!("{value:.decimals$}"),
        Err(_) if exponent < 6 => format!("{value:.0}"),
        _ => scientific,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Mode;

    #[test]
    fn significant_digits() {
        let cases = [
            (4.41341, "4.413"),
            (0.00012345, "0.0001234"),
            (12345.6, "12346"),
            (9.99996, "10.00"),
            (1.5e-9, "1.500e-9"),
        ];
        for (value, text) in cases {
            assert_eq!(significant(value, 4), text);
        }
        assert_eq!((significant(0.0, 4), significant(2.5e8, 3)), ("0".to_owned(), "2.50e8".to_owned()));
    }

    /// Two metrics of one cell stand in one line; the paper's number stands in brackets of the right kind.
    #[test]
    fn pivot_groups_metrics_into_columns() {
        let row = |metric: &str| Row::new("Table I", "a|b", "zsmf").mode(Mode::Sound).metric(metric, "m");
        let rows = [row("RMSE(x)").mean_of(&[1.0, 2.0]).paper(1.25), row("AAR(x)").value(f64::NAN).paper_ref(3.0)];
        let table = Table::pivot(&rows);
        assert_eq!(table.header, ["row", "method", "mode", "RMSE(x) [m]", "AAR(x) [m]"]);
        assert_eq!(table.rows, [["a|b", "zsmf", "sound", "1.500 ± 0.71 (1.250)", "diverged [3.000]"]]);
        assert!(table.to_markdown().contains("| a\\|b | zsmf |"));
        let counted = [row("RMSE(x)").value(2.0), row("divergences").value(20.0).metric("divergences", "runs")];
        let table = Table::by_method(&counted);
        assert_eq!(table.header, ["metric", "zsmf"]);
        assert_eq!(table.rows, [["RMSE(x) [m]", "2.000"], ["divergences [runs]", "20"]]);
    }

    #[test]
    fn markdown_of_all_blocks() {
        let mut report = Report::new("T");
        report.heading("H").paragraph("p").list(["a", "b"]).table(Table::new(["x"]).row(["1"])).figure("f", "cap");
        let expected =
            "# T\n\n## H\n\np\n\n- a\n- b\n\n| x |\n|---|\n| 1 |\n\n![cap](f.svg)\n\n*cap* (data: `f.csv`)\n";
        assert_eq!(report.to_markdown(), expected);
    }
}
