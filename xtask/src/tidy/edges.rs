//! Nothing runs upward: the edges between our crates.

use serde_json::Value;

use super::Finding;

/// What each crate may use of ours, tests included. `benches` may use any.
const ALLOWED: [(&str, &[&str]); 9] = [
    ("scalars", &[]),
    ("boxlp", &[]),
    ("lie-groups", &["scalars"]),
    ("setrep", &["scalars", "boxlp"]),
    ("nonlin-bounds", &["setrep", "scalars"]),
    ("estimators", &["nonlin-bounds", "setrep", "lie-groups", "scalars"]),
    ("scenarios", &["estimators", "nonlin-bounds", "setrep", "boxlp", "lie-groups", "scalars"]),
    ("xtask", &["scenarios"]),
    ("benches", &["scenarios", "estimators", "nonlin-bounds", "setrep", "boxlp", "lie-groups", "scalars"]),
];

/// Edges that the architecture does not have, and packages it does not know.
pub(crate) fn check(metadata: &Value) -> Vec<Finding> {
    let packages = metadata["packages"].as_array().map(Vec::as_slice).unwrap_or_default();
    let ours: Vec<&str> = packages.iter().filter_map(|package| package["name"].as_str()).collect();
    let mut findings = Vec::new();
    for package in packages {
        let name = package["name"].as_str().unwrap_or_default();
        let Some((_, allowed)) = ALLOWED.iter().find(|(known, _)| *known == name) else {
            findings.push(format!("package {name} is not on the map of docs/ARCHITECTURE.md"));
            continue;
        };
        let dependencies = package["dependencies"].as_array().map(Vec::as_slice).unwrap_or_default();
        for dependency in dependencies.iter().filter_map(|dependency| dependency["name"].as_str()) {
            if ours.contains(&dependency) && !allowed.contains(&dependency) {
                findings.push(format!("{name} must not depend on {dependency}"));
            }
        }
    }
    if packages.is_empty() {
        findings.push("cargo metadata lists no package".to_owned());
    }
    findings
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::check;

    fn workspace(upward: &str) -> serde_json::Value {
        json!({"packages": [
            {"name": "scalars", "dependencies": [{"name": "pxfm"}]},
            {"name": "setrep", "dependencies": [{"name": "scalars"}, {"name": upward}]},
            {"name": "estimators", "dependencies": [{"name": "setrep"}]},
        ]})
    }

    #[test]
    fn accepts_the_arrows_and_refuses_an_upward_edge() {
        assert!(check(&workspace("faer")).is_empty());
        assert_eq!(check(&workspace("estimators")), ["setrep must not depend on estimators"]);
    }

    #[test]
    fn refuses_an_unknown_package_and_an_empty_list() {
        let unknown = json!({"packages": [{"name": "helpers", "dependencies": []}]});
        assert_eq!(check(&unknown).len(), 1);
        assert_eq!(check(&json!({})).len(), 1);
    }
}
