//! One job under a time limit.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs::File;
use std::io::{Read, Seek};
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Child, ExitStatus};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use std::{env, thread};

use lab_machine::Mpiexec;
use rustix::process::{Pid, Signal, kill_process_group};

use super::words;
use crate::watchdog::{OwnLimit, WATCH};

/// Interval between two checks of a running job.
const GLANCE: Duration = Duration::from_millis(5);

/// Time in which ranks can report the calls that they are in.
const TO_SAY: Duration = Duration::from_secs(2);

/// Time in which a launcher may end its ranks before it is killed.
const LAST_WORDS: Duration = Duration::from_secs(5);

/// Shell command that writes a rank's process id to a file in the folder `$0`, and then becomes the
/// program. The name of the file is the rank's number.
const NOTE_ID: &str =
    r#"echo $$ > "$0/${OMPI_COMM_WORLD_RANK:-${PMIX_RANK:-$PMI_RANK}}" && exec "$@""#;

/// A program to run on several ranks, for a task.
#[derive(Clone, Debug)]
pub struct Job {
    task: String,
    program: PathBuf,
    ranks: usize,
    arguments: Vec<OsString>,
    limit: Duration,
    ids: Option<PathBuf>,
}

/// A job that has ended.
#[derive(Debug)]
pub struct Ended {
    /// Exit status of the launcher.
    pub status: ExitStatus,
    /// Standard output of all ranks.
    pub stdout: String,
    /// Standard error of all ranks and the launcher.
    pub stderr: String,
    /// Time from start to end.
    pub took: Duration,
}

impl Job {
    /// Returns a job that runs `program` on `ranks` ranks for task `task`, such as `"5.2"`, for at
    /// most a minute.
    pub fn new(task: &str, program: impl AsRef<Path>, ranks: usize) -> Self {
        Self {
            task: task.into(),
            program: program.as_ref().into(),
            ranks,
            arguments: Vec::new(),
            limit: Duration::from_secs(60),
            ids: None,
        }
    }

    /// Returns a job that runs the ignored test `part` of this test program on `ranks` ranks.
    ///
    /// A test uses it to check code that must run on a rank.
    pub fn part(task: &str, part: &str, ranks: usize) -> Self {
        let this = env::current_exe().expect("a program knows its own path");
        Self::new(task, this, ranks).args(["--exact", part, "--ignored", "--nocapture"])
    }

    /// Returns the number of ranks.
    pub fn ranks(&self) -> usize {
        self.ranks
    }

    /// Returns the same job with one more argument.
    #[must_use]
    pub fn arg(mut self, argument: impl Into<OsString>) -> Self {
        self.arguments.push(argument.into());
        self
    }

    /// Returns the same job with more arguments.
    #[must_use]
    pub fn args<A: Into<OsString>>(mut self, arguments: impl IntoIterator<Item = A>) -> Self {
        self.arguments.extend(arguments.into_iter().map(Into::into));
        self
    }

    /// Returns the same job with a different time limit.
    #[must_use]
    pub fn within(mut self, seconds: u64) -> Self {
        self.limit = Duration::from_secs(seconds);
        self
    }

    /// Returns the same job, in which each rank also writes its process id to a file in `folder`.
    ///
    /// The name of each file is the rank's number.
    #[must_use]
    pub(super) fn ids_into(mut self, folder: &Path) -> Self {
        self.ids = Some(folder.into());
        self
    }

    /// Runs the job to its end, successful or not.
    ///
    /// # Panics
    /// If the job exceeds its time limit (its processes are killed before the panic), or if MPI is
    /// not installed.
    pub fn run(&self) -> Ended {
        self.run_beside(|| {})
    }

    /// Runs the job as [`run`](Self::run) does, and calls `meanwhile` as soon as the job has
    /// started.
    pub fn run_beside(&self, meanwhile: impl FnOnce()) -> Ended {
        let launcher = Mpiexec::find().unwrap_or_else(|e| panic!("task {}: {e}", self.task));
        let limit = launcher.limit(self.limit, self.ranks);
        let _own = OwnLimit::begin();
        // Ranks spin while they wait, so two simultaneous jobs on a few cores slow each other down
        // very much.
        let _alone = only_job();
        assert!(
            !tasks_that_hang().contains(&self.task),
            "task {}: not tried on {}, because another job of the task gave no answer in time",
            self.task,
            count(self.ranks)
        );
        let (mut stdout, mut stderr) = (unnamed(), unnamed());
        let share = |file: &File| file.try_clone().expect("a file can be shared");
        let mut command = match &self.ids {
            None => launcher.start(self.ranks, &self.program),
            Some(folder) => {
                let mut shell = launcher.start(self.ranks, Path::new("sh"));
                shell.arg("-c").arg(NOTE_ID).arg(folder).arg(&self.program);
                shell
            }
        };
        command.args(&self.arguments);
        command.stdout(share(&stdout)).stderr(share(&stderr)).stdin(std::process::Stdio::null());
        // If the test itself is killed, both Open MPI and MPICH end the job.
        command.env("MPIEXEC_TIMEOUT", (limit + TO_SAY + LAST_WORDS).as_secs().to_string());
        command.env(WATCH, limit.as_secs().to_string());
        // Ranks on one machine need no network, and searching for networks takes longer than most
        // jobs.
        command.env("OMPI_MCA_pml", "ob1").env("OMPI_MCA_btl", "^openib,tcp,ofi,usnic");
        // Aggregation would delay the library's messages until the job has ended.
        command.env("OMPI_MCA_orte_base_help_aggregate", "0");
        let start = Instant::now();
        let child = command.process_group(0).spawn();
        let mut child = Running(
            child.unwrap_or_else(|e| panic!("task {}: cannot start {command:?}: {e}", self.task)),
        );
        meanwhile();
        let Some(status) = wait(&mut child.0, limit + TO_SAY) else {
            drop(child);
            tasks_that_hang().insert(self.task.clone());
            panic!(
                "task {}: {} gave no answer within {} s. {}",
                self.task,
                count(self.ranks),
                limit.as_secs(),
                words::of_no_answer(&all_of(&mut stderr), self.ranks, limit),
            );
        };
        let took = start.elapsed();
        Ended { status, stdout: all_of(&mut stdout), stderr: all_of(&mut stderr), took }
    }

    /// Runs a job that must succeed.
    ///
    /// If a rank ends the job without a message, the job runs once more. Open MPI 4.1 causes such
    /// failures at the end of one job in several hundred, whatever the program.
    ///
    /// # Panics
    /// As [`run`](Self::run), or if the job fails.
    pub fn succeed(&self) -> Ended {
        let mut ended = self.run();
        if !ended.status.success() && words::of_a_failure(&ended.stderr) == words::SILENT {
            ended = self.run();
        }
        assert!(
            ended.status.success(),
            "task {}: {} failed:\n{}",
            self.task,
            count(self.ranks),
            words::of_a_failure(&ended.stderr)
        );
        ended
    }
}

/// Formats a number of ranks: `1 rank`, `3 ranks`.
pub(super) fn count(ranks: usize) -> String {
    if ranks == 1 { "1 rank".into() } else { format!("{ranks} ranks") }
}

/// A launcher and its ranks. Dropping it ends them, even if the test panics.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        if let Ok(None) = self.0.try_wait() {
            end_group(&mut self.0);
        }
    }
}

fn wait(child: &mut Child, limit: Duration) -> Option<ExitStatus> {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait().expect("a child can be waited for") {
            return Some(status);
        }
        if start.elapsed() > limit {
            return None;
        }
        thread::sleep(GLANCE);
    }
}

/// Asks the launcher to end its ranks on all machines, and then ends the whole process group.
fn end_group(child: &mut Child) {
    let group = Pid::from_child(child);
    // The group may have ended before either signal; then nothing remains to be done.
    let _ = kill_process_group(group, Signal::TERM);
    wait(child, LAST_WORDS);
    let _ = kill_process_group(group, Signal::KILL);
    wait(child, LAST_WORDS);
}

/// Returns the tasks with a job that did not end. Further jobs of these tasks would not end either.
fn tasks_that_hang() -> MutexGuard<'static, BTreeSet<String>> {
    static TASKS: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    TASKS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Returns a lock that is held while a job runs, across all tests and processes.
fn only_job() -> File {
    let path = env::temp_dir().join("cutoff-mpiexec.lock");
    let file = File::options().create(true).truncate(false).write(true).open(path);
    let file = file.expect("the temporary folder is writable");
    file.lock().expect("a file can be locked");
    file
}

fn unnamed() -> File {
    tempfile::tempfile().expect("the temporary folder is writable")
}

fn all_of(file: &mut File) -> String {
    let mut text = Vec::new();
    file.rewind().and_then(|()| file.read_to_end(&mut text)).expect("a file can be read back");
    String::from_utf8_lossy(&text).into_owned()
}
