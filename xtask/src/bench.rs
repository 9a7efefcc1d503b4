//! `bench`: the table of ratios, and criterion's statistics on demand.

use std::path::PathBuf;

use clap::Args;

use crate::process::{cargo, succeed};

/// Arguments of `bench`.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Beginnings of the names of the rows to measure (all by default).
    names: Vec<String>,
    /// Also writes the rows as JSON.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Runs criterion's benches of our side instead of the table.
    #[arg(long, conflicts_with = "json")]
    criterion: bool,
}

/// Measures.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let mut command = if arguments.criterion {
        cargo(&["bench", "--package", "benches", "--bench", "hot_paths", "--"])
    } else {
        cargo(&["run", "--profile", "bench", "--package", "benches", "--bin", "ratios", "--"])
    };
    command.args(&arguments.names);
    if let Some(file) = &arguments.json {
        // The command runs at the root; the user means the folder they stand in.
        let file = std::path::absolute(file).map_err(|error| format!("{}: {error}", file.display()))?;
        command.arg("--json").arg(file);
    }
    succeed(&mut command, "bench")
}
