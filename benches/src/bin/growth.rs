//! Draws how costs grow with the size: `growth DIR` writes `hull-growth` (interval hulls), `step-growth` (filter steps) and `strips-growth`
//! (steps of the filter of strips by its rows) as SVG and CSV; `growth DIR hull`, `growth DIR step` or `growth DIR strips` one of them.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use benches::{growth, invariant_strips, step_growth};
use scenarios::figure::Figure;

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let Some(folder) = arguments.next().map(PathBuf::from) else {
        eprintln!("growth needs a folder to write to");
        return ExitCode::from(2);
    };
    let only = arguments.next();
    let wanted = |name: &str| only.as_deref().is_none_or(|only| only == name);
    let mut figures = Vec::new();
    if wanted("hull") {
        figures.push(growth::figure(&growth::sweeps()));
    }
    if wanted("step") {
        figures.push(step_growth::figure(&step_growth::sweeps()));
    }
    if wanted("strips") {
        figures.push(invariant_strips::growth_figure());
    }
    for figure in &figures {
        if let Err(error) = write(figure, &folder) {
            eprintln!("cannot write {} to {}: {error}", figure.name(), folder.display());
            return ExitCode::FAILURE;
        }
        println!("written: {0}.svg and {0}.csv in {1}", figure.name(), folder.display());
    }
    ExitCode::SUCCESS
}

fn write(figure: &Figure, folder: &Path) -> std::io::Result<()> {
    let csv = figure.data().to_csv().map_err(std::io::Error::other)?;
    std::fs::create_dir_all(folder)?;
    std::fs::write(folder.join(format!("{}.svg", figure.name())), figure.to_svg())?;
    std::fs::write(folder.join(format!("{}.csv", figure.name())), csv)
}
