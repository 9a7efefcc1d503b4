//! Rules for single files: heads, lengths, stray `unsafe`, input and output in libraries, text that must not be committed.

use std::process::Command;

use super::{Finding, read};
use xtask::root;

/// Lines above which a file holds more than one concept.
const LONGEST: usize = 500;

/// Crates that compute and neither read nor write nor print.
const SILENT: [&str; 6] = ["scalars", "boxlp", "lie-groups", "setrep", "nonlin-bounds", "estimators"];

/// What reads, writes or prints.
const NOISE: [&str; 8] = ["println!", "eprintln!", "print!(", "dbg!", "std::fs", "std::io", "std::env", "std::process"];

/// Checks every file that git tracks or would add.
pub(crate) fn check() -> Result<Vec<Finding>, String> {
    let mut findings = Vec::new();
    for path in tracked()? {
        if path == "Cargo.lock" || path.ends_with(".svg") {
            continue;
        }
        // Bytes that are no text are no source either.
        let Ok(text) = read(&path) else { continue };
        findings.extend(check_text(&path, &text));
        if path.ends_with(".rs") {
            findings.extend(check_source(&path, &text));
        }
    }
    Ok(findings)
}

/// The tracked files and the new ones that are not ignored.
fn tracked() -> Result<Vec<String>, String> {
    let output = Command::new("git")
        .current_dir(root())
        .args(["ls-files", "--cached", "--others", "--exclude-standard"])
        .output()
        .map_err(|error| format!("git could not be started: {error}"))?;
    let paths: Vec<String> = String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect();
    if paths.is_empty() { Err("git lists no files".to_owned()) } else { Ok(paths) }
}

/// Paths of a machine and hosts of package registries, written so that this file does not contain them.
fn forbidden() -> [String; 7] {
    [
        ["/wo", "rk/"],
        ["/ho", "me/"],
        ["/ro", "ot/"],
        ["/tm", "p/"],
        ["crates", ".io-"],
        ["index.crates", ".io"],
        ["py", "pi.org"],
    ]
    .map(|parts| parts.concat())
}

fn check_text(path: &str, text: &str) -> Vec<Finding> {
    let hits = forbidden().into_iter().filter(|needle| text.contains(needle.as_str()));
    hits.map(|needle| format!("{path}: contains {needle}, which names a machine or a registry")).collect()
}

fn check_source(path: &str, text: &str) -> Vec<Finding> {
    let mut findings = Vec::new();
    if !text.trim_start().starts_with("//!") {
        findings.push(format!("{path}: does not begin with a //! line that says what it is"));
    }
    let lines = text.lines().count();
    if lines > LONGEST {
        findings.push(format!("{path}: {lines} lines, more than {LONGEST}"));
    }
    let silent = SILENT.iter().any(|name| path.starts_with(&format!("crates/{name}/src/")));
    // Unit tests at the end of a file may print.
    let library = text.split("#[cfg(test)]").next().unwrap_or_default();
    for (number, line) in library.lines().enumerate() {
        let code = line.split("//").next().unwrap_or_default();
        let at = format!("{path}:{}", number + 1);
        if code.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == concat!("un", "safe")) {
            findings.push(format!("{at}: stray {}", concat!("un", "safe")));
        }
        if silent && let Some(noise) = NOISE.iter().find(|noise| code.contains(**noise)) {
            findings.push(format!("{at}: {noise} in a crate that neither reads nor writes nor prints"));
        }
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::{check_source, check_text};

    const PATH: &str = "crates/setrep/src/x.rs";

    #[test]
    fn a_good_file_passes() {
        assert!(check_source(PATH, "//! What it is.\nfn f() {} // std::fs in a comment\n").is_empty());
    }

    #[test]
    fn each_rule_can_fail() {
        assert_eq!(check_source(PATH, "fn f() {}\n").len(), 1, "head");
        assert_eq!(check_source(PATH, &format!("//! Long.\n{}", "\n".repeat(500))).len(), 1, "length");
        assert_eq!(check_source(PATH, "//! X.\nuse std::fs;\n").len(), 1, "input and output");
        assert!(check_source("crates/scenarios/src/x.rs", "//! X.\nuse std::fs;\n").is_empty(), "scenarios may");
        let stray = format!("//! X.\n{} fn f() {{}}\n", ["un", "safe"].concat());
        assert_eq!(check_source(PATH, &stray).len(), 1, "unsafe");
        assert_eq!(check_text("README.md", &["see /wo", "rk/x"].concat()).len(), 1, "machine path");
    }
}
