//! Input that no program may take: each must be refused with one line that says what is wrong.

use std::fs;
use std::time::Duration;

use anyhow::{Context, Result};

use super::engine::Lab;
use lab_kit::process;

const LIMIT: Duration = Duration::from_secs(60);

/// Something to refuse.
pub(super) struct Bad {
    pub(super) what: &'static str,
    give: Give,
    /// A word of the answer.
    names: &'static str,
}

enum Give {
    /// This text as a scene file.
    Scene(&'static str),
    /// These words on the command line.
    Words(&'static [&'static str]),
}

const fn scene(what: &'static str, text: &'static str, names: &'static str) -> Bad {
    Bad { what, give: Give::Scene(text), names }
}

const fn words(what: &'static str, words: &'static [&'static str], names: &'static str) -> Bad {
    Bad { what, give: Give::Words(words), names }
}

/// All of them.
pub(super) const BAD: &[Bad] = &[
    scene("a position that is no number", "2 1\n0.5 0.5 0 0\nNaN 0.5 0 0\n", "particle 1"),
    scene("an infinite velocity", "2 1\n0.5 0.5 0 0\n0.5 0.5 0 -inf\n", "particle 1"),
    scene("a velocity of 1e400", "1 1\n0.5 0.5 1e400 0\n", "particle 0"),
    scene("an ulp outside the wall", "1 1\n0.5 1.0000000000000002 0 0\n", "particle 0"),
    scene("the least number below 0", "1 1\n-5e-324 0.5 0 0\n", "particle 0"),
    scene("a box of side 0", "1 0\n0 0 0 0\n", "0"),
    scene("a box of side -1", "1 -1\n0 0 0 0\n", "-1"),
    scene("a box without end", "1 inf\n0 0 0 0\n", "inf"),
    scene("a box that is no number", "1 NaN\n0 0 0 0\n", "NaN"),
    scene("no particles", "0 1\n", "particle"),
    scene("fewer particles than promised", "1000000000 1\n0.5 0.5 0 0\n", "1 of 1000000000"),
    scene("more particles than can be", "4000000000 1\n0.5 0.5 0 0\n", "4000000000"),
    scene("three numbers", "1 1\n0.5 0.5 0\n", "line 2"),
    scene("a word", "1 1\n0.5 0.5 fast 0\n", "line 2"),
    scene("an empty file", "", "line 1"),
    words("a file that is not there", &["--scene", "no/such/file"], "no/such/file"),
    words("n = 0", &["-n", "0"], "particle"),
    words("n = -5", &["-n=-5"], "-5"),
    words("n = 1e18", &["-n", "1000000000000000000"], "1000000000000000000"),
    words("seed 0", &["-s", "0"], "seed"),
    words("0 threads", &["-t", "0"], "0"),
    words("no such parameter", &["--param", "nothing=1"], "nothing"),
    words("no such variant", &["--variant", "nothing"], "nothing"),
    words("output every 0 steps", &["--every", "0"], "0"),
    words("output where none can be", &["-n", "9", "-o", "/dev/null/x"], "/dev/null/x"),
];

/// What a program says to bad input; an error if it takes it, or does not say it well.
pub(super) fn refuse(lab: &Lab, bad: &Bad) -> Result<Result<String, String>> {
    let mut program = lab.program.clone();
    if let Give::Words(_) = bad.give {
        // They may choose a variant themselves.
        (program.variant, program.parameters) = (None, Vec::new());
    }
    let mut command = lab.runner.command(&program, 2)?;
    match bad.give {
        Give::Scene(text) => {
            let file = lab.runner.folder().join("bad.txt");
            fs::write(&file, text).context("cannot write a scene")?;
            command.arg("--scene").arg(&file);
        }
        Give::Words(words) => {
            command.args(words);
        }
    }
    let done = process::run(command.args(["--steps", "1"]), LIMIT)?;
    Ok(said(bad, done.status.and_then(|status| status.code()), &done.stderr, lab.runner.folder()))
}

/// Judges an exit code and what was said on the error stream.
fn said(
    bad: &Bad,
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
        (_, Some(line)) if !line.contains(bad.names) => {
            Err(format!("'{line}' does not name {}", bad.names))
        }
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
        let bad = scene("x", "", "particle 1");
        let said = |code, text| said(&bad, code, text, Path::new("/tmp/x"));
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
