//! The common part of all labs' programs: options, the error line, the progress bar, and JSON.

use std::env;
use std::io::{self, IsTerminal, Write};
use std::panic;
use std::path::PathBuf;
use std::process::{self, ExitCode};
use std::thread;
use std::time::Duration;

use clap::{Args, Parser};
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Map, Value, json};

use crate::{Config, Event, Variant, threads, write_whole};

/// Time that a rank waits for the root to report an error for all ranks.
const GRACE: Duration = Duration::from_secs(1);

/// An error message for the user, in one line.
pub(crate) type Complaint = String;

/// The options of every lab.
#[derive(Args)]
pub(crate) struct Choice {
    /// Write the result to this file
    #[arg(short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Number of threads [default: one per core]
    #[arg(short, value_name = "THREADS", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(crate) threads: Option<u16>,
    /// Name of the program of this lab to run [default: the first]
    #[arg(long, value_name = "NAME")]
    pub(crate) variant: Option<String>,
    /// List this lab's programs and their parameters
    #[arg(long)]
    pub(crate) list_variants: bool,
    /// Adjust a parameter of the variant
    #[arg(long, value_name = "NAME=VALUE", value_parser = name_and_value)]
    pub(crate) param: Vec<(String, f64)>,
    /// Write the activities of each rank, in seconds: lines 'rank step activity begin end'
    #[arg(long, value_name = "FILE")]
    pub(crate) events: Option<PathBuf>,
    /// Print the results, or the list, as one line of JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// Returns the memory of this process in bytes; `None` if the system does not report it.
pub(crate) fn resident() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    Some(1024 * line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()?)
}

/// Parses the command line and runs the program.
///
/// Of several processes with the same command line, only the `root` prints. If all processes have
/// the same error, the root reports it; another process prints its error only if the job has not
/// ended after [`GRACE`].
pub(crate) fn run<O: Parser>(
    root: bool,
    program: impl FnOnce(&O) -> Result<(), Complaint>,
) -> ExitCode {
    end_in_one_line();
    let done = match O::try_parse() {
        Ok(options) => program(&options),
        Err(help) if !help.use_stderr() => {
            if root {
                say(&help.to_string())
            } else {
                Ok(())
            }
        }
        Err(error) => {
            let text = error.to_string();
            return complain(root, text.lines().next().unwrap_or("error: bad command line"), 2);
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(complaint) => {
            let complaint = threads::refusal(&complaint).unwrap_or(complaint);
            complain(root, &format!("error: {complaint}"), 1)
        }
    }
}

/// Makes two kinds of panics end the program with an error of one line: the `todo!` of an open
/// task, and a thread that the system refuses to start.
fn end_in_one_line() {
    let usual = panic::take_hook();
    panic::set_hook(Box::new(move |panic| {
        let message = panic.payload_as_str().unwrap_or_default();
        if let Some(refusal) = threads::refusal(message) {
            eprintln!("error: {refusal}");
            // The threads that were started may be waiting at a barrier for the thread that could
            // not be started.
            process::exit(1);
        }
        match panic.location() {
            Some(at) if message.starts_with("not yet implemented: task ") => eprintln!(
                "error: {message} ({}, line {}); '--list-variants' names other programs",
                at.file(),
                at.line()
            ),
            _ => usual(panic),
        }
    }));
}

fn complain(root: bool, line: &str, code: u8) -> ExitCode {
    if !root {
        thread::sleep(GRACE);
    }
    eprintln!("{line}");
    ExitCode::from(code)
}

impl Choice {
    /// Returns the variant that the user chose, or the first variant.
    pub(crate) fn variant<'v, S: ?Sized>(
        &self,
        variants: &'v [Variant<S>],
    ) -> Result<&'v Variant<S>, Complaint> {
        let Some(name) = self.variant.as_deref() else {
            return variants.first().ok_or_else(|| "this lab has no variants".into());
        };
        variants.iter().find(|v| v.name == name).ok_or_else(|| {
            let names: Vec<_> = variants.iter().map(|v| v.name).collect();
            format!("there is no variant '{name}'; there are: {}", names.join(", "))
        })
    }

    /// Returns the configuration that the user chose for a variant.
    pub(crate) fn config<S: ?Sized>(&self, variant: &Variant<S>) -> Result<Config, Complaint> {
        let threads = match self.threads {
            Some(threads) => threads.into(),
            None => thread::available_parallelism().map_or(1, usize::from),
        };
        threads::ask_for(threads, self.threads.is_some())?;
        let mut config = variant.config().with_threads(threads);
        for (name, value) in &self.param {
            variant.set(&mut config, name, *value).map_err(|e| e.to_string())?;
        }
        config.events = self.events.is_some();
        Ok(config)
    }

    /// Writes the events to the user's file, on the root, if the user has named a file.
    pub(crate) fn write_events(
        &self,
        variant: &str,
        events: Option<Vec<Event>>,
    ) -> Result<(), Complaint> {
        let Some(path) = &self.events else { return Ok(()) };
        let events = events.ok_or_else(|| format!("variant {variant} records no events"))?;
        write_whole(path, |out| events.iter().try_for_each(|event| writeln!(out, "{event}")))
            .map_err(|e| format!("cannot write {}: {e}", path.display()))
    }
}

/// Prints the variants of a lab and their parameters, for a reader or as one line of JSON.
pub(crate) fn list<S: ?Sized>(variants: &[Variant<S>], json: bool) -> Result<(), Complaint> {
    if json {
        let listed: Vec<Value> = variants.iter().map(as_json).collect();
        return say(&format!("{}\n", Value::from(listed)));
    }
    let width = variants.iter().map(|v| v.name.len()).max().unwrap_or(0);
    let mut text = String::new();
    for variant in variants {
        text += &format!("{:width$}  {}\n", variant.name, variant.about);
        for parameter in variant.parameters {
            let (least, greatest) = parameter.range;
            text += &format!(
                "{:width$}    --param {}={} ({least} to {greatest}): {}\n",
                "", parameter.name, parameter.default, parameter.about
            );
        }
    }
    say(&text)
}

/// Returns a variant and its parameters as JSON.
fn as_json<S: ?Sized>(variant: &Variant<S>) -> Value {
    let parameters = variant.parameters.iter().map(|parameter| {
        json!({
            "name": parameter.name, "about": parameter.about,
            "default": parameter.default, "range": parameter.range,
        })
    });
    json!({
        "name": variant.name, "about": variant.about,
        "parameters": parameters.collect::<Vec<_>>(),
    })
}

/// Prints a text to standard output.
pub(crate) fn say(text: &str) -> Result<(), Complaint> {
    say_to(io::stdout().lock(), text)
}

fn say_to(mut out: impl Write, text: &str) -> Result<(), Complaint> {
    none_if_closed(out.write_all(text.as_bytes()).and_then(|()| out.flush())).map(drop)
}

/// Converts the result of writing to standard output.
///
/// Returns `None` if the reader has closed the output, as `head` does. This is not an error.
pub(crate) fn none_if_closed<T>(written: io::Result<T>) -> Result<Option<T>, Complaint> {
    match written {
        Ok(result) => Ok(Some(result)),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(None),
        Err(error) => Err(format!("cannot write to standard output: {error}")),
    }
}

/// Returns the progress bar of a run of `steps` steps. It is hidden if there is no terminal.
pub(crate) fn progress(root: bool, steps: u64) -> ProgressBar {
    // An editor's shell calls itself dumb, because it knows no escape codes.
    let is_dumb = env::var_os("TERM").is_some_and(|terminal| terminal == "dumb");
    if !root || is_dumb || !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} step {pos} of {len}, {eta} left")
        .expect("the template is valid");
    ProgressBar::new(steps).with_style(style)
}

/// Returns a variant's counters as a JSON object.
pub(crate) fn counters_as_json(counters: Vec<(&'static str, f64)>) -> Map<String, Value> {
    counters.into_iter().map(|(name, value)| (name.to_owned(), json!(value))).collect()
}

fn name_and_value(text: &str) -> Result<(String, f64), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE")?;
    let value = value.parse().map_err(|_| format!("'{value}' is not a number"))?;
    Ok((name.into(), value))
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Failing(io::ErrorKind);

    impl Write for Failing {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(self.0.into())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_closed_pipe_is_no_error_and_a_full_disk_is_one() {
        assert_eq!(say_to(Failing(io::ErrorKind::BrokenPipe), "text"), Ok(()));
        let full = say_to(Failing(io::ErrorKind::StorageFull), "text");
        assert!(full.unwrap_err().starts_with("cannot write to standard output: "));
    }
}
