//! `soak`: the containment batteries with many more cases.

use clap::Args;

use xtask::{cargo, succeed};

/// Arguments of `soak`.
#[derive(Args)]
pub(crate) struct Arguments {
    /// How many times the cases of a run in continuous integration.
    #[arg(long, default_value_t = 100)]
    factor: u32,
    /// Packages to soak (all with containment batteries by default).
    packages: Vec<String>,
}

/// Packages with containment batteries, and the test binaries that hold them.
const PACKAGES: [(&str, &[&str]); 7] = [
    ("scalars", &["containment"]),
    ("boxlp", &["containment"]),
    ("lie-groups", &["containment"]),
    ("setrep", &["containment", "cz", "bundle", "polytope", "plot", "laws"]),
    ("nonlin-bounds", &["derivatives", "range", "images", "polytopic", "contract"]),
    ("estimators", &["containment", "polytopic", "set_filters"]),
    ("scenarios", &["containment"]),
];

/// Runs the containment batteries with `ORBITOPE_CASES` set.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    if let Some(unknown) = arguments.packages.iter().find(|name| PACKAGES.iter().all(|(known, _)| known != name)) {
        let known = PACKAGES.map(|(name, _)| name).join(", ");
        return Err(format!("{unknown} has no containment battery; there are: {known}"));
    }
    let chosen = |name: &str| arguments.packages.is_empty() || arguments.packages.iter().any(|package| package == name);
    for (package, batteries) in PACKAGES.into_iter().filter(|(name, _)| chosen(name)) {
        let mut command = cargo(&["test", "--release", "--all-features", "--package", package]);
        for battery in batteries {
            command.args(["--test", battery]);
        }
        command.args(["--", "--nocapture"]).env("ORBITOPE_CASES", arguments.factor.to_string());
        succeed(&mut command, &format!("soak of {package}, {} times the cases", arguments.factor))?;
    }
    Ok(())
}
