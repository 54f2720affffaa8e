//! Cargo at work, seen: what it says that it does, in one line that changes on a terminal, line by
//! line elsewhere.

use std::io::{self, BufRead, BufReader, IsTerminal};
use std::process::{Command, Output, Stdio};
use std::thread;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// Runs cargo to its end, and shows what it does behind the words `what`: the first build of anything
/// takes minutes. Nothing is shown when there is nothing to build. What cargo says beside its progress is
/// in the output's `stderr`.
///
/// # Errors
/// Cargo did not start, or cannot be heard.
pub fn run_visibly(cargo: &mut Command, what: &str) -> io::Result<Output> {
    // What cargo does is told from what else it says by its form, which colours would hide.
    cargo.env("CARGO_TERM_COLOR", "never");
    let mut child = cargo.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()?;
    let stderr = child.stderr.take().expect("it is piped");
    let bar =
        if io::stderr().is_terminal() { ProgressBar::new_spinner() } else { ProgressBar::hidden() };
    let style = ProgressStyle::with_template("{spinner} {prefix} ({elapsed}) {wide_msg}");
    bar.set_style(style.expect("the template is valid"));
    bar.set_prefix(what.to_owned());
    bar.enable_steady_tick(Duration::from_millis(100));
    thread::scope(|scope| {
        let heard = scope.spawn(|| listen(BufReader::new(stderr), |step| show(&bar, what, step)));
        let output = child.wait_with_output()?;
        let stderr = heard.join().expect("listening does not panic")?;
        bar.finish_and_clear();
        Ok(Output { stderr, ..output })
    })
}

/// Tells every step of cargo's, and returns what else it says.
fn listen(said: impl BufRead, mut tell: impl FnMut(&str)) -> io::Result<Vec<u8>> {
    let mut rest = Vec::new();
    for line in said.split(b'\n') {
        let line = line?;
        match step(&String::from_utf8_lossy(&line)) {
            Some(step) => tell(step),
            None => rest.extend([&line[..], b"\n"].concat()),
        }
    }
    Ok(rest)
}

/// What cargo does now, such as `Compiling serde v1.0.228`: its verb ends in the twelfth column.
fn step(line: &str) -> Option<&str> {
    let (verb, rest) = line.split_at_checked(12)?;
    let verb = verb.trim_start();
    let is_verb = verb.starts_with(|c: char| c.is_ascii_uppercase())
        && verb.chars().all(|c| c.is_ascii_alphabetic());
    (is_verb && rest.starts_with(' ')).then(|| line.trim_start())
}

/// Shows a step: on the bar or, where that is hidden, on a line of its own.
fn show(bar: &ProgressBar, what: &str, step: &str) {
    // That it is done, the next line on the screen says.
    let is_end = ["Finished", "Executable"].iter().any(|verb| step.starts_with(verb));
    if !bar.is_hidden() {
        bar.set_message(step.to_owned());
    } else if !is_end {
        eprintln!("{what}: {step}");
    }
}

#[cfg(test)]
mod tests {
    use super::{listen, step};

    #[test]
    fn steps_are_told_and_complaints_are_kept() {
        let said = "   Compiling serde v1.0.228\n    Blocking waiting for file lock on package cache\n\
                    error: failed to run custom build command for `mpi-sys v0.2.4`\n\nCaused by:\n  \
                    process didn't exit\n    Finished `test` profile [optimized] target(s) in 2.52s\n";
        let mut steps = Vec::new();
        let rest = listen(said.as_bytes(), |step| steps.push(step.to_owned())).unwrap();
        let verbs: Vec<_> = steps.iter().filter_map(|step| step.split(' ').next()).collect();
        assert_eq!(verbs, ["Compiling", "Blocking", "Finished"]);
        let complaint = "error: failed to run custom build command for `mpi-sys v0.2.4`\n\nCaused by:\n  \
                         process didn't exit\n";
        assert_eq!(String::from_utf8(rest).unwrap(), complaint);
        for no_step in ["", "warning: unused", "            ", "  |     Compiling x", "Compiling x"]
        {
            assert_eq!(step(no_step), None, "{no_step}");
        }
    }
}
