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

/// How often a running job is looked at.
const GLANCE: Duration = Duration::from_millis(5);

/// What ranks get to say where they are.
const TO_SAY: Duration = Duration::from_secs(2);

/// What a launcher gets to end its ranks before it is killed itself.
const LAST_WORDS: Duration = Duration::from_secs(5);

/// A rank writes its process id into the folder `$0`, in a file with its number, and becomes the program.
const NOTE_ID: &str =
    r#"echo $$ > "$0/${OMPI_COMM_WORLD_RANK:-${PMIX_RANK:-$PMI_RANK}}" && exec "$@""#;

/// A program to be run on ranks on behalf of a task.
#[derive(Clone, Debug)]
pub struct Job {
    task: String,
    program: PathBuf,
    ranks: usize,
    arguments: Vec<OsString>,
    limit: Duration,
    ids: Option<PathBuf>,
}

/// A job that is over.
#[derive(Debug)]
pub struct Ended {
    /// What the launcher exited with.
    pub status: ExitStatus,
    /// What all ranks printed.
    pub stdout: String,
    /// What all ranks and the launcher complained about.
    pub stderr: String,
    /// From start to end.
    pub took: Duration,
}

impl Job {
    /// `program` on `ranks` ranks for task `task`, such as `"5.2"`, ended after a minute.
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

    /// The ignored test `part` of this very test program on `ranks` ranks: for what is tested
    /// from inside.
    pub fn part(task: &str, part: &str, ranks: usize) -> Self {
        let this = env::current_exe().expect("a program knows its own path");
        Self::new(task, this, ranks).args(["--exact", part, "--ignored", "--nocapture"])
    }

    /// On how many ranks it runs.
    pub fn ranks(&self) -> usize {
        self.ranks
    }

    /// The same with one more argument.
    #[must_use]
    pub fn arg(mut self, argument: impl Into<OsString>) -> Self {
        self.arguments.push(argument.into());
        self
    }

    /// The same with more arguments.
    #[must_use]
    pub fn args<A: Into<OsString>>(mut self, arguments: impl IntoIterator<Item = A>) -> Self {
        self.arguments.extend(arguments.into_iter().map(Into::into));
        self
    }

    /// The same with another time limit.
    #[must_use]
    pub fn within(mut self, seconds: u64) -> Self {
        self.limit = Duration::from_secs(seconds);
        self
    }

    /// The same, whose ranks write their process ids into files of `folder`, named by their numbers.
    #[must_use]
    pub(super) fn ids_into(mut self, folder: &Path) -> Self {
        self.ids = Some(folder.into());
        self
    }

    /// Runs the job to its end, whatever that is.
    ///
    /// # Panics
    /// It did not end in time (all its processes have then been ended), or there is no MPI.
    pub fn run(&self) -> Ended {
        self.run_beside(|| {})
    }

    /// As [`run`](Self::run), and calls `meanwhile` as soon as the job is started.
    pub fn run_beside(&self, meanwhile: impl FnOnce()) -> Ended {
        let launcher = Mpiexec::find().unwrap_or_else(|e| panic!("task {}: {e}", self.task));
        let limit = launcher.limit(self.limit, self.ranks);
        let _own = OwnLimit::begin();
        // Ranks spin while they wait: two jobs at once on a few cores slow each other to a crawl.
        let _alone = only_job();
        assert!(
            !tasks_that_hang().contains(&self.task),
            "task {}: not tried on {}, since no answer within the time came before",
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
        // Should the test itself be killed, both Open MPI and MPICH end the job by themselves.
        command.env("MPIEXEC_TIMEOUT", (limit + TO_SAY + LAST_WORDS).as_secs().to_string());
        command.env(WATCH, limit.as_secs().to_string());
        // Between ranks of one machine nothing else is used in the end, and to look for networks takes longer
        // than most jobs.
        command.env("OMPI_MCA_pml", "ob1").env("OMPI_MCA_btl", "^openib,tcp,ofi,usnic");
        // It would hold back what the library has to say until the job is gone.
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

    /// Runs the job, which must succeed.
    ///
    /// # Panics
    /// As [`run`](Self::run), or it failed.
    pub fn succeed(&self) -> Ended {
        let ended = self.run();
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

/// `1 rank`, `3 ranks`.
pub(super) fn count(ranks: usize) -> String {
    if ranks == 1 { "1 rank".into() } else { format!("{ranks} ranks") }
}

/// A launcher and its ranks, which end with it, also when what goes on beside them panics.
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

/// Asks the launcher to end its ranks, wherever they are, and then ends the whole group.
fn end_group(child: &mut Child) {
    let group = Pid::from_child(child);
    // The group may be gone by the time of either signal; then there is nothing left to do.
    let _ = kill_process_group(group, Signal::TERM);
    wait(child, LAST_WORDS);
    let _ = kill_process_group(group, Signal::KILL);
    wait(child, LAST_WORDS);
}

/// The tasks that have had a job that did not end: another one would not either.
fn tasks_that_hang() -> MutexGuard<'static, BTreeSet<String>> {
    static TASKS: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    TASKS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Held while a job runs, by whichever test of whichever process.
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
