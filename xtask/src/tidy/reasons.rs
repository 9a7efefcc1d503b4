//! Every dependency has a reason in `docs/ARCHITECTURE.md`.

use super::Finding;

/// Names in `[workspace.dependencies]` that the text does not name in backticks.
pub(crate) fn check(manifest: &str, architecture: &str) -> Vec<Finding> {
    let table = manifest
        .lines()
        .skip_while(|line| line.trim() != "[workspace.dependencies]")
        .skip(1)
        .take_while(|line| !line.starts_with('['));
    let names = table.filter_map(|line| {
        let (name, value) = line.split_once('=')?;
        // Our own crates are on the map, not in the list of reasons.
        (!line.starts_with('#') && !value.contains("path =")).then(|| name.trim())
    });
    names
        .filter(|name| !architecture.contains(&format!("`{name}`")))
        .map(|name| format!("docs/ARCHITECTURE.md gives no reason for the dependency {name}"))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::check;

    #[test]
    fn names_what_has_no_reason() {
        let manifest = "[workspace.dependencies]\n# why\nours = { path = \"x\" }\na = \"1\"\nb = { version = \"2\" }\n[profile]\nc = 1\n";
        assert_eq!(check(manifest, "`a` and `b`"), [""; 0]);
        assert_eq!(check(manifest, "`a`"), ["docs/ARCHITECTURE.md gives no reason for the dependency b"]);
    }
}
