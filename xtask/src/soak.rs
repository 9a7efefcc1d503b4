//! `soak`: the containment batteries with many more cases.

use clap::Args;

use crate::process::{cargo, succeed};

/// Arguments of `soak`.
#[derive(Args)]
pub(crate) struct Arguments {
    /// How many times the cases of a run in continuous integration.
    #[arg(long, default_value_t = 100)]
    factor: u32,
    /// Packages to soak (all with containment batteries by default).
    packages: Vec<String>,
}

/// Packages with a `containment` test binary.
const PACKAGES: [&str; 5] = ["scalars", "lie-groups", "setrep", "estimators", "scenarios"];

/// Runs the `containment` batteries with `ORBITOPE_CASES` set.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let known = PACKAGES.map(String::from);
    let packages: &[String] = if arguments.packages.is_empty() { &known } else { &arguments.packages };
    for package in packages {
        if !known.contains(package) {
            return Err(format!("{package} has no containment battery; there are: {}", PACKAGES.join(", ")));
        }
        let mut command =
            cargo(&["test", "--release", "--package", package, "--test", "containment", "--", "--nocapture"]);
        command.env("ORBITOPE_CASES", arguments.factor.to_string());
        succeed(&mut command, &format!("soak of {package}, {} times the cases", arguments.factor))?;
    }
    Ok(())
}
