//! Starting other programs, and where the workspace and its outside data are.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

/// The environment variable that names the folder of `data` and `itf1788`.
pub const DATA_VARIABLE: &str = "ORBITOPE_DATA";

/// The root of the workspace.
pub fn root() -> &'static Path {
    // The manifest of this package lies one folder below the root.
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."))
}

/// The cargo that started this program, else the one on the path.
pub fn cargo_program() -> OsString {
    std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

/// Cargo, at the root of the workspace.
pub fn cargo(arguments: &[&str]) -> Command {
    let mut command = Command::new(cargo_program());
    command.current_dir(root()).args(arguments);
    command
}

/// Runs a command and turns anything but success into a message.
pub fn succeed(command: &mut Command, what: &str) -> Result<(), String> {
    println!("--- {what}");
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{what} failed ({status})")),
        Err(error) => Err(format!("{what} could not be started: {error}")),
    }
}

/// The folder with data that does not ship with the project: the argument, else the environment variable.
///
/// # Errors
/// A folder that was named and does not exist.
pub fn data_folder(argument: Option<&Path>) -> Result<Option<PathBuf>, String> {
    let named = argument.map(Path::to_path_buf).or_else(|| std::env::var_os(DATA_VARIABLE).map(PathBuf::from));
    match named {
        Some(folder) if !folder.is_dir() => Err(format!("the data folder {} does not exist", folder.display())),
        // Tests run in the folder of their crate: a relative path would mean something else there.
        Some(folder) => std::path::absolute(&folder).map(Some).map_err(|e| format!("{}: {e}", folder.display())),
        None => Ok(None),
    }
}

/// Says what failed, on standard error, and with what code a program ends.
pub fn exit(outcome: Result<(), String>) -> ExitCode {
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}
