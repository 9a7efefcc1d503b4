//! `tidy`: the rules of the project that a compiler does not check.

mod edges;
mod licenses;
mod reasons;
mod sources;

use xtask::{cargo, root};

/// A rule that is broken: where, and what.
type Finding = String;

/// Checks all rules and lists every finding.
pub(crate) fn run() -> Result<(), String> {
    println!("--- tidy");
    let ours = metadata(&["--no-deps"])?;
    let mut findings = edges::check(&ours);
    findings.extend(reasons::check(&read("Cargo.toml")?, &ours, &read("docs/ARCHITECTURE.md")?));
    findings.extend(licenses::check(&metadata(&[])?, &read("deny.toml")?));
    findings.extend(sources::check()?);
    if findings.is_empty() {
        return Ok(());
    }
    for finding in &findings {
        eprintln!("{finding}");
    }
    Err(format!("tidy found {} broken rules", findings.len()))
}

/// Packages and what they depend on, as cargo sees them: of the whole graph, or with `--no-deps` of the workspace.
fn metadata(arguments: &[&str]) -> Result<serde_json::Value, String> {
    let output = cargo(&["metadata", "--format-version", "1"])
        .args(arguments)
        .output()
        .map_err(|error| format!("cargo metadata could not be started: {error}"))?;
    if !output.status.success() {
        return Err(format!("cargo metadata failed: {}", String::from_utf8_lossy(&output.stderr)));
    }
    serde_json::from_slice(&output.stdout).map_err(|error| format!("cargo metadata printed no JSON: {error}"))
}

fn read(path: &str) -> Result<String, String> {
    std::fs::read_to_string(root().join(path)).map_err(|error| format!("cannot read {path}: {error}"))
}
