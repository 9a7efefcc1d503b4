//! The project's commands: `cargo xtask reproduce | test | tidy | ci | bench | soak`.

mod bench;
mod ci;
mod reproduce;
mod soak;
mod test;
mod tidy;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use xtask::exit;

/// The project's commands.
#[derive(Parser)]
#[command(name = "cargo xtask", version, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Runs the papers' experiments and writes their tables and figures beside ours (`reproduce --help` lists the options).
    #[command(disable_help_flag = true)]
    Reproduce {
        /// Experiments (all by default) and options.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<OsString>,
    },
    /// Runs the tests of the whole workspace, doctests included.
    Test(test::Arguments),
    /// Checks the rules of the project: crate edges, doc heads, stray unsafe, file lengths, reasons for dependencies.
    Tidy,
    /// Runs what continuous integration runs: fmt, clippy, tidy, rustdoc, licences, tests.
    Ci,
    /// Times our operations against peers and floors, as ratios in one run.
    Bench(bench::Arguments),
    /// Runs the long versions of the containment batteries.
    Soak(soak::Arguments),
}

fn main() -> ExitCode {
    exit(match Cli::parse().command {
        Command::Reproduce { arguments } => reproduce::run(&arguments),
        Command::Test(arguments) => test::run(&arguments),
        Command::Tidy => tidy::run(),
        Command::Ci => ci::run(),
        Command::Bench(arguments) => bench::run(&arguments),
        Command::Soak(arguments) => soak::run(&arguments),
    })
}
