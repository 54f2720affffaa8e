//! What submissions are made of: the solution of a lab, with something added or replaced.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use lab_kit::starter::generate;
use lab_kit::{Kit, Lab, rubric, submission, wrong};

/// Texts by their path in the lab's folder.
pub(crate) type Files = BTreeMap<String, String>;

/// The kit that is tested.
pub(crate) fn kit() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("scripts/ is in the kit")
}

fn number(lab: u8) -> Lab {
    lab.to_string().parse().expect("labs are counted from 1")
}

/// The sources of the solution, under the lab's own name.
pub(crate) fn solution(lab: u8) -> Files {
    let collected = submission::collect(&Kit::at(kit()).solution(number(lab))).unwrap();
    let (from, to) = (format!("solution{lab}::"), format!("lab{lab}::"));
    let text = |bytes| String::from_utf8(bytes).unwrap().replace(&from, &to);
    collected.files.into_iter().map(|(path, bytes)| (path, text(bytes))).collect()
}

/// The lab as students get it, whatever a student has made of labs/ here.
pub(crate) fn starter(lab: u8) -> Files {
    let given = generate(&Kit::at(kit()), number(lab)).unwrap().into_iter();
    let text = |(path, bytes): (PathBuf, _)| {
        (path.to_str().unwrap().to_owned(), String::from_utf8(bytes).unwrap())
    };
    given.filter(|(path, _)| path.starts_with("src")).map(text).collect()
}

/// The lab's tasks, in the order of the record.
pub(crate) fn tasks(lab: u8) -> Vec<String> {
    rubric::read(&Kit::at(kit()), number(lab)).unwrap().tasks.into_keys().collect()
}

/// The solution with code before the answers of some tasks.
pub(crate) fn with(lab: u8, code: &[(&str, &str)]) -> Files {
    let mut files = solution(lab);
    for (task, code) in code {
        let (file, begin) = place(&mut files, &format!("// task {task}: "));
        file.insert_str(begin, &format!("#[allow(unreachable_code)]\n{{\n{code}\n}}\n"));
    }
    files
}

/// A known-wrong solution, and the tasks that it must lose.
pub(crate) fn wrong(lab: u8, name: &str) -> (Files, Vec<String>) {
    let all = wrong::read(&Kit::at(kit()), number(lab)).unwrap();
    let wrong = all.into_iter().find(|wrong| wrong.name == name).expect(name);
    let lost = [wrong.region.task].into_iter().chain(wrong.loses).map(|task| task.to_string());
    let mut files = solution(lab);
    let region = wrong.region;
    let (file, begin) = place(&mut files, &format!("// task {region}: "));
    let end = file.find(&format!("// end {region}\n")).expect("a region ends");
    file.replace_range(begin..end, &wrong.body);
    (files, lost.collect())
}

/// Where a text stands.
fn place<'f>(files: &'f mut Files, mark: &str) -> (&'f mut String, usize) {
    let file = files.values_mut().find(|text| text.contains(mark));
    let file = file.unwrap_or_else(|| panic!("nowhere is '{mark}'"));
    let begin = file.find(mark).expect("it is in there");
    (file, begin)
}
