//! `test`: the whole workspace's tests, optimised because they compute much.

use std::path::PathBuf;

use clap::Args;

use xtask::{DATA_VARIABLE, cargo, data_folder, succeed};

/// Arguments of `test`.
#[derive(Args, Default)]
pub(crate) struct Arguments {
    /// Folder with data that does not ship with the project (else the environment variable ORBITOPE_DATA).
    #[arg(long, value_name = "DIR")]
    data: Option<PathBuf>,
}

/// Runs the tests of every package but the benches, with all features, then the doctests.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let mut command = cargo(&["test", "--release", "--workspace", "--exclude", "benches", "--all-features"]);
    if let Some(folder) = data_folder(arguments.data.as_deref())? {
        command.env(DATA_VARIABLE, folder);
    } else {
        println!(
            "{DATA_VARIABLE} is not set: tests on data that do not ship with the project print a line and pass (see README)"
        );
    }
    succeed(&mut command, "tests")
}
