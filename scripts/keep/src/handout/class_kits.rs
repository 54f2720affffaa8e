use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use super::repository::commit;
use super::{Earlier, Laid, lay};
use lab_kit::answers::{self, Part};
use lab_kit::starter::{Record, generate};
use lab_kit::{Kit, Lab, files_below};

fn lab(number: &str) -> Lab {
    number.parse().unwrap()
}

/// Returns a class's tree with these labs, each in one commit.
fn handout(labs: &[&str]) -> (tempfile::TempDir, Kit) {
    let folder = tempfile::tempdir().unwrap();
    labs.iter().for_each(|lab| drop(add(folder.path(), lab)));
    let kit = Kit::at(folder.path());
    (folder, kit)
}

fn add(folder: &Path, number: &str) -> Laid {
    let laid = lay(&Kit::find().unwrap(), lab(number), folder, Earlier::Solutions).unwrap();
    commit(folder, number, &laid.changed).unwrap();
    laid
}

fn git(folder: &Path, arguments: &[&str]) -> String {
    let output = Command::new("git").current_dir(folder).args(arguments).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
fn the_labs_that_were_added_and_the_solutions_that_they_build_on() {
    let (folder, kit) = handout(&["1", "3"]);
    assert_eq!(kit.starters(), [lab("1"), lab("3")]);
    assert_eq!(kit.solutions(), [lab("1"), lab("2")], "lab 3 builds on both");
    for (path, there) in [
        ("tests/lab3.rs", true),
        ("tests/lab2.rs", false),
        ("tests/lab4.rs", false),
        ("tests/wrong", false),
        ("labs/common-mpi", false),
        ("labs/lab3/README.md", true),
        ("labs/lab3/lab.toml", true),
        ("book/src/lab3.md", true),
        ("book/src/instructor", false),
        ("scripts/student/src/main.rs", true),
        ("scripts/grading", false),
        (".cargo/config.toml", true),
        (".vscode/tasks.json", true),
        (".devcontainer/devcontainer.json", true),
        ("README.md", true),
        ("AGENTS.md", true),
    ] {
        assert_eq!(kit.path(path).exists(), there, "{path}");
    }
    let later = fs::read_to_string(kit.path("book/src/lab4.md")).unwrap();
    assert_eq!(later.lines().count(), 3, "a title, and that it is not here: {later}");
    for lab in kit.starters() {
        let record = Record::read(&kit.starter(lab)).unwrap();
        assert_eq!(record, Record::of(&generate(&Kit::find().unwrap(), lab).unwrap()));
        assert!(record.paths().all(|path| record.is_own(&kit.starter(lab), path)));
    }
    add(folder.path(), "4");
    let quizzes = ["3", "4"].map(|number| {
        let chapter = fs::read_to_string(kit.path(format!("book/src/lab{number}.md"))).unwrap();
        chapter.matches("class=\"quiz\"").count()
    });
    assert_eq!(quizzes, [2, 0], "they show much of an answer, and come with the next lab");
}

#[test]
fn a_lab_is_one_commit_and_work_in_the_labs_before_it_stays() {
    let (folder, kit) = handout(&["1"]);
    assert!(kit.solutions().is_empty(), "the first lab is given no solution");
    let work = kit.path("labs/lab1/src/force.rs");
    fs::write(&work, "mine").unwrap();
    fs::write(kit.path("notes.txt"), "mine").unwrap();
    let laid = add(folder.path(), "2");
    assert_eq!(laid.edited, [Path::new("labs/lab1/src/force.rs")]);
    assert_eq!(fs::read_to_string(&work).unwrap(), "mine");
    assert_eq!(git(folder.path(), &["log", "--format=%s"]), "2\n1\n");
    let left = git(folder.path(), &["status", "--porcelain"]);
    assert_eq!(left, " M labs/lab1/src/force.rs\n?? notes.txt\n", "what is mine, I commit");
    assert!(add(folder.path(), "2").changed.is_empty(), "there is nothing new");
    let error = lay(&Kit::find().unwrap(), lab("1"), folder.path(), Earlier::Solutions);
    let error = error.err().unwrap();
    assert_eq!(error.to_string(), "lab 2 is there already, and may show the answers of lab 1");
}

#[test]
fn a_student_pulls_a_lab_beside_their_work() {
    let (folder, _) = handout(&["1"]);
    let student = tempfile::tempdir().unwrap();
    git(student.path(), &["clone", "--quiet", folder.path().to_str().unwrap(), "mine"]);
    let mine = student.path().join("mine");
    let work = mine.join("labs/lab1/src/force.rs");
    fs::write(&work, "mine").unwrap();
    let me = ["-c", "user.name=me", "-c", "user.email=me@localhost"];
    git(&mine, &[&me[..], &["commit", "--quiet", "--all", "--message", "work"]].concat());
    add(folder.path(), "2");
    git(&mine, &[&me[..], &["pull", "--quiet", "--no-rebase", "--no-edit"]].concat());
    assert_eq!(fs::read_to_string(&work).unwrap(), "mine");
    assert!(mine.join("labs/lab2/src/lib.rs").is_file());
}

#[test]
fn a_lab_builds_on_the_students_own_labs_while_late_days_last() {
    let (folder, kit) = handout(&["1"]);
    let whole = Kit::find().unwrap();
    lay(&whole, lab("2"), folder.path(), Earlier::Own).unwrap();
    assert!(kit.solutions().is_empty(), "lab 1 may still be handed in");
    let manifest = fs::read_to_string(kit.path("Cargo.toml")).unwrap();
    assert!(manifest.contains(r#"solution1 = { path = "labs/lab1", package = "lab1" }"#));
    let cargo = kit.cargo().args(["tree", "--locked", "--offline", "-p", "lab2"]).output().unwrap();
    let tree = String::from_utf8_lossy(&cargo.stdout);
    assert!(tree.contains("lab1 v"), "{tree}{}", String::from_utf8_lossy(&cargo.stderr));
    lay(&whole, lab("2"), folder.path(), Earlier::Solutions).unwrap();
    assert_eq!(kit.solutions(), [lab("1")]);
}

/// Returns the lines of a text that are long enough that equal lines must be copies.
///
/// Shorter lines, such as `let result = work();`, are written twice without being copied.
fn lines(text: &str) -> impl Iterator<Item = &str> {
    text.lines().map(str::trim).filter(|line| line.len() >= LONG && !line.starts_with("//"))
}

const LONG: usize = 30;

/// No line of the answers to lab 3 and later labs may be in the tree of labs 1 to 3, its book or
/// its history.
///
/// Lines that some given file or an earlier answer contains do not count.
#[test]
fn no_line_of_an_answer_is_in_a_class_s_tree() {
    let whole = Kit::find().unwrap();
    let mut public = String::new();
    let mut answers = BTreeSet::new();
    for number in whole.solutions() {
        let due = number < lab("3");
        for file in answers::read_solution(&whole, number).unwrap() {
            for part in file.parts {
                if due || matches!(part, Part::Given(_)) {
                    public += part.text();
                } else {
                    answers.extend(lines(part.text()).map(String::from));
                }
            }
        }
    }
    let public: BTreeSet<&str> = lines(&public).collect();
    answers.retain(|line| !public.contains(&**line));
    assert!(answers.len() > 500, "{} lines", answers.len());

    let (folder, kit) = handout(&["1", "2", "3"]);
    let history = git(folder.path(), &["log", "--patch", "--format=%B", "--no-prefix"]);
    let mut found = Vec::new();
    let mut texts = vec![("history".to_owned(), history)];
    for path in files_below(kit.root()).unwrap() {
        let path = path.strip_prefix(kit.root()).unwrap();
        if !path.starts_with(".git") {
            let bytes = fs::read(kit.path(path)).unwrap();
            let text = String::from_utf8_lossy(&bytes).into_owned();
            texts.push((path.display().to_string(), text));
        }
    }
    for (path, text) in &texts {
        for line in text.lines().map(str::trim) {
            if answers.contains(line.trim_start_matches(['+', '-']).trim()) {
                found.push(format!("{path}: {line}"));
            }
        }
    }
    assert!(found.is_empty(), "{} lines: {found:#?}", found.len());
}

#[test]
fn its_lock_file_is_what_cargo_would_write() {
    let (_folder, kit) = handout(&["2"]);
    let mut cargo = kit.cargo();
    let output = cargo.args(["tree", "--locked", "--offline", "-p", "lab2"]).output().unwrap();
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{complaint}");
    let packages = fs::read_to_string(kit.path("Cargo.lock")).unwrap();
    assert!(packages.contains("\"solution1\"") && !packages.contains("\"solution2\""));
}

#[test]
fn no_page_leads_to_one_that_is_left_out() {
    let (_folder, kit) = handout(&["5"]);
    for page in files_below(&kit.path("book/src")).unwrap() {
        let Ok(text) = fs::read_to_string(&page) else { continue };
        if page.extension().is_none_or(|extension| extension != "md") {
            continue;
        }
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let target = link.split('#').next().unwrap_or_default();
            if target.ends_with(".md") && !target.contains("://") {
                let there = page.parent().unwrap().join(target).is_file();
                assert!(there, "{}: {link}", page.display());
            }
        }
        assert!(!text.contains("solutions/lab5/"), "{}", page.display());
    }
}

#[test]
fn a_folder_with_something_in_it_is_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("mine"), "mine").unwrap();
    let error =
        lay(&Kit::find().unwrap(), lab("1"), folder.path(), Earlier::Solutions).err().unwrap();
    assert!(error.to_string().contains("no class's kit"), "{error}");
    assert_eq!(files_below(folder.path()).unwrap().len(), 1);
}
