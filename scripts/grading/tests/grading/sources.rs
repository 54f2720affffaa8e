//! What submissions are made of: the solution of a lab, with something added or replaced.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use lab_kit::Kit;
use lab_kit::starter::generate;

/// Texts by their path in the lab's folder.
pub(crate) type Files = BTreeMap<String, String>;

/// The kit that is tested.
pub(crate) fn kit() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("scripts/ is in the kit")
}

/// The sources of the solution, under the lab's own name.
pub(crate) fn solution(lab: u8) -> Files {
    let mut files = read(&format!("solutions/lab{lab}/src"));
    let (from, to) = (format!("solution{lab}::"), format!("lab{lab}::"));
    files.values_mut().for_each(|text| *text = text.replace(&from, &to));
    files
}

/// The lab as students get it, whatever a student has made of labs/ here.
pub(crate) fn starter(lab: u8) -> Files {
    let lab = lab.to_string().parse().expect("labs are counted from 1");
    let given = generate(&Kit::at(kit()), lab).unwrap().into_iter();
    let text = |(path, bytes): (PathBuf, _)| {
        (path.to_str().unwrap().to_owned(), String::from_utf8(bytes).unwrap())
    };
    given.filter(|(path, _)| path.starts_with("src")).map(text).collect()
}

fn read(folder: &str) -> Files {
    let mut files = Files::new();
    add(&kit().join(folder), "src", &mut files);
    files
}

fn add(folder: &Path, name: &str, files: &mut Files) {
    for entry in fs::read_dir(folder).unwrap().flatten() {
        let path = format!("{name}/{}", entry.file_name().into_string().unwrap());
        if entry.path().is_dir() {
            add(&entry.path(), &path, files);
        } else {
            files.insert(path, fs::read_to_string(entry.path()).unwrap());
        }
    }
}

/// The lab's tasks, in the order of the record.
pub(crate) fn tasks(lab: u8) -> Vec<String> {
    let rubric = fs::read_to_string(kit().join("tests/rubric.toml")).unwrap();
    let head = format!("[lab{lab}.tasks]");
    let lines = rubric.lines().skip_while(|line| *line != head).skip(1);
    let tasks = lines.map_while(|line| line.strip_prefix('"')?.split('"').next());
    let mut tasks: Vec<String> = tasks.map(String::from).collect();
    tasks.sort();
    tasks
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
    let path = kit().join(format!("tests/wrong/lab{lab}/{name}.rs"));
    let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let field = |field: &str| text.lines().find_map(|line| line.strip_prefix(field));
    let region = field("// region: ").expect("it names its region");
    let mut lost = vec![region.trim_end_matches(|c: char| c.is_alphabetic()).to_owned()];
    lost.extend(field("// loses: ").into_iter().flat_map(|ids| ids.split(", ")).map(String::from));
    let mut files = solution(lab);
    let (file, begin) = place(&mut files, &format!("// task {region}: "));
    let end = file.find(&format!("// end {region}\n")).expect("a region ends");
    file.replace_range(begin..end, &text);
    (files, lost)
}

/// Where a text stands.
fn place<'f>(files: &'f mut Files, mark: &str) -> (&'f mut String, usize) {
    let file = files.values_mut().find(|text| text.contains(mark));
    let file = file.unwrap_or_else(|| panic!("nowhere is '{mark}'"));
    let begin = file.find(mark).expect("it is in there");
    (file, begin)
}
