//! `cargo lab grade`: grades a class by running its programs.
//!
//! [`grader`] judges the tasks of one submission. [`batch`] judges all submissions, several at a
//! time, and then times them while nothing else runs. It continues after an interruption.
//! [`summary`] formats the printed lines.

mod batch;
mod grader;
mod summary;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use anyhow::{Result, ensure};
use clap::Args;

use crate::roster::late::file_time;
use crate::roster::{self, ClassFile};
use crate::sandbox::{Limits, Sandbox, room};
use crate::submission::names::{CLASS, METADATA, composed, name, named};
use crate::{record, report, submission};
use batch::{Left, work};
use grader::Grader;
use lab_kit::process::kill_all_on_interrupt;
use lab_kit::{Kit, Lab, Workers, rubric, system};

/// A submission: its name and its path.
type Named = (String, PathBuf);

/// Grade submissions (for instructors)
///
/// A path is a submission (a folder with labs/ in it, a .tar.gz that 'cargo lab submit' made, or a
/// .zip of such a folder) or a folder of many. 'solutions' is the kit's own solution. Each
/// submission gets a record, a JSON file. A submission that has a record of the same sources and
/// the same grader is skipped. The list of students, the deadline and your own decisions are in
/// class.toml in the folder of records.
#[derive(Args)]
pub(crate) struct Options {
    /// Submissions, or folders of them
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// The lab [default: all labs that were handed in]
    #[arg(long, value_name = "N")]
    lab: Option<Lab>,
    /// Grade only submissions whose name contains this text
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
    /// Grade again, even where a record exists
    #[arg(long)]
    again: bool,
    /// Seed of the questions' inputs [default: a random seed]
    #[arg(long)]
    seed: Option<u64>,
    /// Time limit of a question; ten times the solution's time if that is less
    #[arg(long, value_name = "SECONDS", default_value_t = 30)]
    limit: u64,
    /// Time limit of a submission's compilation
    #[arg(long, value_name = "SECONDS", default_value_t = 120)]
    build_limit: u64,
    /// Do not time programs: complexity, scaling and speed are then not graded, and there is no contest
    #[arg(long)]
    no_timing: bool,
    /// If no sandbox can be made, run the code without one, with all your rights
    #[arg(long)]
    trusted: bool,
    /// The folder of records [default: target/lab/grade/labN]
    #[arg(long, value_name = "DIR")]
    into: Option<PathBuf>,
}

/// Grades the submissions and prints the points of each.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let submissions = chosen(kit, &options)?;
    kill_all_on_interrupt();
    match options.lab {
        Some(lab) => grade_one_lab(kit, lab, &submissions, &options),
        None => grade_all_labs(kit, &submissions, &options),
    }
}

/// Lists the submissions at the paths of the command line, with their names.
fn chosen(kit: &Kit, options: &Options) -> Result<Vec<Named>> {
    let mut submissions = submission::list_all(kit, &options.paths)?;
    submissions.retain(|path| {
        options.only.as_ref().is_none_or(|only| name(path).contains(&composed(only)))
    });
    ensure!(!submissions.is_empty(), "there is nothing to grade");
    Ok(named(submissions))
}

/// Grades the lab of the command line.
fn grade_one_lab(
    kit: &Kit,
    lab: Lab,
    submissions: &[Named],
    options: &Options,
) -> Result<ExitCode> {
    let what = system::missing(kit, lab)?.unwrap_or_default();
    ensure!(what.is_empty(), "lab {lab} cannot be graded here: it needs {what}");
    let into = options.into.clone();
    let into = into.unwrap_or_else(|| kit.memory().join(format!("grade/lab{lab}")));
    grade(kit, lab, submissions, &into, options)
}

/// Grades every lab that was handed in. Prints the names of labs that cannot be graded here.
fn grade_all_labs(kit: &Kit, submissions: &[Named], options: &Options) -> Result<ExitCode> {
    let top = options.into.clone().unwrap_or_else(|| kit.memory().join("grade"));
    let mut graded = false;
    let mut all_well = true;
    for lab in rubric::all(kit)?.into_keys() {
        let mut of_lab = submissions.to_vec();
        // A submission that cannot be read may be for any lab. It is graded with the first lab.
        of_lab.retain(|(_, path)| submission::holds(kit, lab, path).unwrap_or(!graded));
        if of_lab.is_empty() {
            continue;
        }
        if let Some(what) = system::missing(kit, lab)? {
            println!("Lab {lab}: not graded, since it needs {what}");
            continue;
        }
        println!("Lab {lab}");
        let into = top.join(format!("lab{lab}"));
        all_well &= grade(kit, lab, &of_lab, &into, options)? == ExitCode::SUCCESS;
        graded = true;
    }
    ensure!(graded, "nothing there has labs/labN/src in it, of a lab that can be graded here");
    Ok(if all_well { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Grades the submissions of a lab. Writes their records and the pages of the class into `into`.
///
/// A record is written completely or not at all, so a grading run that was interrupted can resume
/// where it stopped. If every submission has already been judged and timed, nothing is built.
fn grade(
    kit: &Kit,
    lab: Lab,
    submissions: &[Named],
    into: &Path,
    options: &Options,
) -> Result<ExitCode> {
    record::expect_lab(into, lab)?;
    for file in [CLASS, METADATA] {
        let beside = options.paths.iter().map(|path| path.join(file));
        if let Some(path) = beside.into_iter().find(|path| path.is_file()) {
            roster::link(&path, into)?;
        }
    }
    let limits = Limits {
        run: Duration::from_secs(options.limit),
        build: Duration::from_secs(options.build_limit),
        loopback: kit.facts(lab)?.workers == Workers::Ranks,
    };
    let sandbox = &Sandbox::find(kit, options.trusted, limits)?;
    room::make_for_records(into)?;
    let grader = Grader::new(kit, lab, options, sandbox, into)?;
    // Report a mistake in `class.toml` before grading, not after it.
    ClassFile::read(into, &grader.rubric)?;
    let left = Left::of(&grader, submissions, into, options);
    if options.seed.is_some()
        && left.open.iter().any(|(name, _)| !record::path(into, name).exists())
    {
        eprintln!(
            "--seed: letters name it, so who has read one knows what is asked. Leave it out for a first grading"
        );
    }
    let all_timed = left.is_empty() || work(&grader, &left, submissions.len(), into)?;
    let ended = finish(&grader, submissions, into)?;
    println!("Records: {}", into.display());
    Ok(if all_timed { ended } else { ExitCode::FAILURE })
}

/// Computes points, writes the pages, and prints a line for each submission.
///
/// Returns failure as [`summary::print_submissions`] does.
fn finish(grader: &Grader<'_>, submissions: &[Named], into: &Path) -> Result<ExitCode> {
    let mut records = record::read_all(into)?;
    for (name, path) in submissions {
        if let Some(record) = records.iter_mut().find(|record| record.found.name == *name) {
            record.marked.handed_in = file_time(path, grader.lab);
        }
    }
    let class = ClassFile::read(into, &grader.rubric)?;
    let attendance = class.mark(&mut records, &grader.rubric)?;
    records.iter().try_for_each(|record| record.write(into))?;
    report::write(grader.kit, grader.lab, &records, (&class, &attendance), into)?;
    let ended = summary::print_submissions(grader, submissions, &records)?;
    attendance.say(&records);
    summary::print_about_times(&class, submissions);
    if let Some(ungraded) = &grader.rubric.ungraded {
        println!("Not graded: {ungraded}");
    }
    println!("The class: {}", into.join("index.html").display());
    report::publish_contest(grader.kit, &records, into)?;
    Ok(ended)
}
