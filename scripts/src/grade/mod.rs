//! `cargo lab grade`: a class, graded by what its programs compute.
//!
//! Of a submission only the lab's `src` is taken ([`intake`]). It is built in a tree that holds no
//! solution of the lab ([`tree`]), in a [`sandbox`], with a probe beside it. The [`probe`] gets
//! inputs that nobody knew before, and this process compares its answers with the solution's.
//! After that, alone on the machine, it is [timed](timing). What comes out is a [`record`] per
//! submission; the [rubric] makes points of it ([`award`](mod@award)), and a [`report`] says so.

mod award;
mod clean;
pub(crate) mod difference;
mod feedback;
mod finish;
mod guard;
mod intake;
mod known;
mod probe;
mod record;
pub(crate) mod regrade;
mod report;
pub(crate) mod rubric;
mod runs;
mod sandbox;
mod timing;
mod tree;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::sync::Mutex;
use std::thread;
use std::time::{Duration, SystemTime};

use anyhow::{Context, Result, bail, ensure};
use clap::Args;
use indicatif::ProgressBar;

use crate::digest::digest;
use crate::harness::kill_all_on_interrupt;
use crate::kit::{Kit, Lab};
use crate::submission::Sources;
use crate::system;
use feedback::Bench;
use guard::Guard;
use probe::Answer;
use record::{FORMAT, Record, Status, Task};
use rubric::Rubric;
use sandbox::Sandbox;
use tempfile::TempDir;
use tree::{Built, Tree};

/// Grade submissions (for instructors)
///
/// A path is a submission (a folder with labs/ in it, a .tar.gz that 'cargo lab submit' made, or a
/// .zip of such a folder) or a folder of many. 'solutions' is the kit's own. Each gets a record, a
/// JSON file. A submission whose record is there already, with the same sources and the same
/// grader, is passed over.
#[derive(Args)]
pub(crate) struct Options {
    /// Submissions, or folders of them
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// The lab; all that were handed in if not given
    #[arg(long, value_name = "N")]
    lab: Option<Lab>,
    /// Grade only those whose name contains this
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
    /// So many at a time; all cores if not given
    #[arg(long, value_name = "N")]
    jobs: Option<usize>,
    /// Inputs come from this number; from the clock if not given
    #[arg(long)]
    seed: Option<u64>,
    /// No probe and no test runs longer
    #[arg(long, value_name = "SECONDS", default_value_t = 30)]
    limit: u64,
    /// Leave out the lab's own tests, which are feedback and give no marks
    #[arg(long)]
    no_tests: bool,
    /// Take no times: measures of complexity, scaling and speed are then not graded
    #[arg(long)]
    no_timing: bool,
    /// Run the code without a sandbox, with all your rights
    #[arg(long)]
    trusted: bool,
    /// The folder of records; target/lab/grade/labN if not given
    #[arg(long, value_name = "DIR")]
    into: Option<PathBuf>,
}

/// What all submissions are graded by.
struct Grader<'a> {
    kit: &'a Kit,
    lab: Lab,
    rubric: Rubric,
    sandbox: Sandbox,
    seed: u64,
    /// SHA-256 of probes and solution.
    hash: String,
    toolchain: String,
    /// Whether the lab's own tests run as well.
    tests: bool,
    /// The solution's answers, by task.
    expected: Vec<(String, Vec<Answer>)>,
    /// The solution's programs.
    solution: TempDir,
}

/// Where one submission after another is built.
struct Workplace {
    /// With a probe.
    tree: Tree,
    /// With the lab's own tests, if they are to run.
    bench: Option<Bench>,
}

impl Workplace {
    fn lay(kit: &Kit, lab: Lab, options: &Options) -> Result<Self> {
        let bench = if options.no_tests { None } else { Some(Bench::lay(kit, lab)?) };
        Ok(Self { tree: Tree::lay(kit, lab)?, bench })
    }
}

/// Grades, and says how many points each got.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let mut submissions = Vec::new();
    for path in &options.paths {
        submissions.extend(intake::submissions(kit, path)?);
    }
    submissions.retain(|path| options.only.as_ref().is_none_or(|only| name(path).contains(only)));
    ensure!(!submissions.is_empty(), "there is nothing to grade");
    let submissions = named(submissions);
    kill_all_on_interrupt();
    if let Some(lab) = options.lab {
        if let Some(what) = system::missing(kit, lab)? {
            bail!("lab {lab} cannot be graded here: it needs {what}");
        }
        let into = options.into.clone();
        let into = into.unwrap_or_else(|| kit.memory().join(format!("grade/lab{lab}")));
        return grade_lab(kit, lab, &submissions, &into, &options);
    }
    let top = options.into.clone().unwrap_or_else(|| kit.memory().join("grade"));
    let (mut graded, mut all_well) = (false, true);
    for lab in rubric::all(kit)?.into_keys() {
        // Whoever cannot be read may have meant any lab, and shows up in the first.
        let handed_in = |path: &PathBuf| match intake::take(kit, lab, path) {
            Ok(intake) => !intake.files.is_empty(),
            Err(_) => !graded,
        };
        let of_lab = submissions.iter().filter(|(_, path)| handed_in(path));
        let of_lab: Vec<_> = of_lab.cloned().collect();
        if of_lab.is_empty() {
            continue;
        }
        match system::missing(kit, lab)? {
            Some(what) => println!("Lab {lab}: not graded, since it needs {what}"),
            None => {
                println!("Lab {lab}");
                let into = top.join(format!("lab{lab}"));
                let ended = grade_lab(kit, lab, &of_lab, &into, &options)?;
                all_well &= ended == ExitCode::SUCCESS;
                graded = true;
            }
        }
    }
    ensure!(graded, "nothing there has labs/labN/src in it, of a lab that can be graded here");
    Ok(if all_well { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Grades the submissions of a lab, by name and path, and leaves their records in `into`. A record
/// is written whole or not at all: who is killed half-way goes on where it was.
fn grade_lab(
    kit: &Kit,
    lab: Lab,
    submissions: &[(String, PathBuf)],
    into: &Path,
    options: &Options,
) -> Result<ExitCode> {
    let seed = options.seed;
    fs::create_dir_all(into).with_context(|| format!("cannot make {}", into.display()))?;
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let jobs = options.jobs.unwrap_or(cores).clamp(1, submissions.len());
    let _guard = Guard::set(jobs);
    let first = Workplace::lay(kit, lab, options)?;
    let grader = Grader::new(kit, lab, options, &first.tree)?;
    let bar = ProgressBar::new(submissions.len() as u64);
    let trees = Mutex::new(vec![first]);
    let programs = Mutex::new(BTreeMap::new());
    let next = Mutex::new(submissions.iter());
    let take = || next.lock().ok()?.next();
    let work = || -> Result<()> {
        let mut tree = trees.lock().ok().and_then(|mut trees| trees.pop());
        while let Some((name, path)) = take() {
            let place = into.join(format!("{name}.json"));
            if !is_done(&grader, path, &place, seed) {
                let tree = match &mut tree {
                    Some(tree) => tree,
                    none => none.insert(Workplace::lay(kit, lab, options)?),
                };
                let (record, program) = grader.grade(tree, name, path)?;
                record.write(into)?;
                if let (Some(program), Ok(mut programs)) = (program, programs.lock()) {
                    programs.insert(name.clone(), program);
                }
            }
            bar.inc(1);
        }
        Ok(())
    };
    thread::scope(|scope| {
        let workers: Vec<_> = (0..jobs).map(|_| scope.spawn(work)).collect();
        workers.into_iter().try_for_each(|worker| worker.join().expect("grading does not panic"))
    })?;
    bar.finish_and_clear();
    let programs = programs.into_inner().unwrap_or_default();
    let ended = finish::finish(&grader, submissions, into, programs, !options.no_timing)?;
    println!("Records: {}", into.display());
    Ok(ended)
}

impl<'a> Grader<'a> {
    fn new(kit: &'a Kit, lab: Lab, options: &Options, tree: &Tree) -> Result<Self> {
        let rubric = rubric::read(kit, lab)?;
        let hash = hash(&tree::graded_by(kit, lab)?);
        let limit = Duration::from_secs(options.limit);
        let sandbox = Sandbox::find(kit, options.trusted, limit)?;
        let seed = options.seed.unwrap_or_else(|| {
            let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
            now.map_or(1, |now| now.as_nanos() as u64)
        });
        let version = Command::new("rustc").arg("--version").current_dir(kit.root()).output()?;
        let toolchain = String::from_utf8_lossy(&version.stdout).trim().to_owned();
        let folder = tree.reference(kit, &sandbox)?;
        let expected = rubric
            .tasks
            .keys()
            .map(|task| Ok((task.clone(), probe::reference(&sandbox, folder.path(), task, seed)?)));
        let expected = expected.collect::<Result<_>>()?;
        let (tests, solution) = (!options.no_tests, folder);
        Ok(Self { kit, lab, rubric, sandbox, seed, hash, toolchain, tests, expected, solution })
    }

    fn blank(&self, name: &str) -> Record {
        let tasks = self.rubric.tasks.iter().map(|(id, points)| Task {
            id: id.clone(),
            passed: false,
            message: String::new(),
            points: 0.0,
            out_of: *points,
        });
        let cores = thread::available_parallelism().map_or(1, usize::from);
        Record {
            format: FORMAT,
            name: name.to_owned(),
            lab: self.lab.number(),
            status: Status::Graded,
            message: String::new(),
            hash: String::new(),
            files: Default::default(),
            left_out: Vec::new(),
            grader: self.hash.clone(),
            seed: self.seed,
            toolchain: self.toolchain.clone(),
            machine: format!("{} {}, {cores} cores", std::env::consts::OS, std::env::consts::ARCH),
            sandboxed: self.sandbox.keeps(),
            tests: None,
            tasks: tasks.collect(),
            timed: false,
            runs: Vec::new(),
            measures: Vec::new(),
            points: 0.0,
            out_of: self.rubric.tasks.values().sum(),
        }
    }

    /// The record of a submission, without times, and its programs if there are any. An error is
    /// the grader's own trouble; whatever is wrong with a submission is in its record.
    fn grade(
        &self,
        place: &Workplace,
        name: &str,
        path: &Path,
    ) -> Result<(Record, Option<TempDir>)> {
        let mut record = self.blank(name);
        let ended = |mut record: Record, status, message: String| {
            (record.status, record.message) = (status, message);
            Ok((record, None))
        };
        let intake = match intake::take(self.kit, self.lab, path) {
            Ok(intake) => intake,
            Err(error) => return ended(record, Status::Unreadable, format!("{error:#}")),
        };
        record.left_out = intake.left_out;
        if intake.files.is_empty() {
            let message = format!("there is no labs/lab{}/src in it", self.lab);
            return ended(record, Status::Empty, message);
        }
        record.hash = hash(&intake.files);
        record.files =
            intake.files.iter().map(|(path, bytes)| (path.clone(), digest(bytes))).collect();
        if !intake.files.contains_key("src/lib.rs") {
            let message = format!("there is no labs/lab{}/src/lib.rs in it", self.lab);
            return ended(record, Status::NotBuilt, message);
        }
        let folder = match place.tree.build(&self.sandbox, &intake.files)? {
            Built::Program(folder) => folder,
            Built::Failed(why) => return ended(record, Status::NotBuilt, why),
        };
        for (task, (_, expected)) in record.tasks.iter_mut().zip(&self.expected) {
            let wrong = probe::wrong(&self.sandbox, folder.path(), &task.id, self.seed, expected)?;
            task.passed = wrong.is_none();
            task.message = wrong.unwrap_or_default();
        }
        if let Some(bench) = &place.bench {
            record.tests = Some(bench.run(&self.sandbox, &intake.files)?);
        }
        Ok((record, Some(folder)))
    }
}

/// Whether a record says what grading again would say.
fn is_done(grader: &Grader<'_>, path: &Path, place: &Path, seed: Option<u64>) -> bool {
    let record = fs::read(place).ok().and_then(|text| serde_json::from_slice::<Record>(&text).ok());
    let Some(record) = record else { return false };
    let same = match intake::take(grader.kit, grader.lab, path) {
        Err(error) => record.status == Status::Unreadable && record.message == format!("{error:#}"),
        Ok(intake) if intake.files.is_empty() => record.status == Status::Empty,
        Ok(intake) => record.hash == hash(&intake.files),
    };
    let asked = |task: &String| record.tasks.iter().any(|asked| asked.id == *task);
    same && record.format == FORMAT
        && grader.rubric.tasks.keys().all(asked)
        && record.grader == grader.hash
        && record.sandboxed == grader.sandbox.keeps()
        && (record.tests.is_some() || record.status != Status::Graded || !grader.tests)
        && seed.is_none_or(|seed| seed == record.seed)
}

/// Gives every submission a name of its own: whose name another has too is called in full.
fn named(paths: Vec<PathBuf>) -> Vec<(String, PathBuf)> {
    let mut named: Vec<(String, PathBuf)> = Vec::new();
    for path in paths {
        let short = name(&path);
        let full = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let numbered = (2..).map(|number| format!("{full}-{number}"));
        let taken = |name: &String| named.iter().any(|(other, _)| other == name);
        let free = [short, full.clone()].into_iter().chain(numbered).find(|name| !taken(name));
        named.push((free.unwrap_or_default(), path));
    }
    named
}

/// What a submission is called: its file's name without the endings of archives.
fn name(path: &Path) -> String {
    let name = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let name = name.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let ending = [".tar.gz", ".tgz", ".zip"].into_iter().find(|ending| name.ends_with(ending));
    ending.map_or(name.clone(), |ending| name[..name.len() - ending.len()].to_owned())
}

fn hash(files: &Sources) -> String {
    let lines = files.iter().map(|(path, bytes)| format!("{} {path}\n", digest(bytes)));
    digest(lines.collect::<String>().as_bytes())
}
