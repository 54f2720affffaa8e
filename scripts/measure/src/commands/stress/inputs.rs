//! Bad inputs. A program must refuse each of them with a one-line message that names the fault.

use std::fs;
use std::path::Path;
use std::time::Duration;

use anyhow::{Context, Result};
use lab_kit::process;
use serde::Serialize;

use super::engine::Lab;

use Give::{Scene, Words};

/// Longest time in which a program must refuse an input.
const LIMIT: Duration = Duration::from_secs(60);

/// An input that must be refused: its name, its form, and a word that the answer must contain.
pub(super) struct Bad(&'static str, Give, &'static str);

enum Give {
    /// The text of a scene file.
    Scene(&'static str),
    /// Words on the command line.
    Words(&'static [&'static str]),
}

/// The answer of a program to a bad input.
#[derive(Serialize)]
pub(super) struct Input {
    pub(super) input: &'static str,
    pub(super) refused: bool,
    /// The program's message if it refused the input, otherwise its mistake.
    pub(super) answer: String,
}

pub(super) const BAD: &[Bad] = &[
    Bad("a position that is no number", Scene("2 1\n0.5 0.5 0 0\nNaN 0.5 0 0\n"), "particle 1"),
    Bad("an infinite velocity", Scene("2 1\n0.5 0.5 0 0\n0.5 0.5 0 -inf\n"), "particle 1"),
    Bad("a velocity of 1e400", Scene("1 1\n0.5 0.5 1e400 0\n"), "particle 0"),
    Bad("an ulp outside the wall", Scene("1 1\n0.5 1.0000000000000002 0 0\n"), "particle 0"),
    Bad("the least number below 0", Scene("1 1\n-5e-324 0.5 0 0\n"), "particle 0"),
    Bad("a box of side 0", Scene("1 0\n0 0 0 0\n"), "0"),
    Bad("a box of side -1", Scene("1 -1\n0 0 0 0\n"), "-1"),
    Bad("a box without end", Scene("1 inf\n0 0 0 0\n"), "inf"),
    Bad("a box that is no number", Scene("1 NaN\n0 0 0 0\n"), "NaN"),
    Bad("no particles", Scene("0 1\n"), "particle"),
    Bad("fewer particles than promised", Scene("1000000000 1\n0.5 0.5 0 0\n"), "1 of 1000000000"),
    Bad("more particles than can be", Scene("4000000000 1\n0.5 0.5 0 0\n"), "4000000000"),
    Bad("three numbers", Scene("1 1\n0.5 0.5 0\n"), "line 2"),
    Bad("a word", Scene("1 1\n0.5 0.5 fast 0\n"), "line 2"),
    Bad("an empty file", Scene(""), "line 1"),
    Bad("a file that is not there", Words(&["--scene", "no/such/file"]), "no/such/file"),
    Bad("n = 0", Words(&["-n", "0"]), "particle"),
    Bad("n = -5", Words(&["-n=-5"]), "-5"),
    Bad("n = 1e18", Words(&["-n", "1000000000000000000"]), "1000000000000000000"),
    Bad("seed 0", Words(&["-s", "0"]), "seed"),
    Bad("0 threads", Words(&["-t", "0"]), "0"),
    Bad("no such parameter", Words(&["--param", "nothing=1"]), "nothing"),
    Bad("no such variant", Words(&["--variant", "nothing"]), "nothing"),
    Bad("output every 0 steps", Words(&["--every", "0"]), "0"),
    Bad("output where none can be", Words(&["-n", "9", "-o", "/dev/null/x"]), "/dev/null/x"),
];

impl Bad {
    /// Gives the input to a program.
    pub(super) fn give(&self, lab: &Lab) -> Result<Input> {
        let Self(name, give, word) = self;
        let mut program = lab.program.clone();
        if let Words(_) = give {
            // The words may choose a variant themselves.
            program.variant = None;
            program.parameters.clear();
        }
        let mut command = lab.runner.command(&program, 2)?;
        match give {
            Scene(text) => {
                let file = lab.runner.folder().join("bad.txt");
                fs::write(&file, text).context("cannot write a scene")?;
                command.arg("--scene").arg(&file);
            }
            Words(words) => {
                command.args(*words);
            }
        }
        let done = process::run(command.args(["--steps", "1"]), LIMIT)?;
        let code = done.status.and_then(|status| status.code());
        let answer = judged(word, code, &done.stderr, lab.runner.folder());
        let refused = answer.is_ok();
        Ok(Input { input: name, refused, answer: answer.unwrap_or_else(|mistake| mistake) })
    }
}

/// Judges an exit code and the error output. Returns the message of a good answer; an error
/// describes the mistake.
fn judged(word: &str, code: Option<i32>, stderr: &str, folder: &Path) -> Result<String, String> {
    // With several ranks, the launcher adds messages below.
    let line = stderr.lines().find(|line| line.starts_with("error: "));
    match (code, line) {
        (None, _) => Err("no answer, or ended by a signal".into()),
        (Some(0), _) => Err("it took it".into()),
        _ if stderr.contains("panicked") => Err("it panicked".into()),
        (_, None) => {
            let first = stderr.lines().find(|line| !line.trim().is_empty());
            Err(format!("it printed {:?}", first.unwrap_or("nothing")))
        }
        (_, Some(line)) if !line.contains(word) => Err(format!("'{line}' does not name {word}")),
        (_, Some(line)) => {
            let line = line.trim_start_matches("error: ");
            Ok(line.replace(&format!("{}/", folder.display()), ""))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged_line(code: Option<i32>, text: &str) -> Result<String, String> {
        judged("particle 1", code, text, Path::new("/tmp/x"))
    }

    #[test]
    fn an_answer_must_be_one_line_that_names_the_fault() {
        let line = "error: /tmp/x/bad.txt: particle 1: vx is inf\n";
        assert_eq!(judged_line(Some(1), line), Ok("bad.txt: particle 1: vx is inf".into()));
        for (code, text) in [
            (Some(0), line),
            (None, line),
            (Some(1), ""),
            (Some(1), "error: bad scene\n"),
            (Some(101), "thread 'main' panicked at x.rs:1:1:\nerror: particle 1\n"),
        ] {
            assert!(judged_line(code, text).is_err(), "{code:?} {text}");
        }
    }
}
