//! Runs a submission's program on one question and keeps its answers.

use std::fs::{self, Permissions};
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::Result;
use tempfile::TempDir;

use super::ANSWER;
use super::question_list::Question;
use crate::sandbox::Sandbox;
use lab_kit::process::{Finished, run as run_process};

/// Result of running a program on a question.
pub(super) struct Answers {
    pub(super) finished: Finished,
    folder: TempDir,
}

impl Answers {
    /// Runs the program on a question.
    ///
    /// The program writes its answers to a separate file, so its other output does not matter. It
    /// can write anything to that file, but only right answers count.
    pub(super) fn of(
        sandbox: &Sandbox,
        folder: &Path,
        question: &Question,
        seed: u64,
        limit: Duration,
    ) -> Result<Self> {
        let written = sandbox.folder()?;
        let file = written.path().join("answers");
        fs::write(&file, "")?;
        // The program runs as the user nobody.
        fs::set_permissions(&file, Permissions::from_mode(0o666))?;
        let mut command = sandbox.program(folder, ANSWER, Some(&file));
        command.args([&question.test, &seed.to_string()]);
        Ok(Self { finished: run_process(&mut command, limit)?, folder: written })
    }

    /// Returns the path of the file with the answers.
    pub(super) fn file(&self) -> PathBuf {
        self.folder.path().join("answers")
    }
}
