//! Questions in the program that runs a submission. Answers are written to a file; the program
//! cannot know whether they are correct.

use std::fs::File;
use std::io::Write;
use std::path::Path;
#[cfg(unix)]
use std::process::exit;

use super::Ask;
#[cfg(unix)]
use super::ranks;
use super::wire::{END, to_bytes, write};

/// A recorder that writes a submission's answers to a file.
pub struct Recorder(File);

impl Recorder {
    /// Returns a recorder that appends to the file at `path`.
    ///
    /// # Panics
    /// If the file cannot be written. This holds for every method.
    pub fn new(path: &Path) -> Self {
        let file = File::options().append(true).create(true).open(path);
        Self(file.expect("the file of answers can be written"))
    }

    /// Records that the last question has been answered.
    pub fn end(mut self) {
        self.add(END, &[]);
    }

    fn add(&mut self, question: &str, answer: &[u8]) {
        // The write is not buffered, because the next question may end this process.
        write(&mut self.0, question, answer).expect("the file of answers can be written");
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

    /// Starts this program again as the ranks of each job. Each rank writes a file of its own, and
    /// these files are concatenated in the file of answers.
    #[cfg(unix)]
    fn on_ranks(
        &mut self,
        _task: &str,
        counts: &[usize],
        on_this_rank: impl FnOnce(&mut Self),
        _of_rank: impl FnMut(usize, usize, &mut Self),
    ) {
        if let Some(file) = ranks::file_of_this_rank() {
            on_this_rank(&mut Self(file));
            exit(0);
        }
        for &count in counts {
            let answers = ranks::run(count);
            self.0.write_all(&answers).expect("the file of answers can be written");
        }
    }
}
