//! Makes the starter of a lab from its solution.

use std::collections::BTreeMap;
use std::io::Write;
use std::iter;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail};

use super::GIVEN;
use crate::answers::{self, Part, Region};
use crate::files::{read_bytes, read_text, read_toml_at, sources_below, with_unix_lines};
use crate::kit::Kit;
use crate::lab::Lab;

/// Files of a starter, by their path in its folder.
pub type Files = BTreeMap<PathBuf, Vec<u8>>;

/// Reads the [sources](sources_below) below a folder, with Unix line endings; empty if there is no
/// such folder.
pub fn read_below(folder: &Path) -> Result<Files> {
    read(folder, &sources_below(folder)?)
}

/// Reads the files of a starter that a student may change, with Unix line endings.
///
/// These are the files in src/ and tests/, and the manifest.
pub fn own_files(folder: &Path) -> Result<Files> {
    let mut paths = sources_below(&folder.join("src"))?;
    paths.extend(sources_below(&folder.join("tests"))?);
    paths.extend(Some(folder.join("Cargo.toml")).filter(|path| path.is_file()));
    read(folder, &paths)
}

fn read(folder: &Path, paths: &[PathBuf]) -> Result<Files> {
    let mut files = Files::new();
    for path in paths {
        files.insert(path.strip_prefix(folder)?.to_owned(), with_unix_lines(read_bytes(path)?));
    }
    Ok(files)
}

/// Returns the starter as it was given: the copy in the kit, or else a new one from the solution.
pub fn given(kit: &Kit, lab: Lab) -> Result<Files> {
    let kept = kit.starter(lab).join(GIVEN);
    if kept.is_dir() {
        return read_below(&kept);
    }
    kit.chosen_solutions(Some(lab))?;
    generate(kit, lab)
}

/// Makes the starter of `lab`, in memory.
pub fn generate(kit: &Kit, lab: Lab) -> Result<Files> {
    let folder = kit.solution(lab);
    let mut files = Files::new();
    for file in answers::read_solution(kit, lab)? {
        if file.is_shader() {
            let text = without_anchors(&starter_text(&file.parts, shader_todo));
            files.insert(file.path, text.into_bytes());
            continue;
        }
        let mut text = rename(&without_anchors(&starter_text(&file.parts, rust_todo)), lab);
        if file.path == Path::new("src/lib.rs") {
            text = documented(&text);
        }
        let text = formatted(kit, &text).with_context(|| {
            format!("the starter of solutions/lab{lab}/{}", file.path.display())
        })?;
        files.insert(file.path, text);
    }
    // Files other than Rust sources and shaders are copied unchanged.
    for (path, bytes) in read_below(&folder.join("src"))? {
        files.entry(Path::new("src").join(path)).or_insert(bytes);
    }
    let manifest = manifest(kit, lab).with_context(|| format!("solutions/lab{lab}/Cargo.toml"))?;
    files.insert("Cargo.toml".into(), manifest.into_bytes());
    // An editor's analysis loads no files outside a package, so the tests are copied into the
    // package. The crate's documentation is added to the root file, because a solution includes
    // that file, and an included file cannot have crate documentation.
    files.extend(read(kit.root(), &kit.test_sources(lab)?)?);
    if let Some(bytes) = files.get_mut(Path::new(&format!("tests/lab{lab}.rs"))) {
        bytes.splice(..0, format!("//! Lab {lab}'s graders.\n\n").into_bytes());
    }
    Ok(files)
}

fn rust_todo(region: &Region) -> String {
    let end = if region.tail { "" } else { ";" };
    format!("todo!(\"task {}: {}\"){end}\n", region.id, region.title)
}

/// Returns the todo of a shader. WGSL has no `todo!`, so it is a comment that the lab refuses to
/// compile.
fn shader_todo(region: &Region) -> String {
    format!("    // todo: task {}: {}\n", region.id, region.title)
}

/// Returns the file with a todo instead of every answer.
fn starter_text(parts: &[Part], todo: fn(&Region) -> String) -> String {
    let mut text = String::new();
    for part in parts {
        match part {
            Part::Given(given) => text.push_str(given),
            Part::AnswerOnly(_) => {}
            Part::Answer(region) => text.push_str(&todo(region)),
        }
    }
    text
}

/// Removes the book's anchors, which mean nothing to a student.
fn without_anchors(text: &str) -> String {
    text.split_inclusive('\n').filter(|line| !is_anchor(line)).collect()
}

fn is_anchor(line: &str) -> bool {
    line.trim().strip_prefix("//").is_some_and(|comment| comment.trim().starts_with("ANCHOR"))
}

/// Replaces the crate's documentation by the lab's README.
fn documented(text: &str) -> String {
    let rest = text.split_inclusive('\n').skip_while(|line| line.starts_with("//!"));
    iter::once("#![doc = include_str!(\"../README.md\")]\n").chain(rest).collect()
}

/// Replaces the name of the solution's crate by the name of the starter's crate.
pub(crate) fn rename(text: &str, lab: Lab) -> String {
    let old = format!("solution{lab}");
    let new = format!("lab{lab}");
    let mut renamed = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(&old) {
        let before = &rest[..at];
        let after = &rest[at + old.len()..];
        let is_full_name = !before.ends_with(is_name) && !after.starts_with(is_name);
        renamed.push_str(before);
        renamed.push_str(if is_full_name { &new } else { &old });
        rest = after;
    }
    renamed + rest
}

fn is_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Formats a single file through a pipe. With a path, rustfmt would format its modules too.
fn formatted(kit: &Kit, text: &str) -> Result<Vec<u8>> {
    let mut rustfmt = Command::new("rustfmt")
        .args(["--edition", "2024"])
        .current_dir(kit.root())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .context("rustfmt did not start")?;
    // rustfmt reads everything before it writes, so this cannot block.
    rustfmt.stdin.take().context("rustfmt has no input")?.write_all(text.as_bytes())?;
    let output = rustfmt.wait_with_output()?;
    if !output.status.success() {
        bail!("rustfmt refuses it: {}", String::from_utf8_lossy(&output.stderr).trim());
    }
    Ok(output.stdout)
}

/// Makes the starter's manifest from the solution's, with the workspace's lints written out.
///
/// The lints about unused code are off, because next to a `todo!` everything is unused. The lines
/// below the lints belong to the solution only.
fn manifest(kit: &Kit, lab: Lab) -> Result<String> {
    let text = read_text(&kit.solution(lab).join("Cargo.toml"))?;
    let text = rename(&text, lab).replacen(": the solution\"", ": your work\"", 1);
    let (before, _) =
        text.split_once("\n[lints]\nworkspace = true").context("no workspace's lints")?;
    // Levels of lints, by group and name.
    let lints = read_toml_at(&kit.path("Cargo.toml"), "/workspace/lints")?;
    let mut lints: BTreeMap<String, BTreeMap<String, String>> = lints.unwrap_or_default();
    lints.entry("rust".into()).or_default();
    let mut text = before.to_owned();
    for (group, lints) in lints {
        text += &format!("\n[lints.{group}]\n");
        text.extend(lints.iter().map(|(lint, level)| format!("{lint} = \"{level}\"\n")));
        if group == "rust" {
            text += "unused = { level = \"allow\", priority = -1 }\n";
        }
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{documented, rename, rust_todo, shader_todo, starter_text, without_anchors};
    use crate::answers::parse;

    #[test]
    fn answers_become_todos() {
        let text = "\
// ANCHOR: f
fn f() -> u8 {
    // task 1.2: the answer
    helper()
    // end 1.2
}
// ANCHOR_END: f
// answer only
fn helper() -> u8 {
    42
}
// end answer only
fn g() {
    // task 1.3: more
    work();
    // end 1.3
    done();
}
";
        let marked = parse(Path::new("x.rs"), text).unwrap();
        let starter = "\
fn f() -> u8 {
todo!(\"task 1.2: the answer\")
}
fn g() {
todo!(\"task 1.3: more\");
    done();
}
";
        assert_eq!(without_anchors(&starter_text(&marked, rust_todo)), starter);
    }

    #[test]
    fn answers_in_a_shader_become_comments() {
        let text = "fn f() -> u32 {\n    // task 9.2: a value\n    return 1u;\n    // end 9.2\n}\n";
        let marked = parse(Path::new("x.wgsl"), text).unwrap();
        let starter = "fn f() -> u32 {\n    // todo: task 9.2: a value\n}\n";
        assert_eq!(starter_text(&marked, shader_todo), starter);
    }

    #[test]
    fn a_readme_documents_the_crate() {
        let text = "//! Lab 1: the solution.\n//! More.\n\n//! mod a;\n";
        let starter = "#![doc = include_str!(\"../README.md\")]\n\n//! mod a;\n";
        assert_eq!(documented(text), starter);
    }

    #[test]
    fn only_the_own_crate_is_renamed() {
        let lab = "1".parse().unwrap();
        let text = "use solution1::X; use solution10::Y; my_solution1(); (solution1)";
        assert_eq!(rename(text, lab), "use lab1::X; use solution10::Y; my_solution1(); (lab1)");
    }
}
