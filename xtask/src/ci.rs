//! `ci`: what continuous integration runs.

use std::process::{Command, Stdio};

use crate::{test, tidy};
use xtask::{cargo, root, succeed};

/// fmt, clippy, tidy, rustdoc, licences, tests, in the order of how soon they fail.
pub(crate) fn run() -> Result<(), String> {
    succeed(&mut cargo(&["fmt", "--all", "--check"]), "fmt")?;
    tidy::run()?;
    succeed(
        &mut cargo(&[
            "clippy",
            "--release",
            "--workspace",
            "--all-targets",
            "--all-features",
            "--",
            "--deny",
            "warnings",
        ]),
        "clippy",
    )?;
    succeed(
        cargo(&["doc", "--release", "--workspace", "--exclude", "benches", "--no-deps", "--all-features"])
            .env("RUSTDOCFLAGS", "--deny warnings"),
        "rustdoc",
    )?;
    licences()?;
    test::run(&test::Arguments::default())
}

/// `cargo deny`, or a line that says it is not installed.
fn licences() -> Result<(), String> {
    let mut probe = Command::new("cargo-deny");
    let installed = probe.arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok();
    if !installed {
        println!("--- licences: skipped, cargo-deny is not installed (cargo install cargo-deny)");
        return Ok(());
    }
    let mut deny = Command::new("cargo-deny");
    succeed(deny.current_dir(root()).args(["check", "licenses", "bans", "sources"]), "licences")
}
