//! `cargo lab submit`: packs a lab for handing in.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;

use crate::check::Seen;
use crate::graded::Graded;
use crate::tasks;
use lab_kit::files::write_file;
use lab_kit::sources::{self, Collected};
use lab_kit::starter::Record;
use lab_kit::terminal::folded;
use lab_kit::{Kit, Lab, system};

/// Pack a lab for handing in
///
/// Packs labs/labN/src and nothing else, lists the files, and builds them as the grader does. The
/// same files give the same archive, so handing in twice changes nothing. To see whether the lab is
/// ready, run 'cargo lab check N' first. Its findings are repeated here.
#[derive(Args)]
pub(crate) struct Options {
    /// The lab, such as 2
    lab: Lab,
    /// The archive to write [default: labN.tar.gz]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Packs the lab, and prints the files in the archive, the files left out, and the remaining work.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let lab = options.lab;
    kit.expect_starter(lab)?;
    let output = options.output.unwrap_or_else(|| format!("lab{lab}.tar.gz").into());
    let collected = sources::collect(&kit.starter(lab))?;
    ensure!(!collected.files.is_empty(), "there is nothing in labs/lab{lab}/src");
    write_file(&output, sources::pack(lab, &collected.files)?)?;
    let graded = Graded::lay(kit, lab, &collected)?;
    let unbuilt = match system::missing(kit, lab)? {
        Some(what) => Some(format!("it was not built, because it needs {what}")),
        None => graded.trouble(),
    };
    let unbuilt = unbuilt.map(|trouble| format!("NOT WELL: lab {lab}: {trouble}\n"));
    let account = account(kit, lab, &collected, &graded.changed, &output)?;
    for line in (account + &unbuilt.unwrap_or_default()).lines() {
        print!("{}", folded("", line));
    }
    Ok(ExitCode::SUCCESS)
}

/// Describes the archive of a lab. `changed_given` lists the given files that the student changed.
fn account(
    kit: &Kit,
    lab: Lab,
    collected: &Collected,
    changed_given: &[String],
    output: &Path,
) -> Result<String> {
    let folder = kit.starter(lab);
    let record = Record::read(&folder)?;
    let mut lines = vec![format!("{} holds {} files:", output.display(), collected.files.len())];
    let mut changed = 0;
    for path in collected.files.keys() {
        let given = record.is_own(&folder, Path::new(path));
        changed += usize::from(!given);
        let note = match (given, changed_given.contains(path)) {
            (true, _) => "  as given",
            (_, true) => "  which you changed: grading has its own",
            _ => "",
        };
        lines.push(format!("  labs/lab{lab}/{path}{note}"));
    }
    for (path, why) in &collected.left_out {
        lines.push(format!("  left out: labs/lab{lab}/{}, {why}", path.display()));
    }
    // The grader uses its own versions of these files, and a student who changed them should know
    // that.
    for path in record.paths().filter(|path| !path.starts_with("src")) {
        if !record.is_own(&folder, path) {
            lines.push(format!(
                "  left out: labs/lab{lab}/{}, which you changed: grading has its own",
                path.display()
            ));
        }
    }
    if changed == 0 {
        lines.push("Nothing in it is yours yet: every file is as it was given.".into());
    }
    let open = tasks::open_todos(kit, lab)?;
    match Seen::read(kit, lab)? {
        None => lines
            .push(format!("You have not checked it as it is now: run 'cargo lab check {lab}'.")),
        Some(seen) => lines.extend(seen.troubles.iter().map(|what| format!("NOT WELL: {what}"))),
    }
    if let [first, ..] = &open[..] {
        let others = match open.len() {
            1 => String::new(),
            count => format!(" and {} more", count - 1),
        };
        lines.push(format!("Still to do: task {first}{others}. You can hand in again later."));
    }
    Ok(lines.join("\n") + "\n")
}

#[cfg(test)]
mod tests {
    use super::account;
    use lab_kit::starter::Record;
    use lab_kit::{Kit, sources};

    #[test]
    fn it_says_what_goes_and_what_stays() {
        let folder = tempfile::tempdir().unwrap();
        let files = [
            ("labs/lab1/src/lib.rs", "given"),
            ("labs/lab1/src/a.rs", "todo!(\"task 1.2: the move\")"),
            ("labs/lab1/src/a.rs~", "old"),
            ("labs/lab1/Cargo.toml", "mine"),
        ];
        let kit = Kit::of_files(folder.path(), &files);
        let lab = "1".parse().unwrap();
        let given = ["src/lib.rs", "src/a.rs", "Cargo.toml"];
        let given = given.map(|path| (path.into(), b"given".to_vec())).into();
        Record::of(&given).write(&kit.starter(lab)).unwrap();
        let collected = sources::collect(&kit.starter(lab)).unwrap();
        assert_eq!(
            account(&kit, lab, &collected, &[], "lab1.tar.gz".as_ref()).unwrap(),
            "lab1.tar.gz holds 2 files:\n  \
             labs/lab1/src/a.rs\n  \
             labs/lab1/src/lib.rs  as given\n  \
             left out: labs/lab1/src/a.rs~, hidden, or an editor's copy\n  \
             left out: labs/lab1/Cargo.toml, which you changed: grading has its own\n\
             You have not checked it as it is now: run 'cargo lab check 1'.\n\
             Still to do: task 1.2. You can hand in again later.\n"
        );
    }
}
