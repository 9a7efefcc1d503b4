//! Draws how costs grow with the size: `growth DIR` writes `hull-growth` (interval hulls) and `step-growth` (filter steps) as SVG and CSV;
//! `growth DIR hull` or `growth DIR step` one of them.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use benches::{growth, step_growth};
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
