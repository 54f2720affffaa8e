//! Runs of the lab's own program (the student's or the solution's). Only tests have a program.

use std::io::Write;
use std::process::{Command, Output, Stdio};

use oracle::within;

const PROGRAM: Option<&str> = match option_env!("CARGO_BIN_EXE_lab7") {
    Some(program) => Some(program),
    None => option_env!("CARGO_BIN_EXE_solution7"),
};

/// Runs the lab's program on an input with one gigabyte of memory. This is enough for every list of
/// n entries and too little for every list of n² entries here.
fn program(input: &str, arguments: &[&str]) -> Output {
    let arguments = arguments.join(" ");
    let input = input.to_owned();
    within("7.7", 60, move || {
        let limit = if cfg!(target_os = "linux") { "ulimit -v 1000000; " } else { "" };
        let program = PROGRAM.expect("the lab has its own program");
        let mut shell = Command::new("sh");
        shell.args(["-c", &format!("{limit}exec '{program}' {arguments}")]).stdin(Stdio::piped());
        shell.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut running = shell.spawn().expect("a shell starts");
        let mut stdin = running.stdin.take().expect("the program's input is piped");
        // A program that refuses the first line need not read the rest.
        let _ = stdin.write_all(input.as_bytes());
        drop(stdin);
        running.wait_with_output().expect("the program ends")
    })
}

/// A valid input with three discs.
const GOOD: &str = "3 10 1 2 perf\n0 2 2 1 0\n1 5 5 0 1\n2 8 8 -1 -1\n";

/// Checks that a bad input causes one line that names the line of the input, and no output.
pub(crate) fn refuses_bad_input() {
    let fine = program(GOOD, &["-t", "1"]);
    assert!(fine.status.success(), "{}", String::from_utf8_lossy(&fine.stderr));
    // The kit's own tests cover the other refused inputs.
    for (what, input, line) in [
        ("an empty input", String::new(), 1),
        ("a truncated list", GOOD.replace("2 8 8 -1 -1\n", ""), 3),
        ("a velocity that is not a number", GOOD.replace("5 5 0 1", "5 5 nan 1"), 3),
        ("a count above the list's", GOOD.replace("3 10", "2000000000 10"), 4),
        ("a radius of zero", GOOD.replace("10 1 2", "10 0 2"), 1),
    ] {
        let output = program(&input, &["-t", "1"]);
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success(), "{what} is accepted, but must be refused");
        assert!(
            output.stdout.is_empty(),
            "{what}: the program writes discs although it refuses the input"
        );
        assert_eq!(
            message.lines().count(),
            1,
            "{what} must produce a one-line error message, not:\n{message}"
        );
        assert!(
            message.contains(&format!("line {line}: ")),
            "{what}: the program's error must name line {line}, but the error is: {message}"
        );
    }
}

/// Checks that one step of `discs` discs of the report's kind needs less than a gigabyte.
pub(crate) fn fits_into_memory(variant: &str, discs: &str) {
    let input = format!("{discs} 20000 1 1 perf\n");
    let output = program(&input, &["-t", "1", "--json", "--variant", variant]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
