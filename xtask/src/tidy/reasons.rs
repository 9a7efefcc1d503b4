//! Every dependency has a reason in `docs/ARCHITECTURE.md`, and no other crate than those it names there uses it.

use serde_json::Value;

use super::Finding;

/// What a row of the table says: packages, the crates that use them.
struct Row<'a> {
    packages: &'a str,
    used_by: &'a str,
}

/// The rows of the table of dependencies: those whose first cell is in backticks.
fn rows(architecture: &str) -> Vec<Row<'_>> {
    let cells =
        |line: &'_ str| -> Option<(usize, usize)> { line.strip_prefix("| `")?.find(" |").map(|end| (2, end + 3)) };
    architecture
        .lines()
        .filter_map(|line| {
            let (start, end) = cells(line)?;
            let used_by = line[end..].trim_start_matches([' ', '|']).split('|').next()?;
            Some(Row { packages: &line[start..end], used_by })
        })
        .collect()
}

/// Names in `[workspace.dependencies]` without a row, and uses outside tests that the row does not name.
pub(crate) fn check(manifest: &str, metadata: &Value, architecture: &str) -> Vec<Finding> {
    let rows = rows(architecture);
    let row_of = |name: &str| rows.iter().find(|row| row.packages.contains(&format!("`{name}`")));
    let mut findings: Vec<Finding> = declared(manifest)
        .filter(|name| row_of(name).is_none())
        .map(|name| format!("docs/ARCHITECTURE.md gives no reason for the dependency {name}"))
        .collect();
    let packages = metadata["packages"].as_array().map(Vec::as_slice).unwrap_or_default();
    for package in packages {
        let user = package["name"].as_str().unwrap_or_default();
        let dependencies = package["dependencies"].as_array().map(Vec::as_slice).unwrap_or_default();
        for dependency in dependencies.iter().filter(|dependency| dependency["kind"].is_null()) {
            let name = dependency["name"].as_str().unwrap_or_default();
            if let Some(row) = row_of(name)
                && !(names(row.used_by, user) || row.used_by.contains("all libraries"))
            {
                findings.push(format!("docs/ARCHITECTURE.md does not say that {user} uses {name}"));
            }
        }
    }
    findings
}

/// Whether a cell names a crate, as a whole word.
fn names(cell: &str, name: &str) -> bool {
    cell.split(|c: char| !(c.is_alphanumeric() || c == '-')).any(|word| word == name)
}

/// The outside packages of the workspace's table; our own crates are on the map, not in the list of reasons.
fn declared(manifest: &str) -> impl Iterator<Item = &str> {
    let table = manifest.lines().skip_while(|line| line.trim() != "[workspace.dependencies]").skip(1);
    table.take_while(|line| !line.starts_with('[')).filter_map(|line| {
        let (name, value) = line.split_once('=')?;
        (!line.starts_with('#') && !value.contains("path =")).then(|| name.trim())
    })
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::check;

    const MANIFEST: &str = "[workspace.dependencies]\n# why\nours = { path = \"x\" }\na = \"1\"\nb = { version = \"2\" }\n[profile]\nc = 1\n";

    #[test]
    fn names_what_has_no_reason() {
        let none = json!({"packages": []});
        assert_eq!(check(MANIFEST, &none, "| `a`, `b` | sets | speed |"), [""; 0]);
        let findings = check(MANIFEST, &none, "| `a` | sets | speed |\nthe text says `b`");
        assert_eq!(findings, ["docs/ARCHITECTURE.md gives no reason for the dependency b"]);
    }

    #[test]
    fn names_a_crate_that_the_row_does_not() {
        let used = json!({"packages": [{"name": "sets", "dependencies": [
            {"name": "a", "kind": null}, {"name": "b", "kind": "dev"}, {"name": "ours", "kind": null},
        ]}]});
        assert_eq!(check(MANIFEST, &used, "| `a`, `b` | sets | speed |"), [""; 0]);
        assert_eq!(check(MANIFEST, &used, "| `a` | all libraries | speed |\n| `b` | tests | x |"), [""; 0]);
        let findings = check(MANIFEST, &used, "| `a`, `b` | sets-two, tests | speed |");
        assert_eq!(findings, ["docs/ARCHITECTURE.md does not say that sets uses a"]);
    }
}
