//! A program that answers a question.

use std::fs::{self, Permissions};
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::Result;
use tempfile::TempDir;

use super::ANSWER;
use super::table::Question;
use crate::sandbox::Sandbox;
use lab_kit::process::{Finished, run as run_process};

/// What a program did to answer a question.
pub(super) struct Answers {
    pub(super) finished: Finished,
    folder: TempDir,
}

impl Answers {
    /// Has a program answer. The answers come in a file of their own, whatever the program prints. It could
    /// write anything there, but only right answers count, whoever writes them.
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
        // Programs run as nobody.
        fs::set_permissions(&file, Permissions::from_mode(0o666))?;
        let mut command = sandbox.program(folder, ANSWER, Some(&file));
        command.args([&question.test, &seed.to_string()]);
        Ok(Self { finished: run_process(&mut command, limit)?, folder: written })
    }

    /// The file of its answers.
    pub(super) fn file(&self) -> PathBuf {
        self.folder.path().join("answers")
    }
}
