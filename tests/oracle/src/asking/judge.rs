//! Questions in the grader's program, which compares the answers that a submission's program wrote.

use std::fs::File;
use std::io::{self, BufReader};
use std::path::Path;

use super::Ask;
use super::wire::{END, read, to_numbers};
use crate::right::different_tables;

/// A judge that reads a submission's answers from a file.
pub struct Judge {
    answers: BufReader<File>,
    /// Table of the worked example.
    snapshot: String,
    /// Number of questions so far, and number of correct answers.
    asked: usize,
    right: usize,
    /// Error of the first wrong answer.
    wrong: Option<String>,
    /// Whether the file contains no further answer.
    ended: bool,
}

/// Result of a question's answers.
#[derive(Debug, PartialEq)]
pub struct Verdict {
    /// Number of requested answers.
    pub asked: usize,
    /// Number of correct answers.
    pub right: usize,
    /// Error of the first wrong answer. `None` if every answer is correct and there is no further
    /// answer.
    pub wrong: Option<String>,
    /// Whether the answers broke off. In this case `wrong` names the question at which they broke
    /// off.
    pub broke_off: bool,
}

impl Judge {
    /// Returns a judge for the answers in the file at `path`. If the question is a worked example,
    /// `snapshot` is the text of its snapshot.
    ///
    /// # Errors
    /// If the file does not exist.
    pub fn new(path: &Path, snapshot: &str) -> io::Result<Self> {
        let answers = BufReader::new(File::open(path)?);
        // The table follows the second line of dashes.
        let table = snapshot.splitn(3, "---\n").nth(2).unwrap_or_default().to_owned();
        Ok(Self { answers, snapshot: table, asked: 0, right: 0, wrong: None, ended: false })
    }

    /// Returns the result of all answers.
    pub fn end(mut self) -> Verdict {
        if !self.ended && self.wrong.is_none() {
            match read(&mut self.answers) {
                Ok((question, _)) if question == END => {}
                Ok(_) => {
                    self.wrong =
                        Some("the program gave more answers than there were questions".into())
                }
                Err(_) => {
                    self.ended = true;
                    self.wrong = Some("the answers broke off after the last question".into());
                }
            }
        }
        let Self { asked, right, wrong, ended: broke_off, .. } = self;
        Verdict { asked, right, wrong, broke_off }
    }

    /// Judges the next answer.
    fn next(&mut self, question: &str, verdict: impl FnOnce(Vec<u8>) -> Result<(), String>) {
        self.asked += 1;
        if self.ended {
            return;
        }
        let words = match read(&mut self.answers) {
            Ok((asked, answer)) if asked == question => verdict(answer),
            Ok((asked, _)) if asked != END => {
                Err(format!("the program answered a different question, '{asked}'"))
            }
            _ => {
                self.ended = true;
                Err("the program ended without an answer".into())
            }
        };
        match words {
            Ok(()) => self.right += 1,
            Err(words) if self.wrong.is_none() => self.wrong = Some(format!("{question}\n{words}")),
            Err(_) => {}
        }
    }
}

impl Ask for Judge {
    fn judge(
        &mut self,
        question: &str,
        _found: impl FnOnce() -> Vec<f64>,
        verdict: impl FnOnce(&[f64]) -> Result<(), String>,
    ) {
        self.next(question, |answer| match to_numbers(&answer) {
            Some(numbers) => verdict(&numbers),
            None => Err("the answer cannot be read".into()),
        });
    }

    fn example(&mut self, _table: impl FnOnce() -> String) {
        let expected = self.snapshot.clone();
        self.next("the worked example", |answer| {
            different_tables(&String::from_utf8_lossy(&answer), &expected)
        });
    }

    fn apart(&mut self, part: impl FnOnce(&mut Self)) {
        part(self);
    }

    fn in_tests_only(&mut self, _part: impl FnOnce()) {}

    #[cfg(unix)]
    fn on_ranks(
        &mut self,
        _task: &str,
        counts: &[usize],
        _on_this_rank: impl FnOnce(&mut Self),
        mut of_rank: impl FnMut(usize, usize, &mut Self),
    ) {
        for &ranks in counts {
            for rank in 0..ranks {
                of_rank(rank, ranks, self);
            }
        }
    }
}

#[cfg(all(test, unix))]
mod tests {
    use std::fs::File;

    use super::super::{Ask, Recorder};
    use super::Judge;

    const SNAPSHOT: &str = "---\nexpression: table\n---\na 1\nb 2\n";

    /// Asks for 6 and for a table.
    fn questions(ask: &mut impl Ask, answer: f64, table: &str) {
        ask.exact("how much is 2 times 3?", || vec![answer], || vec![6.0]);
        ask.example(|| table.into());
    }

    #[test]
    fn answers_are_judged_outside() {
        for (answer, table, right, wrong) in [
            (6.0, "a 1\nb 2\n", 2, None),
            (
                5.0,
                "a 1\nb 2\n",
                1,
                Some("how much is 2 times 3?\n     found: [5]\n  expected: [6]"),
            ),
            (
                6.0,
                "a 1\nb 3\n",
                1,
                Some("the worked example\n  a 1\n- b 2   expected\n+ b 3   found"),
            ),
        ] {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("answers");
            let mut recorder = Recorder::new(File::create(&path).unwrap());
            questions(&mut recorder, answer, table);
            recorder.end();
            let mut judge = Judge::new(&path, SNAPSHOT).unwrap();
            questions(&mut judge, f64::NAN, "");
            let verdict = judge.end();
            assert_eq!((verdict.asked, verdict.right, verdict.broke_off), (2, right, false));
            assert_eq!(verdict.wrong.as_deref(), wrong);
        }
    }

    #[test]
    fn answers_that_break_off_are_wrong() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("answers");
        let mut recorder = Recorder::new(File::create(&path).unwrap());
        recorder.exact("how much is 2 times 3?", || vec![6.0], || vec![6.0]);
        drop(recorder);
        let mut judge = Judge::new(&path, SNAPSHOT).unwrap();
        questions(&mut judge, 0.0, "");
        let verdict = judge.end();
        assert_eq!((verdict.asked, verdict.right, verdict.broke_off), (2, 1, true));
        assert_eq!(
            verdict.wrong.as_deref(),
            Some("the worked example\nthe program ended without an answer")
        );
    }
}
