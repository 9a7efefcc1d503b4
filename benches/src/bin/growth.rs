//! Draws how the cost of an interval hull grows: `growth DIR` writes `hull-growth.svg` and `hull-growth.csv`.

use std::path::PathBuf;
use std::process::ExitCode;

use benches::growth::{Sweep, figure, sweeps};

fn main() -> ExitCode {
    let Some(folder) = std::env::args().nth(1).map(PathBuf::from) else {
        eprintln!("growth needs a folder to write to");
        return ExitCode::from(2);
    };
    let sweeps: Vec<Sweep> = sweeps();
    let figure = figure(&sweeps);
    let csv = figure.data().to_csv().map_err(std::io::Error::other);
    let written = std::fs::create_dir_all(&folder)
        .and_then(|()| std::fs::write(folder.join("hull-growth.svg"), figure.to_svg()))
        .and_then(|()| std::fs::write(folder.join("hull-growth.csv"), csv?));
    match written {
        Ok(()) => {
            println!("written: hull-growth.svg and hull-growth.csv in {}", folder.display());
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("cannot write to {}: {error}", folder.display());
            ExitCode::FAILURE
        }
    }
}
