//! The order of a lab's tests: that of their source, which goes from the plain to the intricate.

use std::collections::HashMap;
use std::path::Path;

use anyhow::Result;

use crate::files::read_text;
use crate::kit::Kit;
use crate::lab::Lab;

/// Puts tests, which a test program lists by the alphabet, into the order in which the lab's test source
/// and what it includes has them.
pub fn in_order_of_source(kit: &Kit, lab: Lab, tests: &mut [String]) -> Result<()> {
    let mut names = Vec::new();
    add(&kit.path(format!("tests/lab{lab}.rs")), &mut names)?;
    let indices: HashMap<_, _> = names.iter().enumerate().map(|(at, name)| (name, at)).collect();
    tests.sort_by_key(|test| indices.get(test).copied().unwrap_or(usize::MAX));
    Ok(())
}

/// Adds the names of a source's functions.
fn add(source: &Path, names: &mut Vec<String>) -> Result<()> {
    for line in read_text(source)?.lines() {
        if let Some(included) = line.strip_prefix("include!(\"").and_then(|l| l.split('"').next()) {
            add(&source.with_file_name(included), names)?;
        }
        // Also where it is made by a macro that is told its name.
        if let Some(rest) = line.trim_start().strip_prefix("fn ") {
            names.extend(rest.split(['(', '<', ' ']).next().map(String::from));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::in_order_of_source;
    use crate::kit::Kit;

    #[test]
    fn tests_stand_as_in_their_source() {
        let folder = tempfile::tempdir().unwrap();
        let source = "fn helper<T>() {}\n#[test]\nfn z() {}\ninclude!(\"lab1/more.rs\");\ntests! {\n    fn t = steps;\n}\nfn a() {}\n";
        let included = ("tests/lab1/more.rs", "#[test]\nfn m() {}\n");
        let kit = Kit::of_files(folder.path(), &[("tests/lab1.rs", source), included]);
        let mut tests = ["a", "elsewhere", "m", "t", "z"].map(String::from);
        in_order_of_source(&kit, "1".parse().unwrap(), &mut tests).unwrap();
        assert_eq!(tests, ["z", "m", "t", "a", "elsewhere"]);
    }
}
