//! Every package that the workspace builds with has a licence of the list in `deny.toml`.

use std::collections::BTreeSet;

use serde_json::Value;
use spdx::{Expression, Licensee, ParseMode};

use super::Finding;

/// Packages (of the whole graph in `metadata`) whose licence expression the list in `deny` does not satisfy.
pub(crate) fn check(metadata: &Value, deny: &str) -> Vec<Finding> {
    let allowed: Vec<Licensee> = allowed(deny).filter_map(|name| Licensee::parse(name).ok()).collect();
    if allowed.is_empty() {
        return vec!["deny.toml allows no licence".to_owned()];
    }
    let packages = metadata["packages"].as_array().map(Vec::as_slice).unwrap_or_default();
    let refused: BTreeSet<Finding> = packages
        .iter()
        .filter(|package| !satisfies(package["license"].as_str(), &allowed))
        .map(|package| {
            format!("{} has the licence {}, which deny.toml does not allow", package["name"], package["license"])
        })
        .collect();
    refused.into_iter().collect()
}

/// The quoted names between `allow = [` and `]`, without comments.
fn allowed(deny: &str) -> impl Iterator<Item = &str> {
    deny.lines()
        .skip_while(|line| !line.starts_with("allow = ["))
        .skip(1)
        .take_while(|line| !line.starts_with(']'))
        .filter(|line| !line.trim_start().starts_with('#'))
        .filter_map(|line| line.split('"').nth(1))
}

/// Whether a licence expression can be met by the allowed licences; no expression cannot.
fn satisfies(license: Option<&str>, allowed: &[Licensee]) -> bool {
    license
        .and_then(|text| Expression::parse_mode(text, ParseMode::LAX).ok())
        .is_some_and(|expression| expression.evaluate(|wanted| allowed.iter().any(|have| have.satisfies(wanted))))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::check;

    const DENY: &str = "[licenses]\nallow = [\n    \"MIT\",\n    # why\n    \"Apache-2.0 WITH LLVM-exception\",\n]\n";

    #[test]
    fn accepts_what_can_be_met_and_names_what_can_not() {
        let metadata = json!({"packages": [
            {"name": "a", "license": "MIT OR GPL-3.0-only"},
            {"name": "b", "license": "Apache-2.0 WITH LLVM-exception"},
            {"name": "c", "license": "Zlib/MIT"},
            {"name": "d", "license": "MIT AND Unicode-3.0"},
            {"name": "e", "license": "Apache-2.0"},
            {"name": "f", "license": null},
        ]});
        let findings = check(&metadata, DENY);
        assert_eq!(findings.len(), 3, "{findings:?}");
        assert!(["\"d\"", "\"e\"", "\"f\""].iter().zip(&findings).all(|(name, finding)| finding.starts_with(name)));
    }

    #[test]
    fn an_empty_list_is_a_finding() {
        assert_eq!(check(&json!({"packages": []}), "[bans]").len(), 1);
    }
}
