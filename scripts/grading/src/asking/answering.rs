//! Runs a submission's program on one question and keeps its answers.

use std::fs::File;
use std::io::{self, Read};
use std::net::Shutdown;
use std::os::fd::OwnedFd;
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result};
use tempfile::TempDir;

use super::ANSWER;
use super::question_list::Question;
use crate::sandbox::Sandbox;
use lab_kit::process::{Finished, run_with};

/// Greatest length of all answers to a question, in bytes.
const MOST: u64 = 1 << 28;

/// Name of the file with the answers.
const FILE: &str = "answers";

/// Result of running a program on a question.
pub(super) struct Answers {
    pub(super) finished: Finished,
    folder: TempDir,
}

impl Answers {
    /// Runs the program on a question.
    ///
    /// The program writes its answers to a socket, which is its standard input when it starts. A
    /// socket cannot be opened by a path, so the code of a submission cannot write to it.
    pub(super) fn of(
        sandbox: &Sandbox,
        folder: &Path,
        question: &Question,
        seed: u64,
        limit: Duration,
    ) -> Result<Self> {
        let kept = sandbox.folder()?;
        let mut file = File::create(kept.path().join(FILE))?;
        let (ours, theirs) = UnixStream::pair()?;
        let mut command = sandbox.program(folder, ANSWER);
        command.args([&question.test, &seed.to_string()]);
        let (finished, copied) = thread::scope(|scope| {
            let copying = scope.spawn(|| {
                let copied = io::copy(&mut (&ours).take(MOST), &mut file);
                close(&ours);
                copied
            });
            let finished = run_with(&mut command, OwnedFd::from(theirs).into(), limit);
            // A remaining process of the program may keep the other end open. The answers that are
            // already in the socket can still be read.
            close(&ours);
            (finished, copying.join().expect("copying does not panic"))
        });
        copied.context("cannot keep the answers")?;
        Ok(Self { finished: finished?, folder: kept })
    }

    /// Returns the path of the file with the answers.
    pub(super) fn file(&self) -> PathBuf {
        self.folder.path().join(FILE)
    }
}

fn close(socket: &UnixStream) {
    // If the other end is closed already, an error here does no harm.
    let _ = socket.shutdown(Shutdown::Both);
}
