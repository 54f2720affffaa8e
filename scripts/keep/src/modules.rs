//! `cargo lab modules`: do modules import each other?

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::Result;
use clap::Args;
use lab_kit::files::read_text;
use lab_kit::{Kit, files_below};

/// Look for modules that import each other in a circle (for those who maintain the kit)
///
/// Of two modules with the same parent, what one imports counts with all that lies below it. What a
/// module takes from those around it is no circle: a room's own front may hold what all its files need.
#[derive(Args)]
pub struct Options {
    /// Folders of packages, such as scripts/kit
    #[arg(required = true, value_name = "FOLDER")]
    folders: Vec<PathBuf>,
}

/// Names every circle.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let mut all_well = true;
    for folder in options.folders {
        for circle in circles(&imports(&kit.path(&folder).join("src"))?) {
            println!("{}: {} import each other", folder.display(), circle.join(", "));
            all_well = false;
        }
    }
    Ok(if all_well { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// A module by the names on its path.
type Module = Vec<String>;

/// Which modules import from which, each pair lifted to where their paths part.
type Imports = BTreeMap<Module, BTreeSet<Module>>;

fn imports(src: &Path) -> Result<Imports> {
    let mut texts: BTreeMap<Module, String> = BTreeMap::new();
    for path in files_below(src)?.into_iter().filter(|path| path.extension() == Some("rs".as_ref()))
    {
        let text = read_text(&path)?;
        let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
        let inner = path.strip_prefix(src)?.with_extension("");
        let mut module: Module = inner.iter().map(|part| part.to_string_lossy().into()).collect();
        if ["mod", "lib", "main"].contains(&module.last().map_or("", |name| name)) {
            module.pop();
        }
        texts.entry(module).or_default().push_str(code);
    }
    let mut imports = Imports::new();
    for (module, text) in &texts {
        for path in paths(module, text) {
            let known = (0..=path.len()).rev().map(|end| &path[..end]);
            let target = known.into_iter().find(|path| texts.contains_key(*path)).unwrap_or(&[]);
            let shared = module.iter().zip(target).take_while(|(a, b)| a == b).count();
            if shared < module.len() && shared < target.len() {
                let (from, to) = (module[..=shared].to_vec(), target[..=shared].to_vec());
                imports.entry(from).or_default().insert(to);
            }
        }
    }
    Ok(imports)
}

/// The paths from the crate's root that a module's text names with `crate::` or `super::`.
fn paths(module: &Module, text: &str) -> Vec<Module> {
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let text: String = lines.flat_map(|line| [line, "\n"]).collect();
    let mut paths = Vec::new();
    for (start, base) in [("crate::", 0), ("super::", module.len().saturating_sub(1))] {
        for (at, _) in text.match_indices(start) {
            let (mut base, mut rest) = (base, &text[at + start.len()..]);
            while let Some(further) = rest.strip_prefix("super::") {
                (base, rest) = (base.saturating_sub(1), further);
            }
            // `super::super::` is met a second time at its second word.
            if !text[..at].ends_with("super::") {
                expand(&module[..base], rest, &mut paths);
            }
        }
    }
    paths
}

/// Adds `base` with what follows it: `a::b`, or each of `{a::b, c}`.
fn expand(base: &[String], rest: &str, paths: &mut Vec<Module>) {
    let Some(group) = rest.strip_prefix('{') else {
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        let path = [base, &[rest[..end].to_owned()]].concat();
        match rest[end..].strip_prefix("::") {
            Some(further) => expand(&path, further, paths),
            None => paths.push(path),
        }
        return;
    };
    let (mut depth, mut from) = (0, 0);
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth > 0 => depth -= 1,
            ',' | '}' if depth == 0 => {
                expand(base, group[from..at].trim(), paths);
                from = at + 1;
                if c == '}' {
                    return;
                }
            }
            _ => {}
        }
    }
}

/// The modules of each circle, by their paths; each circle once.
fn circles(imports: &Imports) -> BTreeSet<Vec<String>> {
    let reached = |from: &Module| {
        let mut reached = BTreeSet::new();
        let mut next: Vec<&Module> = imports.get(from).into_iter().flatten().collect();
        while let Some(module) = next.pop() {
            if reached.insert(module) {
                next.extend(imports.get(module).into_iter().flatten());
            }
        }
        reached
    };
    let all: BTreeMap<&Module, BTreeSet<&Module>> =
        imports.keys().map(|module| (module, reached(module))).collect();
    let circle = |(module, reached): (&&Module, &BTreeSet<&Module>)| {
        let back = |other: &&&Module| all.get(**other).is_some_and(|them| them.contains(module));
        reached.contains(module).then(|| {
            reached.iter().filter(back).map(|module| module.join("::")).collect::<Vec<_>>()
        })
    };
    all.iter().filter_map(circle).collect()
}

#[cfg(test)]
mod tests {
    use lab_kit::files::write_file;

    use super::{circles, imports};

    #[test]
    fn a_circle_is_found_and_a_line_is_none() {
        let folder = tempfile::tempdir().unwrap();
        let put = |path: &str, text: &str| write_file(&folder.path().join(path), text).unwrap();
        put("lib.rs", "mod a; mod b;");
        put("a/mod.rs", "mod deep; pub struct Front;");
        put("a/deep.rs", "use super::Front;\nuse crate::{c::C, b::{self, B}};");
        put("b.rs", "// crate::a\npub struct B;");
        assert!(circles(&imports(folder.path()).unwrap()).is_empty());
        put("b.rs", "use super::a::Front;");
        let found = circles(&imports(folder.path()).unwrap());
        assert_eq!(found.into_iter().collect::<Vec<_>>(), [["a", "b"]]);
    }
}
