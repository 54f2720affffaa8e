//! Questions to a lab's own program on ranks, from outside: the program is started with `mpiexec`.

use std::path::PathBuf;

use tempfile::TempDir;

use super::job::count;
use super::{Job, ends_when_a_rank_is_killed};
use crate::official::{OFFICIAL_SHA256, sha256};

/// One variant of a lab's program on ranks. Errors are panics in the domain's words.
#[derive(Clone)]
pub struct OnRanks {
    task: &'static str,
    program: PathBuf,
    variant: &'static str,
    ranks: usize,
}

impl OnRanks {
    /// Returns variant `variant` of `program` on `ranks` ranks, for task `task`.
    pub fn new(task: &'static str, program: &str, variant: &'static str, ranks: usize) -> Self {
        Self { task, program: program.into(), variant, ranks }
    }

    /// Checks that the output of the official run, n = 1000 and seed 1, equals the reference
    /// program's output byte for byte.
    ///
    /// # Panics
    /// If the bytes differ, or the job fails.
    pub fn official_bytes(&self) {
        let folder = folder();
        let out = folder.path().join("out.txt");
        self.job().args(["-n", "1000", "-s", "1", "-o"]).arg(&out).succeed();
        let bytes = std::fs::read(&out)
            .unwrap_or_else(|e| panic!("{}: the program wrote no output: {e}", self.name()));
        let digest = sha256(&bytes);
        if digest != OFFICIAL_SHA256 {
            panic!(
                "{}: the official output differs from the output of the reference program (the sha256 of your output \
                 is {digest})",
                self.name()
            );
        }
    }

    /// Checks that the job ends when a rank is killed in the middle of a run.
    ///
    /// # Panics
    /// If the job does not end, or a short run fails.
    pub fn ends_when_a_rank_is_killed(&self) {
        let folder = folder();
        // Only a correct program can be killed in the middle of a run.
        self.job().args(["--steps", "3"]).succeed();
        let out = folder.path().join("never-complete.txt");
        // The limit covers the start of the ranks, the kill, and its detection.
        let job = self.job().within(60).args(["--steps", "100000000", "-o"]).arg(&out);
        ends_when_a_rank_is_killed(&self.name(), &job, &out);
    }

    fn job(&self) -> Job {
        Job::new(self.task, &self.program, self.ranks).args(["--variant", self.variant]).within(30)
    }

    /// Returns the beginning of messages: `task 5.8, variant through-root, 3 ranks`.
    fn name(&self) -> String {
        format!("task {}, variant {}, {}", self.task, self.variant, count(self.ranks))
    }
}

fn folder() -> TempDir {
    tempfile::tempdir().expect("the temporary folder is writable")
}
