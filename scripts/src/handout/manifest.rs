//! The top manifest of a handout.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use toml_edit::{Array, DocumentMut, Item, Value, value};

use crate::kit::Kit;
use crate::starter::Files;

/// The kit's manifest, with no member and no path that `files` does not have.
pub(super) fn fitting(kit: &Kit, files: &Files) -> Result<String> {
    let text = fs::read_to_string(kit.path("Cargo.toml")).context("cannot read Cargo.toml")?;
    fit(&text, |folder| files.contains_key(&Path::new(folder).join("Cargo.toml")))
}

fn fit(text: &str, there: impl Fn(&str) -> bool) -> Result<String> {
    let mut manifest: DocumentMut = text.parse().context("Cargo.toml")?;
    let workspace = manifest["workspace"].as_table_mut().context("Cargo.toml has no workspace")?;
    // The command tests itself on a whole kit: in a handout that is nobody's business.
    let keep = |member: &str| member != "scripts" && there(member);
    if let Some(members) = workspace.get("default-members").and_then(Item::as_array) {
        let kept = members.iter().filter_map(Value::as_str).filter(|member| keep(member));
        workspace["default-members"] = value(Array::from_iter(kept.map(String::from)));
    }
    // A pattern without a match is an error of cargo's.
    if let Some(members) = workspace.get("members").and_then(Item::as_array) {
        let has_solutions = there("solutions/lab1");
        let kept = members.iter().filter_map(Value::as_str);
        let kept = kept.filter(|member| has_solutions || !member.starts_with("solutions/"));
        workspace["members"] = value(Array::from_iter(kept.map(String::from)));
    }
    if let Some(dependencies) = workspace.get_mut("dependencies").and_then(Item::as_table_like_mut)
    {
        let gone: Vec<String> = dependencies
            .iter()
            .filter(|(_, item)| {
                let path = item.as_table_like().and_then(|table| table.get("path")?.as_str());
                path.is_some_and(|path| !there(path))
            })
            .map(|(name, _)| name.to_owned())
            .collect();
        for name in gone {
            dependencies.remove(&name);
        }
    }
    Ok(manifest.to_string())
}

#[cfg(test)]
mod tests {
    use super::fit;

    const WHOLE: &str = "\
[workspace]
members = [\"labs/*\", \"solutions/*\", \"scripts\"]
default-members = [\"labs/common\", \"scripts\", \"solutions/lab1\", \"solutions/lab2\"]

[workspace.dependencies]
common = { path = \"labs/common\" }
solution1 = { path = \"solutions/lab1\" }
solution2 = { path = \"solutions/lab2\" }

serde = \"1\"
";

    #[test]
    fn what_is_not_there_is_not_named() {
        let fitted = fit(WHOLE, |folder| folder != "solutions/lab2").unwrap();
        assert!(fitted.contains("default-members = [\"labs/common\", \"solutions/lab1\"]"));
        assert!(fitted.contains("members = [\"labs/*\", \"solutions/*\", \"scripts\"]"));
        assert!(fitted.contains("solution1 =") && !fitted.contains("solution2"), "{fitted}");
        assert!(fitted.contains("serde = \"1\""));
    }

    #[test]
    fn the_first_lab_is_given_no_solution() {
        let fitted = fit(WHOLE, |folder| !folder.starts_with("solutions")).unwrap();
        assert!(!fitted.contains("solution"), "{fitted}");
    }
}
