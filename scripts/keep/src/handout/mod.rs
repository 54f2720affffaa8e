//! `cargo lab handout`: the kit as students of a lab get it.
//!
//! [`lay`] writes labs 1 to N as starters and the labs before N as given code. Nothing of the
//! solution of lab N or of a later lab is in it, and nothing from `tests/wrong`: whoever builds
//! foreign code in such a tree has nothing there to lose.

mod book;
mod contents;
mod copy;
mod manifest;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result, ensure};
use clap::Args;

use lab_kit::files::write_file;
use lab_kit::{Kit, Lab};
pub(crate) use manifest::fit;

/// Write a kit for students, with the labs up to one (for instructors)
///
/// It has starters of labs 1 to N, solutions of the labs before N as given code, their tests and
/// hints, this command and the book's chapters. It has no solution of lab N or later, no
/// known-wrong solutions and no instructor's pages.
#[derive(Args)]
pub struct Options {
    /// The last lab of the kit, such as 3
    lab: Lab,
    /// The folder to write; it must not be there yet, or be empty
    #[arg(long, value_name = "DIR")]
    into: PathBuf,
}

/// Writes the kit and says what is in it.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let Options { lab, into } = options;
    lay(kit, lab, &into)?;
    let handed = Kit::at(&into);
    let list = |labs: Vec<Lab>| labs.iter().map(Lab::to_string).collect::<Vec<_>>().join(", ");
    println!("{} holds a kit for lab {lab}:", into.display());
    println!("  starters     {}", list(handed.starters()?));
    let solutions = handed.solutions()?;
    if !solutions.is_empty() {
        println!("  given code   the solutions of {}", list(solutions));
    }
    println!("Look at it: cd {} && cargo lab test {lab}", into.display());
    Ok(ExitCode::SUCCESS)
}

/// Writes the kit of `lab` into the folder `into`, which is made if it is not there.
///
/// # Errors
/// There is no such lab, `into` holds something, or a file cannot be read or written. What is to
/// be written is gathered first: a kit that cannot be made leaves nothing behind.
pub fn lay(kit: &Kit, lab: Lab, into: &Path) -> Result<()> {
    let empty = match fs::read_dir(into) {
        Ok(mut entries) => entries.next().is_none(),
        Err(_) => !into.exists(),
    };
    ensure!(empty, "{} is there already: a handout needs a new folder", into.display());
    let files = contents::gather(kit, lab)?;
    for (path, bytes) in &files {
        let place = into.join(path);
        write_file(&place, bytes)?;
        #[cfg(unix)]
        if path.extension().is_some_and(|extension| extension == "sh") {
            use std::os::unix::fs::PermissionsExt;
            fs::set_permissions(&place, fs::Permissions::from_mode(0o755))
                .with_context(|| format!("cannot write {}", place.display()))?;
        }
    }
    // What only the kit needs, cargo takes out of the lock file and leaves every version as it is. Where
    // it cannot, it does so at the first build.
    let _ = Kit::at(into).cargo().args(["update", "--workspace", "--offline"]).output();
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::lay;
    use lab_kit::answers;
    use lab_kit::starter::{Record, generate};
    use lab_kit::{Kit, files_below};

    fn handout(lab: &str) -> (tempfile::TempDir, Kit) {
        let folder = tempfile::tempdir().unwrap();
        lay(&Kit::find().unwrap(), lab.parse().unwrap(), folder.path()).unwrap();
        let kit = Kit::at(folder.path());
        (folder, kit)
    }

    #[test]
    fn labs_up_to_n_and_solutions_before_it() {
        let (_folder, kit) = handout("3");
        let labs = ["1", "2", "3"].map(|lab| lab.parse().unwrap());
        assert_eq!(kit.starters().unwrap(), labs);
        assert_eq!(kit.solutions().unwrap(), labs[..2]);
        for (path, there) in [
            ("tests/lab3.rs", true),
            ("tests/lab4.rs", false),
            ("tests/wrong", false),
            ("labs/common-mpi", false),
            ("labs/lab3/hints.md", true),
            ("book/src/lab3.md", true),
            ("book/src/lab4.md", false),
            ("book/src/instructor", false),
            ("scripts/student/src/main.rs", true),
            ("scripts/grading", false),
            (".cargo/config.toml", true),
            ("README.md", true),
        ] {
            assert_eq!(kit.path(path).exists(), there, "{path}");
        }
    }

    #[test]
    fn starters_are_untouched_ones() {
        let (_folder, kit) = handout("2");
        for lab in kit.starters().unwrap() {
            let record = Record::read(&kit.starter(lab)).unwrap();
            assert_eq!(record, Record::of(&generate(&Kit::find().unwrap(), lab).unwrap()));
            assert!(record.paths().all(|path| record.is_own(&kit.starter(lab), path)));
        }
    }

    /// A line of an answer that is long enough to be nobody else's must be nowhere.
    #[test]
    fn no_answer_of_the_lab_is_in_its_kit() {
        let (_folder, kit) = handout("2");
        let mut all = String::new();
        for path in files_below(kit.root()).unwrap() {
            // What the labs' own tests and given code say was public before.
            if !path.starts_with(kit.path("scripts")) {
                all.push_str(&String::from_utf8_lossy(&fs::read(path).unwrap()));
            }
        }
        let mut answers = 0;
        for file in answers::read_solution(&Kit::find().unwrap(), "2".parse().unwrap()).unwrap() {
            for region in file.marked.regions() {
                assert!(!all.contains(&region.body), "the answer to {} is there", region.id);
                answers += 1;
            }
        }
        assert!(answers > 3, "lab 2 has tasks");
    }

    #[test]
    fn its_lock_file_is_what_cargo_would_write() {
        let (_folder, kit) = handout("2");
        let mut cargo = kit.cargo();
        let output = cargo.args(["tree", "--locked", "--offline", "-p", "lab2"]).output().unwrap();
        let complaint = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{complaint}");
        let packages = fs::read_to_string(kit.path("Cargo.lock")).unwrap();
        assert!(packages.contains("\"solution1\"") && !packages.contains("\"solution2\""));
    }

    #[test]
    fn no_page_leads_to_one_that_is_left_out() {
        let (_folder, kit) = handout("5");
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
        let error = lay(&Kit::find().unwrap(), "1".parse().unwrap(), folder.path()).unwrap_err();
        assert!(error.to_string().contains("needs a new folder"), "{error}");
        assert_eq!(files_below(folder.path()).unwrap().len(), 1);
    }
}
