//! Questions in the program that runs a submission. Answers are sent to the grader; the program
//! cannot know whether they are correct.

use std::fs::File;
use std::io::{self, Write};
use std::os::fd::{AsFd, OwnedFd};
use std::process::exit;

use super::Ask;
use super::ranks;
use super::wire::{END, to_bytes, write};

/// A recorder that writes a submission's answers to a file or a socket.
///
/// # Panics
/// Each method panics if it cannot write.
pub struct Recorder(File);

impl Recorder {
    /// Returns a recorder that writes to `file`.
    pub fn new(file: File) -> Self {
        Self(file)
    }

    /// Returns a recorder that writes to the standard input, which the grader has connected to a
    /// socket. The function then replaces the standard input by an empty one, so that the
    /// submission's code does not get the socket.
    ///
    /// # Errors
    /// If the system cannot replace the standard input.
    pub fn to_grader() -> io::Result<Self> {
        let socket = io::stdin().as_fd().try_clone_to_owned()?;
        rustix::stdio::dup2_stdin(File::open("/dev/null")?)?;
        Ok(Self(socket.into()))
    }

    /// Records that the last question has been answered.
    pub fn end(mut self) {
        self.add(END, &[]);
    }

    fn add(&mut self, question: &str, answer: &[u8]) {
        // The write is not buffered, because the next question may end this process.
        write(&mut self.0, question, answer).expect("the answers can be written");
    }
}

impl Ask for Recorder {
    fn judge(
        &mut self,
        question: &str,
        found: impl FnOnce() -> Vec<f64>,
        _verdict: impl FnOnce(&[f64]) -> Result<(), String>,
    ) {
        self.add(question, &to_bytes(&found()));
    }

    fn example(&mut self, table: impl FnOnce() -> String) {
        self.add("the worked example", table().as_bytes());
    }

    fn apart(&mut self, part: impl FnOnce(&mut Self)) {
        part(self);
    }

    fn in_tests_only(&mut self, _part: impl FnOnce()) {}

    /// Starts this program again as the ranks of each job. Each rank sends its answers to this
    /// process, which writes them one rank after the other.
    fn on_ranks(
        &mut self,
        _task: &str,
        counts: &[usize],
        on_this_rank: impl FnOnce(&mut Self),
        _of_rank: impl FnMut(usize, usize, &mut Self),
    ) {
        if let Some(stream) = ranks::connect() {
            on_this_rank(&mut Self(OwnedFd::from(stream).into()));
            exit(0);
        }
        for &count in counts {
            let answers = ranks::run(count);
            self.0.write_all(&answers).expect("the answers can be written");
        }
    }
}
