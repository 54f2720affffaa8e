//! `cargo lab similarity`: writes a class in the format that Dolos compares.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;

use crate::submission;
use crate::submission::names::named;
use lab_kit::escape::line;
use lab_kit::files::write_file;
use lab_kit::sources::{Sources, of_solution};
use lab_kit::starter;
use lab_kit::{Kit, Lab};

/// Write a class in the form that Dolos compares (for instructors)
///
/// Dolos (https://dolos.ugent.be) finds similar code, even if names, layout and order differ. It
/// gets one file for each submission, the kit's own solution, and the starter, whose code does not
/// count. The book explains how to install Dolos and how to read its results.
#[derive(Args)]
pub(crate) struct Options {
    /// A folder with a submission in each folder or archive
    folder: PathBuf,
    /// The lab [default: all labs that were handed in]
    #[arg(long, value_name = "N")]
    lab: Option<Lab>,
    /// Also compare with this class, such as the class of last year
    #[arg(long, value_name = "FOLDER")]
    before: Vec<PathBuf>,
    /// The folder to write [default: target/lab/similarity]
    #[arg(long, value_name = "DIR")]
    into: Option<PathBuf>,
}

/// Sources of a class. Each has a path in Dolos's input folder, a label, and a text.
type Class = Vec<(String, &'static str, String)>;

/// Writes a folder for each lab, and prints the command that runs Dolos.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let into = options.into.clone().unwrap_or_else(|| kit.memory().join("similarity"));
    let mut labs: BTreeMap<Lab, Class> = BTreeMap::new();
    for (label, folders) in [("now", &[options.folder][..]), ("before", &options.before)] {
        for (name, path) in named(submission::list_all(kit, folders)?) {
            let handed_in = match submission::read(&path) {
                Ok(handed_in) => handed_in,
                Err(error) => {
                    eprintln!("passed over: {}", line(&format!("{error:#}")));
                    continue;
                }
            };
            let found = &handed_in.labs;
            if options.lab.map_or(found.is_empty(), |lab| !found.contains_key(&lab)) {
                let lab = options.lab.map_or("N".into(), |lab| lab.to_string());
                eprintln!("passed over: {}: nothing in it is below labs/lab{lab}/src", line(&name));
                continue;
            }
            for (lab, files) in handed_in.labs {
                let path = format!("{label}/{name}.rs");
                labs.entry(lab).or_default().push((path, label, one_file(&files)));
            }
        }
    }
    labs.retain(|lab, class| options.lab.is_none_or(|own| own == *lab) && class.len() > 1);
    ensure!(!labs.is_empty(), "of no lab there are two submissions to compare");
    for (lab, mut class) in labs {
        let folder = into.join(format!("lab{lab}"));
        println!("Lab {lab}: {} submissions", class.len());
        // The kit is public, so any student can copy this solution.
        class.push(("public/solution.rs".into(), "public", one_file(&of_solution(kit, lab)?)));
        write(kit, lab, class, &folder)?;
        let list = folder.join("info.csv");
        let starter = folder.join("starter.rs");
        let list = list.display();
        let starter = starter.display();
        println!("dolos run --language rust --output-format web --ignore {starter} {list}");
    }
    Ok(ExitCode::SUCCESS)
}

fn write(kit: &Kit, lab: Lab, class: Class, folder: &Path) -> Result<()> {
    let given = starter::generate(kit, lab)?.into_iter();
    let given = given.map(|(path, bytes)| (path.display().to_string(), bytes)).collect();
    write_file(&folder.join("starter.rs"), one_file(&given))?;
    let mut list = csv::Writer::from_writer(Vec::new());
    list.write_record(["filename", "label"])?;
    for (path, label, text) in class {
        list.write_record([path.as_str(), label])?;
        write_file(&folder.join(path), text)?;
    }
    write_file(&folder.join("info.csv"), list.into_inner()?)
}

/// Joins all sources, because Dolos compares single files.
fn one_file(sources: &Sources) -> String {
    let own = sources.iter().filter(|(path, _)| path.ends_with(".rs"));
    own.map(|(path, bytes)| format!("// {path}\n{}\n", String::from_utf8_lossy(bytes))).collect()
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{Options, run, write_file};
    use lab_kit::Kit;
    use lab_kit::sources::{Sources, pack};

    #[test]
    fn each_submission_is_a_file_and_the_starter_is_ignored() {
        let top = tempfile::tempdir().unwrap();
        let top = top.path();
        let kit = Kit::find().unwrap();
        let files = ["src/a.rs", "src/b.rs", "src/data.txt"];
        let files: Sources = files.map(|path| (path.into(), b"fn f() {}".to_vec())).into();
        for path in ["handed-in/ada.tar.gz", "handed-in/bob.tgz", "2025/ada.tar.gz"] {
            write_file(&top.join(path), pack("2".parse().unwrap(), &files).unwrap()).unwrap();
        }
        fs::write(top.join("handed-in/what.rar"), "who knows").unwrap();
        let options = Options {
            folder: top.join("handed-in"),
            lab: None,
            before: vec![top.join("2025")],
            into: Some(top.join("out")),
        };
        run(&kit, options).unwrap();
        let read = |name: &str| fs::read_to_string(top.join("out/lab2").join(name)).unwrap();
        assert_eq!(
            read("info.csv"),
            "filename,label\nnow/ada.rs,now\nnow/bob.rs,now\nbefore/ada.rs,before\n\
             public/solution.rs,public\n"
        );
        assert!(read("public/solution.rs").contains("// task 2.1: "), "everybody can copy it");
        assert_eq!(read("now/bob.rs"), "// src/a.rs\nfn f() {}\n// src/b.rs\nfn f() {}\n");
        assert!(read("starter.rs").contains("\n// src/lib.rs\n"), "{}", read("starter.rs"));
    }
}
