//! Sources of submissions: the solution of a lab, with additions or replacements.

use std::collections::BTreeMap;
use std::path::Path;

use lab_kit::sources::of_solution;
use lab_kit::starter::generate;
use lab_kit::{Kit, Lab, rubric, wrong};

/// Texts by their path in the lab's folder.
pub(crate) type Files = BTreeMap<String, String>;

/// Returns the path of the tested kit.
pub(crate) fn kit() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("scripts/ is in the kit")
}

fn number(lab: u8) -> Lab {
    lab.to_string().parse().expect("labs are counted from 1")
}

fn texts(files: impl IntoIterator<Item = (String, Vec<u8>)>) -> Files {
    files.into_iter().map(|(path, bytes)| (path, String::from_utf8(bytes).unwrap())).collect()
}

/// Returns the sources of the solution, under the lab's own name.
pub(crate) fn solution(lab: u8) -> Files {
    texts(of_solution(&Kit::at(kit()), number(lab)).unwrap())
}

/// Returns the starter that students get, independently of this kit's folder labs/.
pub(crate) fn starter(lab: u8) -> Files {
    let given = generate(&Kit::at(kit()), number(lab)).unwrap().into_iter();
    let given = given.filter(|(path, _)| path.starts_with("src"));
    texts(given.map(|(path, bytes)| (path.to_str().unwrap().to_owned(), bytes)))
}

/// Returns the lab's tasks.
pub(crate) fn tasks(lab: u8) -> Vec<String> {
    rubric::read(&Kit::at(kit()), number(lab)).unwrap().tasks.into_keys().collect()
}

/// Returns the solution with code before the answers of some tasks.
pub(crate) fn with(lab: u8, code: &[(&str, &str)]) -> Files {
    let mut files = solution(lab);
    for (task, code) in code {
        let mark = format!("// task {task}: ");
        let file = files.values_mut().find(|text| text.contains(&mark));
        let file = file.unwrap_or_else(|| panic!("nowhere is '{mark}'"));
        let begin = file.find(&mark).expect("it is in there");
        file.insert_str(begin, &format!("#[allow(unreachable_code)]\n{{\n{code}\n}}\n"));
    }
    files
}

/// Returns a known-wrong solution, and the tasks that it must lose.
pub(crate) fn wrong(lab: u8, name: &str) -> (Files, Vec<String>) {
    let all = wrong::read(&Kit::at(kit()), number(lab)).unwrap();
    let wrong = all.into_iter().find(|wrong| wrong.name == name).expect(name);
    let files = texts(wrong.in_solution(&Kit::at(kit()), number(lab)).unwrap());
    let lost = [wrong.region.task].into_iter().chain(wrong.loses).map(|task| task.to_string());
    (files, lost.collect())
}
