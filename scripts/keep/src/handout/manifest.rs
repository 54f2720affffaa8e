//! The top manifest of a part of the kit.

use std::path::Path;

use anyhow::{Context, Result};
use lab_kit::Lab;
use toml_edit::{Array, DocumentMut, InlineTable, Item, Value, value};

/// Returns the kit's manifest without the packages that are not among `paths`.
///
/// Members, paths, patches and profiles of these packages are removed.
pub(crate) fn fit<'p>(text: &str, paths: impl Iterator<Item = &'p Path>) -> Result<String> {
    let manifests = paths.filter(|path| path.ends_with("Cargo.toml"));
    let folders: Vec<&str> = manifests.filter_map(|path| path.parent()?.to_str()).collect();
    let mut manifest: DocumentMut = text.parse().context("Cargo.toml")?;
    let dev = manifest.get_mut("profile").and_then(|profiles| profiles.get_mut("dev"));
    if let Some(packages) =
        dev.and_then(|dev| dev.get_mut("package")).and_then(Item::as_table_like_mut)
    {
        let names: Vec<String> = packages.iter().map(|(name, _)| name.to_owned()).collect();
        for name in &names {
            let folder = name.strip_prefix("lab-").map(|name| format!("scripts/{name}"));
            if folder.is_some_and(|folder| !folders.contains(&&*folder)) {
                packages.remove(name);
            }
        }
    }
    let workspace = manifest["workspace"].as_table_mut().context("Cargo.toml has no workspace")?;
    if let Some(members) = workspace.get("default-members").and_then(Item::as_array) {
        let kept =
            members.iter().filter_map(Value::as_str).filter(|member| folders.contains(member));
        workspace["default-members"] = value(Array::from_iter(kept.map(String::from)));
    }
    // Cargo reports an error for a pattern without a match.
    if let Some(members) = workspace.get("members").and_then(Item::as_array) {
        let kept = members.iter().filter_map(Value::as_str);
        let kept = kept.filter(|member| match member.strip_suffix('*') {
            Some(prefix) => folders.iter().any(|folder| folder.starts_with(prefix)),
            None => folders.contains(member),
        });
        workspace["members"] = value(Array::from_iter(kept.map(String::from)));
    }
    without_lost_paths(workspace.get_mut("dependencies"), &folders);
    let patches = manifest.get_mut("patch").and_then(|patches| patches.get_mut("crates-io"));
    if without_lost_paths(patches, &folders) {
        manifest.remove("patch");
    }
    Ok(manifest.to_string())
}

/// Returns the manifest in which the solutions of these labs are the student's own labs.
///
/// Code that uses `solution1` then uses the package `lab1`.
pub(super) fn with_own_labs(text: &str, labs: &[Lab]) -> Result<String> {
    let mut manifest: DocumentMut = text.parse().context("Cargo.toml")?;
    for lab in labs {
        let mut own = InlineTable::new();
        own.insert("path", format!("labs/lab{lab}").into());
        own.insert("package", format!("lab{lab}").into());
        manifest["workspace"]["dependencies"][&format!("solution{lab}")] = value(own);
    }
    Ok(manifest.to_string())
}

/// Removes from a table the packages whose paths are not among `folders`. Returns whether the table
/// is empty then.
fn without_lost_paths(table: Option<&mut Item>, folders: &[&str]) -> bool {
    let Some(table) = table.and_then(Item::as_table_like_mut) else { return false };
    let mut gone = Vec::new();
    for (name, item) in table.iter() {
        let path = item.get("path").and_then(Item::as_str);
        if path.is_some_and(|path| !folders.contains(&path)) {
            gone.push(name.to_owned());
        }
    }
    gone.iter().for_each(|name| drop(table.remove(name)));
    table.is_empty()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::fit;

    const WHOLE: &str = "\
[workspace]
members = [\"labs/lab*\", \"solutions/*\", \"scripts/kit\", \"scripts/grading\"]
default-members = [\"labs/common\", \"solutions/lab1\", \"solutions/lab2\"]

[workspace.dependencies]
common = { path = \"labs/common\" }
solution1 = { path = \"solutions/lab1\" }
solution2 = { path = \"solutions/lab2\" }

serde = \"1\"

# Why it is patched.
[patch.crates-io]
mpi-sys = { path = \"labs/common-mpi/sys\" }

[profile.dev.package.lab-grading]
opt-level = 0

[profile.dev.package.lab-kit]
opt-level = 0
";

    /// Returns the manifest without the packages in these folders.
    fn without(gone: &[&str]) -> String {
        let all = [
            "labs/common",
            "labs/common-mpi/sys",
            "labs/lab1",
            "solutions/lab1",
            "solutions/lab2",
            "scripts/kit",
            "scripts/grading",
        ];
        let manifests = all.iter().filter(|folder| !gone.contains(*folder));
        let manifests: Vec<_> =
            manifests.map(|folder| Path::new(folder).join("Cargo.toml")).collect();
        fit(WHOLE, manifests.iter().map(|path| &**path)).unwrap()
    }

    #[test]
    fn what_is_not_there_is_not_named() {
        let fitted = without(&["solutions/lab2", "scripts/grading", "labs/common-mpi/sys"]);
        assert!(fitted.contains("default-members = [\"labs/common\", \"solutions/lab1\"]"));
        assert!(fitted.contains("members = [\"labs/lab*\", \"solutions/*\", \"scripts/kit\"]"));
        assert!(fitted.contains("package.lab-kit]") && !fitted.contains("grading"), "{fitted}");
        assert!(fitted.contains("solution1 =") && !fitted.contains("solution2"), "{fitted}");
        assert!(fitted.contains("serde = \"1\"") && !fitted.contains("patch"), "{fitted}");
    }

    #[test]
    fn what_is_there_stays() {
        assert_eq!(without(&[]), WHOLE);
    }

    #[test]
    fn a_pattern_without_a_package_goes() {
        let fitted = without(&["solutions/lab1", "solutions/lab2"]);
        assert!(!fitted.contains("solution"), "{fitted}");
        let fitted = without(&["labs/lab1"]);
        assert!(fitted.contains("members = [\"solutions/*\""), "{fitted}");
    }
}
