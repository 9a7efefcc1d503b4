//! `index.html`: all experiments on one page that needs no other file.

use crate::report::{Block, Table};
use crate::{Figure, Output, Report};

/// What became of one experiment.
#[derive(Debug)]
pub struct Page<'a> {
    /// Name of the experiment, also of its folder.
    pub name: &'a str,
    /// Its one line.
    pub description: &'a str,
    /// Its output, or the line that says why there is none.
    pub outcome: Result<&'a Output, String>,
}

const STYLE: &str = "
:root { color-scheme: light; }
body { font: 16px/1.55 system-ui, sans-serif; color: #1c2733; max-width: 70rem; margin: 2rem auto; padding: 0 1.25rem; }
h1 { font-size: 1.9rem; } h2 { margin-top: 3.5rem; padding-top: 1rem; border-top: 2px solid #d5dde5; } h3 { margin-top: 2rem; }
a { color: #0a5fa5; } code { background: #eef2f6; padding: 0 .25em; border-radius: 3px; font-size: .9em; }
.scroll { overflow-x: auto; } table { border-collapse: collapse; font-size: .88rem; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .7rem; border-bottom: 1px solid #d5dde5; text-align: left; white-space: nowrap; }
th { background: #eef2f6; position: sticky; top: 0; } tr:hover td { background: #f7f9fb; }
figure { margin: 1.5rem 0; } figure img { max-width: 100%; height: auto; } figcaption, .muted { color: #5a6b7b; font-size: .92rem; }
";

/// The page over all experiments; figures are embedded, numbers link to the files beside it.
#[must_use]
pub fn index(pages: &[Page<'_>]) -> String {
    let entries: String = pages.iter().map(entry).collect();
    let sections: String = pages.iter().map(section).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>Orbitope: reproduced experiments</title>\n<style>{STYLE}</style>\n</head>\n<body>\n\
         <h1>Orbitope: reproduced experiments</h1>\n<ul>\n{entries}</ul>\n{sections}</body>\n</html>\n"
    )
}

fn entry(page: &Page<'_>) -> String {
    let name = escape(page.name);
    let skipped = if page.outcome.is_err() { " (not run)" } else { "" };
    format!("<li><a href=\"#{name}\">{name}</a>: {}{skipped}</li>\n", escape(page.description))
}

fn section(page: &Page<'_>) -> String {
    let name = escape(page.name);
    match &page.outcome {
        Err(reason) => format!("<h2 id=\"{name}\">{name}</h2>\n<p class=\"muted\">{}</p>\n", inline(reason)),
        Ok(output) => {
            let (seed, runs) = (output.results.seed, output.results.runs);
            let links = ["report.md", "results.json", "timings.json"]
                .map(|file| format!("<a href=\"{name}/{file}\">{file}</a>"));
            format!(
                "<h2 id=\"{name}\">{}</h2>\n<p class=\"muted\">{name}, seed {seed}, {runs} runs: {}</p>\n{}",
                inline(&output.report.title),
                links.join(", "),
                body(&output.report, &output.figures)
            )
        }
    }
}

fn body(report: &Report, figures: &[Figure]) -> String {
    let block = |block: &Block| match block {
        Block::Heading(text) => format!("<h3>{}</h3>\n", inline(text)),
        Block::Paragraph(text) => format!("<p>{}</p>\n", inline(text)),
        Block::List(items) => {
            let items: String = items.iter().map(|item| format!("<li>{}</li>\n", inline(item))).collect();
            format!("<ul>\n{items}</ul>\n")
        }
        Block::Table(table) => table_of(table),
        Block::Figure { name, caption } => {
            let image = figures.iter().find(|figure| figure.name() == name).map(|figure| {
                let source = data_uri(&figure.to_svg());
                format!("<img src=\"{source}\" alt=\"{}\">\n", escape(caption))
            });
            format!("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n", image.unwrap_or_default(), inline(caption))
        }
    };
    report.blocks.iter().map(block).collect()
}

fn table_of(table: &Table) -> String {
    let line = |cells: &[String], tag: &str| {
        let cells: String = cells.iter().map(|cell| format!("<{tag}>{}</{tag}>", inline(cell))).collect();
        format!("<tr>{cells}</tr>\n")
    };
    let rows: String = table.rows.iter().map(|cells| line(cells, "td")).collect();
    format!("<div class=\"scroll\"><table>\n{}{rows}</table></div>\n", line(&table.header, "th"))
}

/// Escapes text and turns `` `code` `` and `**bold**` into tags; an unpaired mark stays as it is.
fn inline(text: &str) -> String {
    paired(&paired(&escape(text), "`", "code"), "**", "strong")
}

fn paired(text: &str, mark: &str, tag: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, (inside, after))) = rest.split_once(mark).and_then(|(b, a)| Some((b, a.split_once(mark)?)))
    {
        out += &format!("{before}<{tag}>{inside}</{tag}>");
        rest = after;
    }
    out + rest
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// An SVG as a data URI: an image of its own, so that element ids of several figures cannot clash.
fn data_uri(svg: &str) -> String {
    let mut uri = String::from("data:image/svg+xml,");
    for byte in svg.bytes() {
        match byte {
            b' ' | b'/' | b':' | b'=' | b',' | b'.' | b'-' | b'_' | b';' | b'(' | b')' => uri.push(char::from(byte)),
            _ if byte.is_ascii_alphanumeric() => uri.push(char::from(byte)),
            _ => uri += &format!("%{byte:02X}"),
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped_and_marked_up() {
        assert_eq!(inline("a < `b & c` **d** *e"), "a &lt; <code>b &amp; c</code> <strong>d</strong> *e");
        assert_eq!(inline("one ` alone"), "one ` alone");
    }

    #[test]
    fn data_uris_leave_no_quote_or_hash() {
        assert_eq!(data_uri("<a id=\"#x\"/>é"), "data:image/svg+xml,%3Ca id=%22%23x%22/%3E%C3%A9");
    }

    #[test]
    fn a_skipped_experiment_is_listed_with_its_reason() {
        let page = Page { name: "wifibot", description: "logs", outcome: Err("no data: get <it>".to_owned()) };
        let html = index(&[page]);
        assert!(html.contains("<a href=\"#wifibot\">wifibot</a>: logs (not run)"));
        assert!(html.contains("no data: get &lt;it&gt;"));
    }
}
