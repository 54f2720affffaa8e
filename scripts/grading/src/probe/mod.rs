//! Asking a submission and the solution the same, and comparing.

mod runs;

use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::time::Duration;

use anyhow::{Context, Result, ensure};

use crate::sandbox::{Sandbox, is_launcher};
use lab_kit::process::run as run_process;

/// Two results that differ by rounding differ by at most so much, relative to 1 + their size.
const CLOSE: f64 = 1e-10;

/// What is said of a program that was ended by us or by the system.
const KILLED: &str = "it was ended: it needed more memory than it may have";

/// A sandbox that did not start is tried again so often, after so long.
const RETRIES: usize = 3;
const PAUSE: Duration = Duration::from_secs(2);

/// The name of the probe program in its folder.
pub(crate) const PROGRAM: &str = "probe";

/// What a program said to one question.
#[derive(Debug, PartialEq)]
pub(crate) struct Answer {
    how: How,
    question: String,
    values: Vec<f64>,
}

/// How an answer is compared with the solution's.
#[derive(Clone, Copy, Debug, PartialEq)]
enum How {
    /// It is the same.
    Exact,
    /// It differs by rounding.
    Close,
    /// It is a run that the model follows.
    Steps,
    /// It is a run with the same bits.
    Bits,
}

impl How {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "exact" => Self::Exact,
            "close" => Self::Close,
            "steps" => Self::Steps,
            "bits" => Self::Bits,
            _ => return None,
        })
    }
}

/// What the solution answers; it must.
pub(crate) fn reference(
    sandbox: &Sandbox,
    folder: &Path,
    task: &str,
    seed: u64,
) -> Result<Vec<Answer>> {
    let nonce = nonce(seed, task);
    let mut command = sandbox.program(folder, PROGRAM);
    command.args([task, &seed.to_string(), &nonce]);
    let finished = run_process(&mut command, sandbox.limits().run)?;
    let answers = answers(&finished.stdout, &nonce).context("the solution's probe is malformed")?;
    let ended = answers.last().is_some_and(|last| last.question == "end");
    ensure!(
        ended && answers.len() > 1,
        "the solution's probe of task {task} broke off: {}",
        finished.stderr
    );
    Ok(answers)
}

/// What is wrong with a submission's answers; none if nothing is.
pub(crate) fn wrong(
    sandbox: &Sandbox,
    folder: &Path,
    task: &str,
    seed: u64,
    expected: &[Answer],
) -> Result<Option<String>> {
    let nonce = nonce(seed, task);
    let mut command = sandbox.program(folder, PROGRAM);
    command.args([task, &seed.to_string(), &nonce]);
    let mut finished = run_process(&mut command, sandbox.limits().run)?;
    // A busy machine may refuse the sandbox itself a process: that is nobody's mistake.
    for _ in 0..RETRIES {
        if !(finished.stdout.is_empty() && is_launcher(&finished.stderr)) {
            break;
        }
        std::thread::sleep(PAUSE);
        finished = run_process(&mut command, sandbox.limits().run)?;
    }
    let Some(given) = answers(&finished.stdout, &nonce) else {
        return Ok(Some("its answers are malformed".into()));
    };
    let difference = compare(expected, &given);
    Ok(match difference {
        Some(what) if given.len() < expected.len() => Some(match finished.status {
            None => format!("no answer within {} s", sandbox.limits().run.as_secs()),
            Some(status) if status.signal() == Some(9) => KILLED.into(),
            Some(_) if is_launcher(&finished.stderr) => first_line(&finished.stderr),
            Some(_) => panic_of(&finished.stderr).unwrap_or(what),
        }),
        other => other,
    })
}

/// The parts of the answers that a program wrote; none if a line with our mark is no answer.
fn answers(stdout: &str, nonce: &str) -> Option<Vec<Answer>> {
    let mark = format!("@{nonce} ");
    let lines = stdout.lines().filter_map(|line| line.strip_prefix(&mark));
    lines
        .map(|line| {
            let mut parts = line.splitn(3, '|');
            let how = How::named(parts.next()?)?;
            let question = parts.next()?.to_owned();
            let bits = parts.next()?.split_whitespace();
            let values = bits.map(|bits| Some(f64::from_bits(u64::from_str_radix(bits, 16).ok()?)));
            Some(Answer { how, question, values: values.collect::<Option<_>>()? })
        })
        .collect()
}

/// How strictly is the solution's to say: a submission's own word on that is not heard.
fn compare(expected: &[Answer], given: &[Answer]) -> Option<String> {
    for (index, right) in expected.iter().enumerate() {
        let question = &right.question;
        let Some(answer) = given.get(index) else {
            return Some(format!("it ended without an answer to: {question}"));
        };
        if answer.question != *question {
            return Some(format!("it answered '{}' to: {question}", answer.question));
        }
        let wrong = match right.how {
            How::Exact => differs(&right.values, &answer.values, |got, want| {
                got == want || got.is_nan() && want.is_nan()
            }),
            How::Close => differs(&right.values, &answer.values, |got, want| {
                (got - want).abs() <= CLOSE * (1.0 + want.abs())
            }),
            How::Steps => runs::off_the_model(&right.values, &answer.values),
            How::Bits => runs::other_bits(&right.values, &answer.values),
        };
        if let Some(words) = wrong {
            return Some(format!("{question}: {words}"));
        }
    }
    (given.len() > expected.len()).then(|| "it gave more answers than there were questions".into())
}

/// As people write it: 103, 0.25, 1e-12.
fn number(value: f64) -> String {
    let plain = value == 0.0 || (1e-4..1e9).contains(&value.abs());
    if plain { value.to_string() } else { format!("{value:e}") }
}

fn differs(right: &[f64], given: &[f64], same: impl Fn(f64, f64) -> bool) -> Option<String> {
    let list = |values: &[f64]| match values {
        [] => "nothing".to_owned(),
        some => some.iter().map(|value| number(*value)).collect::<Vec<_>>().join(", "),
    };
    let place = given.iter().zip(right).position(|(got, want)| !same(*got, *want));
    match place {
        None if given.len() == right.len() => None,
        _ if given.len().max(right.len()) <= 8 => {
            Some(format!("{}; right is {}", list(given), list(right)))
        }
        None => Some(format!("{} values, not {}", given.len(), right.len())),
        Some(at) => {
            Some(format!("value {} is {}, not {}", at + 1, number(given[at]), number(right[at])))
        }
    }
}

fn first_line(text: &str) -> String {
    text.lines().next().unwrap_or_default().chars().take(300).collect()
}

fn panic_of(stderr: &str) -> Option<String> {
    let mut lines = stderr.lines().skip_while(|line| !line.contains(" panicked at "));
    lines.next()?;
    Some(lines.next()?.chars().take(300).collect())
}

/// Marks our lines among whatever a program prints. It is no secret to the program: only right
/// answers count, whoever writes them.
fn nonce(seed: u64, task: &str) -> String {
    use hmac_sha256::Hash;
    let digest = Hash::hash(format!("{seed} {task} {}", std::process::id()).as_bytes());
    digest.iter().take(8).map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::How::{Close, Exact};
    use super::{Answer, How, answers, compare, number};

    fn answer(how: How, values: &[f64]) -> Answer {
        Answer { how, question: "q".into(), values: values.to_vec() }
    }

    #[test]
    fn only_marked_lines_are_answers() {
        let said = "hello\n\n@ab exact|q|3ff0000000000000\n@cd exact|q|0\n";
        assert_eq!(answers(said, "ab"), Some(vec![answer(Exact, &[1.0])]));
        assert_eq!(answers("@ab nonsense", "ab"), None);
    }

    #[test]
    fn numbers_are_written_as_people_do() {
        let all = [103.0, 0.25, 0.0, -3.5e-11, 1e12, f64::NAN];
        assert_eq!(all.map(number), ["103", "0.25", "0", "-3.5e-11", "1e12", "NaN"]);
    }

    #[test]
    fn the_solution_says_how_strictly() {
        let right = [answer(Exact, &[1.0])];
        assert_eq!(compare(&right, &[answer(Exact, &[1.0])]), None);
        assert!(compare(&right, &[answer(Close, &[1.0 + 1e-15])]).is_some());
        let about = [answer(Close, &[1.0])];
        assert_eq!(compare(&about, &[answer(Exact, &[1.0 + 1e-12])]), None);
        assert!(compare(&about, &[answer(Close, &[f64::NAN])]).is_some());
        assert!(compare(&about, &[]).is_some(), "no answer");
        let twice = [answer(Close, &[1.0]), answer(Close, &[1.0])];
        assert!(compare(&about, &twice).is_some(), "one too many");
    }
}
