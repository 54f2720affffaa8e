//! Tests that no sibling modules import one another in a circle.
//!
//! A folder counts as one module with all files in it. A name that `mod.rs` or `lib.rs` re-exports
//! counts as a name of the module that defines it. So a circle through `lib.rs` is found.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Paths that each module of a package mentions. The names of modules are `crate`, `crate::a`,
/// `crate::a::b`.
type Package = BTreeMap<String, Vec<String>>;

#[test]
fn modules_import_one_another_in_no_circle() {
    let kit = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut found = BTreeMap::new();
    for part in ["labs", "solutions", "scripts", "tests"] {
        look_for_packages(&kit, part, &mut found);
    }
    found.retain(|_, circles| !circles.is_empty());
    assert!(found.is_empty(), "modules that import one another in a circle: {found:#?}");
}

fn look_for_packages(kit: &Path, folder: &str, found: &mut BTreeMap<String, BTreeSet<String>>) {
    let Ok(entries) = kit.join(folder).read_dir() else { return };
    for entry in entries.flatten().filter(|entry| entry.path().is_dir()) {
        look_for_packages(kit, &format!("{folder}/{}", entry.file_name().display()), found);
    }
    if kit.join(folder).join("Cargo.toml").exists() {
        let mut package = Package::new();
        read(&kit.join(folder).join("src"), "crate", &mut package);
        found.insert(folder.to_owned(), circles(&package));
    }
}

/// Reads the modules in `folder`, which is module `here`.
fn read(folder: &Path, here: &str, package: &mut Package) {
    let Ok(entries) = folder.read_dir() else { return };
    for path in entries.flatten().map(|entry| entry.path()) {
        let name = path.file_stem().unwrap_or_default().display();
        let module = match name.to_string().as_str() {
            "mod" | "lib" | "main" => here.to_owned(),
            name => format!("{here}::{name}"),
        };
        if path.is_dir() {
            read(&path, &module, package);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = std::fs::read_to_string(&path).expect("a source file");
            package.entry(module).or_default().extend(mentioned(&text));
        }
    }
}

/// Returns the paths after `use`, and others that begin with `crate` or `super`.
fn mentioned(text: &str) -> Vec<String> {
    // Unit tests may use anything.
    let lines = text.lines().take_while(|line| !line.starts_with("#[cfg(test)]"));
    let code: String = lines.filter_map(|line| line.split("//").next()).collect();
    let words = code.split(|c: char| !c.is_alphanumeric() && c != '_' && c != ':');
    let others = words.filter(|word| word.starts_with("crate::") || word.starts_with("super::"));
    let uses = code.split("use ").skip(1).filter_map(|rest| rest.split(';').next());
    uses.flat_map(expanded).chain(others.map(str::to_owned)).collect()
}

/// Expands `a::{b, c::d}` to `a::b` and `a::c::d`.
fn expanded(tree: &str) -> Vec<String> {
    let mut tree = tree.replace(' ', "");
    while let Some(end) = tree.find('}') {
        let Some(start) = tree[..end].rfind('{') else { break };
        let from = tree[..start].rfind([',', '{']).map_or(0, |at| at + 1);
        let items = tree[start + 1..end].split(',').filter(|item| !item.is_empty());
        let paths: Vec<_> = items.map(|item| tree[from..start].to_owned() + item).collect();
        tree.replace_range(from..=end, &paths.join(","));
    }
    tree.split(',').map(str::to_owned).collect()
}

/// Finds the module of this package that defines `path`, as seen from `module`.
fn target<'p>(package: &'p Package, module: &str, path: &str) -> Option<&'p str> {
    if let Some(rest) = path.strip_prefix("super::") {
        return target(package, module, &format!("{}::{rest}", module.rsplit_once("::")?.0));
    }
    let first = path.split("::").next()?;
    let is_below = package.contains_key(&format!("{module}::{first}"));
    let path = if is_below { format!("{module}::{path}") } else { path.to_owned() };
    let mut name = "";
    let mut at = path.as_str();
    while !package.contains_key(at) {
        (at, name) = at.rsplit_once("::")?;
    }
    // The module defines the name itself, or re-exports it from a child module.
    let (module, paths) = package.get_key_value(at)?;
    let mut so_called = paths.iter().filter(|path| path.ends_with(&format!("::{name}")));
    let below = so_called.find(|path| {
        package.contains_key(&format!("{at}::{}", path.split("::").next().unwrap_or_default()))
    });
    below.map_or(Some(module), |path| target(package, module, path))
}

/// Returns the sibling modules that import one another in circles.
fn circles(package: &Package) -> BTreeSet<String> {
    let mut imports: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (module, paths) in package {
        for other in paths.iter().filter_map(|path| target(package, module, path)) {
            // Both names are cut after the first part in which they differ.
            let a: Vec<_> = module.split("::").collect();
            let b: Vec<_> = other.split("::").collect();
            if let Some(k) = (0..a.len().min(b.len())).find(|&k| a[k] != b[k]) {
                imports.entry(a[..=k].join("::")).or_default().insert(b[..=k].join("::"));
            }
        }
    }
    // A module that imports no remaining module is in no circle. The same holds for a module that
    // no remaining module imports.
    loop {
        let left: BTreeSet<String> = imports.keys().cloned().collect();
        let imported: BTreeSet<String> = imports.values().flatten().cloned().collect();
        imports.retain(|module, others| !others.is_disjoint(&left) && imported.contains(module));
        if imports.len() == left.len() {
            return left;
        }
    }
}
