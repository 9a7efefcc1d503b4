//! `bench`: the table of ratios; criterion's statistics and the growth of costs on demand.

use std::path::PathBuf;

use clap::Args;

use xtask::{cargo, succeed};

/// Arguments of `bench`.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Beginnings of the names of the rows to measure (all by default); or `growth`, to draw how the costs of hulls and filter steps
    /// grow into target/bench (`growth hull`, `growth step`: one of them).
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
    let release = |binary| cargo(&["run", "--profile", "bench", "--package", "benches", "--bin", binary, "--"]);
    if let Some((name, parts)) = arguments.names.split_first().filter(|(name, _)| *name == "growth") {
        return succeed(release(name).arg("target/bench").args(parts), "growth of costs");
    }
    let mut command = if arguments.criterion {
        cargo(&["bench", "--package", "benches", "--bench", "hot_paths", "--"])
    } else {
        release("ratios")
    };
    command.args(&arguments.names);
    if let Some(file) = &arguments.json {
        // The command runs at the root; the user means the folder they stand in.
        let file = std::path::absolute(file).map_err(|error| format!("{}: {error}", file.display()))?;
        command.arg("--json").arg(file);
    }
    succeed(&mut command, "bench")
}
