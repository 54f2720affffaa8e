//! Lines and words of an input, and the place of an error in it.

use std::fmt::Display;
use std::io::{self, BufRead};
use std::str::FromStr;

use thiserror::Error;

/// The reason why an input is not valid.
#[derive(Debug, Error)]
pub enum InputError {
    /// The input cannot be read.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// A field has the wrong form, or the fields do not make a valid scene.
    #[error("line {line}: {what}")]
    Line {
        /// Number of the line, counted from 1; the last line if the input ends too early.
        line: usize,
        /// The field and the reason.
        what: String,
    },
}

/// An input that is read line by line and, within a line, word by word.
pub(super) struct Words<R> {
    input: R,
    text: String,
    at: usize,
    line: usize,
}

impl<R: BufRead> Words<R> {
    /// Starts before the first line.
    pub(super) fn new(input: R) -> Self {
        Self { input, text: String::new(), at: 0, line: 0 }
    }

    /// Goes to the next line that is not blank. Returns false at the end of the input.
    pub(super) fn next_line(&mut self) -> Result<bool, InputError> {
        loop {
            self.text.clear();
            self.at = 0;
            if self.input.read_line(&mut self.text)? == 0 {
                return Ok(false);
            }
            self.line += 1;
            // Some editors on Windows begin a file with an invisible mark.
            if self.line == 1 && self.text.starts_with('\u{feff}') {
                self.at = '\u{feff}'.len_utf8();
            }
            if !self.text[self.at..].trim().is_empty() {
                return Ok(true);
            }
        }
    }

    /// Returns the next word of this line, or `None` at its end.
    pub(super) fn word(&mut self) -> Option<&str> {
        let rest = &self.text[self.at..];
        let start = self.at + rest.find(|c: char| !c.is_whitespace())?;
        let word = &self.text[start..];
        self.at = start + word.find(char::is_whitespace).unwrap_or(word.len());
        Some(&self.text[start..self.at])
    }

    /// Reads a field of the head, on this line or on a later line.
    pub(super) fn head<T: FromStr>(
        &mut self,
        field: &str,
        expected: &'static str,
        good: impl FnOnce(&T) -> bool,
    ) -> Result<T, InputError> {
        if self.text[self.at..].trim().is_empty() && !self.next_line()? {
            return Err(self.error(format_args!("{field} is missing")));
        }
        self.field(field, expected, good)
    }

    /// Reads a field of this line.
    pub(super) fn field<T: FromStr>(
        &mut self,
        field: impl Display,
        expected: &'static str,
        good: impl FnOnce(&T) -> bool,
    ) -> Result<T, InputError> {
        let Some(word) = self.word() else {
            return Err(self.error(format_args!("{field} is missing")));
        };
        if let Some(value) = word.parse().ok().filter(good) {
            return Ok(value);
        }
        let found = shortened(word);
        Err(self.error(format_args!("{field}: expected {expected}, found '{found}'")))
    }

    /// Checks that this line has no more words.
    pub(super) fn end_of_line(&mut self, after: &str) -> Result<(), InputError> {
        let found = self.word().map(shortened);
        found.map_or(Ok(()), |found| Err(self.error(format_args!("'{found}' after {after}"))))
    }

    /// Returns an error with the number of the line.
    pub(super) fn error(&self, what: impl Display) -> InputError {
        InputError::Line { line: self.line.max(1), what: what.to_string() }
    }
}

fn shortened(word: &str) -> String {
    word.chars().take(40).collect()
}
