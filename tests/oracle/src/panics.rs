//! Locations of a lab's panics, including panics in libraries that the lab called.

use std::backtrace::Backtrace;
use std::panic::{self, PanicHookInfo};
use std::sync::Once;
use std::thread;

/// Makes panics outside a lab's sources print the lab's line that called the panicking function, if
/// there is one.
pub(crate) fn name_the_lab() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let print = panic::take_hook();
        panic::set_hook(Box::new(move |info| match caller(info) {
            None => print(info),
            Some(at) => {
                let thread = thread::current();
                let name = thread.name().unwrap_or("without a name");
                let why = info.payload_as_str().unwrap_or("no reason is given");
                eprintln!("\nthread '{name}' panicked at {at}:\n{why}");
            }
        }));
    });
}

/// Returns the lab's line that called the panicking function. `None` for a panic of the lab itself,
/// and for a panic of a test, which has its own message.
fn caller(info: &PanicHookInfo<'_>) -> Option<String> {
    let file = info.location()?.file();
    if file.contains("labs/lab") || file.contains("tests/") {
        return None;
    }
    lab_frame(&format!("{:#}", Backtrace::force_capture()))
}

/// Returns the innermost location of a trace in a lab's sources, such as
/// `labs/lab8/src/moves.rs:29:14`.
fn lab_frame(trace: &str) -> Option<String> {
    let mut locations = trace.lines().filter_map(|line| line.trim_start().strip_prefix("at "));
    locations.find_map(|location| {
        let start = location.rfind("/labs/lab")?;
        location.contains("/src/").then(|| location[start + 1..].to_owned())
    })
}

#[cfg(test)]
mod tests {
    use super::lab_frame;

    #[test]
    fn a_library_that_panics_was_called_by_a_lab() {
        let trace = "  0: core::panicking::panic_bounds_check\n    at /rustc/x/library/core/src/panicking.rs:1:1\n  \
                     1: solution7::resolve\n    at /kit/solutions/lab7/src/resolve.rs:9:1\n  \
                     2: lab8::moves::move_on\n    at /kit/labs/lab8/src/moves.rs:29:14\n  \
                     3: lab8::moves\n    at /kit/labs/lab8/tests/lab8/moves.rs:7:1\n";
        assert_eq!(lab_frame(trace).as_deref(), Some("labs/lab8/src/moves.rs:29:14"));
        assert_eq!(lab_frame("  0: main\n    at /kit/labs/lab8/tests/lab8.rs:7:1\n"), None);
    }
}
