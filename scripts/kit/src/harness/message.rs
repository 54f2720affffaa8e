//! Arranges the output of a test for a student.
//!
//! The reason and the location of the failure come first. The output of the lab's own code follows.

use super::words;
use crate::process::{Finished, panic_in};

/// Maximal number of lines that are kept of the lab's own output.
const PRINTED: usize = 20;

/// Beginning of a line with the location of a panic in a lab's own code.
pub(crate) const PANIC: &str = "a panic in ";

/// Beginning of the message of a task's `todo!`.
const TODO: &str = "not yet implemented: task ";

/// Beginnings of the harness's own lines in stderr.
const HARNESS: [&str; 2] = ["note: run with `RUST_BACKTRACE", "error: test failed"];

/// Beginning of the line with a test's question.
const ASKS: &str = "asks: ";

/// Returns the question, the reason for the failure without the harness's own lines, and the
/// output.
pub(super) fn message(test: &str, done: &Finished) -> String {
    let (mut printed, table) = of_stdout(test, &done.stdout);
    let asks = printed.iter().position(|line| line.starts_with(ASKS));
    let asks: Vec<String> =
        asks.map(|at| printed.remove(at).replacen(ASKS, "", 1)).into_iter().collect();
    let (noted, why) = of_stderr(&done.stderr);
    let why = [table, why].concat();
    // A `todo!` needs no question to be understood.
    let asks = if why.iter().any(|line| line.starts_with(TODO)) { vec![] } else { asks };
    let why = if why.is_empty() { why } else { [asks, why].concat() };
    let why = words::of_a_failure(why.join("\n").trim());
    let printed = [printed, noted].concat();
    let printed = printed.join("\n");
    let printed = shortened(printed.trim_matches('\n'));
    match (why.is_empty(), printed.is_empty()) {
        (_, true) => why,
        (true, false) => printed,
        (false, false) => format!("{why}\n\nprinted by the test:\n{printed}"),
    }
}

/// Splits stdout into the output and the table of a snapshot that differs.
fn of_stdout(test: &str, stdout: &str) -> (Vec<String>, Vec<String>) {
    let begun = stdout.lines().skip_while(|line| line.is_empty() || line.starts_with("running "));
    let own = begun.take_while(|line| *line != "failures:" && !line.starts_with("test result: "));
    // The line begins with the name and ends with the verdict. The test's output is between them.
    let name = format!("test {test} ... ");
    let mut lines = Vec::new();
    for line in own.map(|line| line.strip_prefix(&*name).unwrap_or(line)) {
        let bare = line.strip_suffix("FAILED").or_else(|| line.strip_suffix("ok"));
        lines.push(bare.unwrap_or(line).to_owned());
    }
    let table = lines.iter().position(|line| line.contains(" Snapshot Summary "));
    let table = lines.split_off(table.unwrap_or(lines.len()));
    (lines, table)
}

/// Splits stderr into the lines before the first panic, and the panic with the lines after it.
fn of_stderr(stderr: &str) -> (Vec<String>, Vec<String>) {
    let mut lines: Vec<&str> = stderr.lines().collect();
    lines.retain(|line| !HARNESS.iter().any(|begin| line.starts_with(begin)));
    let first = lines.iter().position(|line| panicked_at(line).is_some()).unwrap_or(lines.len());
    let (noted, printed) = lines.split_at(first);
    let mut why = Vec::new();
    for (index, line) in printed.iter().enumerate() {
        match panicked_at(line) {
            // Students find a `todo!` by its task, so its location is left out.
            Some(_) if printed.get(index + 1).is_some_and(|next| next.starts_with(TODO)) => {}
            Some(location) => why.extend(in_a_lab(location)),
            None => why.push((*line).to_owned()),
        }
    }
    (noted.iter().map(|line| (*line).to_owned()).collect(), why)
}

/// Returns the location in the first line of a panic, which precedes the line with the message.
fn panicked_at(line: &str) -> Option<&str> {
    let (_, location) = line.strip_prefix("thread '")?.split_once(" panicked at ")?;
    location.strip_suffix(':')
}

/// Formats a panic's location in a lab's source or in the standard library; `None` elsewhere.
///
/// `location` consists of file, line and column. The standard library does not always report its
/// caller. The location of a test's own assertion does not help a student.
fn in_a_lab(location: &str) -> Option<String> {
    if location.starts_with("/rustc/") {
        return Some(format!("{PANIC}the standard library, in a function that the lab calls:"));
    }
    let mut parts = location.rsplitn(3, ':').skip(1);
    let line = parts.next()?;
    let file = parts.next()?;
    let (lab, _) = file.strip_prefix("labs/lab")?.split_once("/src/")?;
    lab.bytes().all(|b| b.is_ascii_digit()).then(|| format!("{PANIC}{file}, line {line}:"))
}

/// Returns the message of the first panic in a process's stderr.
///
/// The location of the panic precedes the message if it is in a lab's source.
pub fn located_panic(stderr: &str) -> Option<String> {
    let location = stderr.lines().find_map(panicked_at).and_then(in_a_lab);
    let panic = panic_in(stderr)?;
    Some(location.map_or_else(|| panic.to_owned(), |location| format!("{location} {panic}")))
}

fn shortened(printed: &str) -> String {
    let count = printed.lines().count();
    let mut lines: Vec<&str> = printed.lines().take(PRINTED).collect();
    let rest = count - lines.len();
    let more = format!("… and {rest} more lines");
    if rest > 0 {
        lines.push(&more);
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::{located_panic, message};
    use crate::process::Finished;

    fn message_of(stdout: &str, stderr: &str) -> String {
        message(
            "task_1_1::a",
            &Finished { status: None, stdout: stdout.into(), stderr: stderr.into() },
        )
    }

    #[test]
    fn why_stands_before_what_was_printed() {
        let printed = (0..50).map(|n| format!("pair {n}\n")).collect::<String>();
        let stdout = format!(
            "\nrunning 1 test\ntest task_1_1::a ... {printed}━━━━ Snapshot Summary ━━━━\n-old snapshot\n\
             FAILED\n\nfailures:\n"
        );
        let stderr = "r = 0.5\n\nthread 'task_1_1::a' (7) panicked at tests/lab1.rs:9:5:\nit differs\n\
                      note: run with `RUST_BACKTRACE=1` to see\n";
        let message = message_of(&stdout, stderr);
        let (why, printed) = message.split_once("\n\nprinted by the test:\n").unwrap();
        assert_eq!(why, "- expected\n\nit differs");
        assert!(printed.starts_with("pair 0\npair 1\n") && !printed.contains("pair 20\n"));
        assert!(printed.ends_with("\n… and 31 more lines"), "{printed}");
    }

    #[test]
    fn a_panic_in_a_lab_is_placed_and_no_other() {
        let lab = "a panic in labs/lab3/src/rows.rs, line 41:\nindex out of bounds";
        let library = "a panic in the standard library, in a function that the lab calls:\nindex out of bounds";
        for (location, message) in [
            ("labs/lab3/src/rows.rs:41:9", lab),
            ("/rustc/x/library/core/src/num/f64.rs:1:1", library),
            ("labs/lab3/tests/../../../tests/lab3.rs:4:5", "index out of bounds"),
            ("labs/common/src/lib.rs:1:1", "index out of bounds"),
        ] {
            let stderr = format!("\nthread 't' (7) panicked at {location}:\nindex out of bounds\n");
            assert_eq!(message_of("", &stderr), message, "{location}");
            assert_eq!(located_panic(&stderr), Some(message.replace('\n', " ")));
        }
        let todo = "\nthread 't' (7) panicked at labs/lab1/src/x.rs:9:5:\nnot yet implemented: task 1.1: x\n";
        assert_eq!(message_of("", todo), "not yet implemented: task 1.1: x");
    }
}
