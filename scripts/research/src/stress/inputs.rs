//! Input that no program may take: each must be refused with one line that says what is wrong.

use std::fs;
use std::time::Duration;

use anyhow::{Context, Result};

use super::engine::Lab;
use lab_kit::process;

use Give::{Scene, Words};

const LIMIT: Duration = Duration::from_secs(60);

/// Something to refuse: what it is, how it is given, and a word of the answer.
pub(super) type Bad = (&'static str, Give, &'static str);

pub(super) enum Give {
    /// This text as a scene file.
    Scene(&'static str),
    /// These words on the command line.
    Words(&'static [&'static str]),
}

/// All of them.
pub(super) const BAD: &[Bad] = &[
    ("a position that is no number", Scene("2 1\n0.5 0.5 0 0\nNaN 0.5 0 0\n"), "particle 1"),
    ("an infinite velocity", Scene("2 1\n0.5 0.5 0 0\n0.5 0.5 0 -inf\n"), "particle 1"),
    ("a velocity of 1e400", Scene("1 1\n0.5 0.5 1e400 0\n"), "particle 0"),
    ("an ulp outside the wall", Scene("1 1\n0.5 1.0000000000000002 0 0\n"), "particle 0"),
    ("the least number below 0", Scene("1 1\n-5e-324 0.5 0 0\n"), "particle 0"),
    ("a box of side 0", Scene("1 0\n0 0 0 0\n"), "0"),
    ("a box of side -1", Scene("1 -1\n0 0 0 0\n"), "-1"),
    ("a box without end", Scene("1 inf\n0 0 0 0\n"), "inf"),
    ("a box that is no number", Scene("1 NaN\n0 0 0 0\n"), "NaN"),
    ("no particles", Scene("0 1\n"), "particle"),
    ("fewer particles than promised", Scene("1000000000 1\n0.5 0.5 0 0\n"), "1 of 1000000000"),
    ("more particles than can be", Scene("4000000000 1\n0.5 0.5 0 0\n"), "4000000000"),
    ("three numbers", Scene("1 1\n0.5 0.5 0\n"), "line 2"),
    ("a word", Scene("1 1\n0.5 0.5 fast 0\n"), "line 2"),
    ("an empty file", Scene(""), "line 1"),
    ("a file that is not there", Words(&["--scene", "no/such/file"]), "no/such/file"),
    ("n = 0", Words(&["-n", "0"]), "particle"),
    ("n = -5", Words(&["-n=-5"]), "-5"),
    ("n = 1e18", Words(&["-n", "1000000000000000000"]), "1000000000000000000"),
    ("seed 0", Words(&["-s", "0"]), "seed"),
    ("0 threads", Words(&["-t", "0"]), "0"),
    ("no such parameter", Words(&["--param", "nothing=1"]), "nothing"),
    ("no such variant", Words(&["--variant", "nothing"]), "nothing"),
    ("output every 0 steps", Words(&["--every", "0"]), "0"),
    ("output where none can be", Words(&["-n", "9", "-o", "/dev/null/x"]), "/dev/null/x"),
];

/// What a program says to bad input; an error if it takes it, or does not say it well.
pub(super) fn refuse(lab: &Lab, (_, give, word): &Bad) -> Result<Result<String, String>> {
    let mut program = lab.program.clone();
    if let Words(_) = give {
        // They may choose a variant themselves.
        (program.variant, program.parameters) = (None, Vec::new());
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
    Ok(said(word, done.status.and_then(|status| status.code()), &done.stderr, lab.runner.folder()))
}

/// Judges an exit code and what was said on the error stream.
fn said(
    word: &str,
    code: Option<i32>,
    stderr: &str,
    folder: &std::path::Path,
) -> Result<String, String> {
    let lines: Vec<&str> = stderr.lines().filter(|line| !line.trim().is_empty()).collect();
    // A launcher of several ranks adds its own words below ours.
    let line = lines.iter().find(|line| line.starts_with("error: ")).copied();
    match (code, line) {
        (None, _) => Err("no answer, or ended by a signal".into()),
        (Some(0), _) => Err("it took it".into()),
        _ if stderr.contains("panicked") => Err("it panicked".into()),
        (_, None) => Err(format!("it said {:?}", lines.first().unwrap_or(&"nothing"))),
        (_, Some(line)) if !line.contains(word) => Err(format!("'{line}' does not name {word}")),
        (_, Some(line)) => {
            let line = line.trim_start_matches("error: ");
            Ok(line.replace(&format!("{}/", folder.display()), ""))
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn an_answer_must_be_one_line_that_names_the_fault() {
        let said = |code, text| said("particle 1", code, text, Path::new("/tmp/x"));
        let line = "error: /tmp/x/bad.txt: particle 1: vx is inf\n";
        assert_eq!(said(Some(1), line), Ok("bad.txt: particle 1: vx is inf".into()));
        for (code, text) in [
            (Some(0), line),
            (None, line),
            (Some(1), ""),
            (Some(1), "error: bad scene\n"),
            (Some(101), "thread 'main' panicked at x.rs:1:1:\nerror: particle 1\n"),
        ] {
            assert!(said(code, text).is_err(), "{code:?} {text}");
        }
    }
}
