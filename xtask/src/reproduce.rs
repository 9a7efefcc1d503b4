//! `reproduce`: builds and starts the program that runs the experiments.

use std::ffi::OsString;
use std::process::Command;

use xtask::{cargo_program, root};

/// Hands the arguments on; paths in them are of the folder the user stands in.
pub(crate) fn run(arguments: &[OsString]) -> Result<(), String> {
    let mut command = Command::new(cargo_program());
    command.args([
        "run",
        "--quiet",
        "--release",
        "--package",
        "xtask",
        "--features",
        "reproduce",
        "--bin",
        "reproduce",
    ]);
    command.arg("--manifest-path").arg(root().join("Cargo.toml")).arg("--").args(arguments);
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        // The program has said why.
        Ok(_) => Err("reproduce failed".to_owned()),
        Err(error) => Err(format!("reproduce could not be started: {error}")),
    }
}
