//! The MPI calls of a rank, by file and line, compared with the calls of all other ranks.
//!
//! If ranks make different calls where all must make the same call, they wait forever, or mistake one
//! message for another. While a watch is on, ranks first report to each other which call they will
//! make.

use std::backtrace::Backtrace;
use std::panic::PanicHookInfo;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Instant;

use mpi::ffi::{Call, share};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::record;

/// Number of words of eight bytes in a text that ranks exchange.
const WORDS: usize = 24;

/// Parts of paths, in a stack trace, of files that a student writes or reads.
const OWN: [&str; 3] = ["/labs/", "/solutions/", "/tests/"];

/// Parts of the paths of given code that calls MPI for a lab.
const GIVEN: [&str; 2] = ["/labs/common-mpi/src/", "/labs/common-mpi/sys/"];

static CALLS: Mutex<Calls> = Mutex::new(Calls { made: Vec::new(), together: 0, last: None });

struct Calls {
    /// Names of the calls that were made since [`begin`].
    made: Vec<&'static str>,
    /// Number of calls that all ranks have made together.
    together: u64,
    last: Option<Last>,
}

struct Last {
    name: &'static str,
    since: Instant,
    is_over: bool,
    from: Backtrace,
}

fn calls() -> MutexGuard<'static, Calls> {
    CALLS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Forgets the calls that were made.
pub(crate) fn begin() {
    calls().made.clear();
}

/// Returns the names of the calls that this rank has made in the last [`together`](crate::together),
/// and its [notes](note), in their order. The list is empty without a watch.
pub fn calls_made() -> Vec<&'static str> {
    calls().made.clone()
}

/// Notes an action of this rank that is not a call, such as `walls_of`, among its [calls](calls_made).
/// Without a watch it does nothing.
pub fn note(what: &'static str) {
    let mut calls = calls();
    if calls.last.is_some() {
        calls.made.push(what);
    }
}

/// Describes whether this rank is past its last call or still in the call, and for how long. `None`
/// if it has made no call.
pub(crate) fn location() -> Option<String> {
    let calls = calls();
    let Last { name, since, is_over, from } = calls.last.as_ref()?;
    let at = location_in(from);
    if *is_over {
        return Some(format!("past {name}{at}"));
    }
    Some(format!("in {name}{at} for {} s", since.elapsed().as_secs()))
}

/// Records a call before it is made. `None` reports that the call is over.
pub(crate) fn hear(call: Option<&Call>) {
    let mut calls = calls();
    let Some(call) = call else {
        calls.last.iter_mut().for_each(|last| last.is_over = true);
        return;
    };
    calls.made.push(call.name);
    calls.together += u64::from(call.is_collective);
    let number = calls.together;
    let from = Backtrace::force_capture();
    record::note(number, call, || own_location(&format!("{from:#}")));
    calls.last = Some(Last { name: call.name, since: Instant::now(), is_over: false, from });
    drop(calls);
    if call.is_collective {
        compare(number, call);
    }
}

/// Ends the job if ranks make different calls, or if their buffers do not match.
fn compare(number: u64, call: &Call) {
    let [count, size] = call.items;
    let name = call.name.bytes().chain(call.operation.unwrap_or_default().bytes());
    let name = name.fold(0, |sum: i64, byte| sum.wrapping_mul(31) + i64::from(byte));
    let own = [name, call.root.into(), count, size];
    let all = share(own);
    let own_rank = SimpleCommunicator::world().rank();
    let differs = all.iter().any(|other| other[..2] != own[..2]);
    let uneven = call.is_uniform && all.iter().any(|other| other[2] * other[3] != count * size);
    if differs || uneven {
        let what = match call.name {
            "MPI_Finalize" => "no further call: the rank has ended".into(),
            _ if differs => name_and_root(call) + &location_here(),
            name => format!("{name} with {}{}", in_words(call.items), location_here()),
        };
        let words: Vec<String> = share(packed(&what)).iter().map(unpacked).collect();
        if own_rank == 0 {
            let how = if differs {
                "make different calls as"
            } else {
                "use buffers of different lengths in"
            };
            let lines = by_rank(&words);
            end(&format!("Ranks {how} collective call {number}:\n{lines}"));
        }
        loop {
            thread::park();
        }
    }
    for (rank, (other, expected)) in all.iter().zip(&call.of_each).enumerate() {
        let theirs = [other[2], other[3]];
        if theirs[0] * theirs[1] != expected[0] * expected[1] {
            let name = call.name;
            let location = location_here();
            let does = if name.contains("Gather") { "sends" } else { "has room for" };
            let roots = if name.contains("Gather") { "has room for" } else { "sends it" };
            end(&format!(
                "{name}{location}: rank {rank} {does} {}, and rank {own_rank}, the root, {roots} {}",
                in_words(theirs),
                in_words(*expected)
            ));
        }
    }
}

fn end(words: &str) -> ! {
    eprintln!("{words}");
    SimpleCommunicator::world().abort(1)
}

fn name_and_root(call: &Call) -> String {
    let Call { name, root, .. } = call;
    let root = if *root < 0 { String::new() } else { format!(" of root {root}") };
    let operation = call.operation.map_or_else(String::new, |what| format!(" of a {what}"));
    format!("{name}{operation}{root}")
}

fn in_words([count, size]: [i64; 2]) -> String {
    format!("{count} item{} of {size} bytes", if count == 1 { "" } else { "s" })
}

/// Returns a line for each different text, with the ranks that have it.
fn by_rank(words: &[String]) -> String {
    let mut lines = String::new();
    for (rank, words_of_rank) in words.iter().enumerate() {
        if words[..rank].contains(words_of_rank) {
            continue;
        }
        let alike = words.iter().enumerate().filter(|(_, other)| *other == words_of_rank);
        let ranks: Vec<String> = alike.map(|(rank, _)| rank.to_string()).collect();
        let who = if ranks.len() == 1 { "rank" } else { "ranks" };
        lines += &format!("  {who} {}: {words_of_rank}\n", ranks.join(", "));
    }
    lines
}

/// Returns a text as numbers. The text is cut to the length of a message.
fn packed(text: &str) -> [i64; WORDS] {
    let mut bytes = [0; 8 * WORDS];
    let length = text.floor_char_boundary(bytes.len());
    bytes[..length].copy_from_slice(&text.as_bytes()[..length]);
    std::array::from_fn(|k| i64::from_le_bytes(std::array::from_fn(|byte| bytes[8 * k + byte])))
}

fn unpacked(words: &[i64; WORDS]) -> String {
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    String::from_utf8_lossy(&bytes).trim_end_matches('\0').into()
}

/// Returns the location of the last call: ` (labs/lab5/src/root.rs, line 29)`.
fn location_here() -> String {
    calls().last.as_ref().map_or_else(String::new, |last| location_in(&last.from))
}

fn location_in(trace: &Backtrace) -> String {
    own_location(&format!("{trace:#}"))
        .map_or_else(String::new, |location| format!(" ({location})"))
}

/// Describes the innermost location of a trace in a file that a student knows.
fn own_location(trace: &str) -> Option<String> {
    let mut parts = own_frame(trace)?.split(':');
    Some(format!("{}, line {}", parts.next()?, parts.next()?))
}

/// Returns the innermost location of a trace in a file that a student knows:
/// `labs/lab5/src/root.rs:29:14`.
fn own_frame(trace: &str) -> Option<&str> {
    let mut locations = trace.lines().filter_map(|line| line.trim_start().strip_prefix("at "));
    locations.find_map(|location| {
        let start = OWN.iter().filter_map(|own| location.rfind(own)).max()?;
        let is_own = !GIVEN.iter().any(|given| location.contains(given));
        is_own.then(|| &location[start + 1..])
    })
}

/// Returns the location of a panic in a lab or a test. If other code panicked, returns the location in
/// the lab or test that called it.
pub(crate) fn panicked_at(info: &PanicHookInfo<'_>) -> String {
    let location = info.location().map_or_else(String::new, ToString::to_string);
    if location.contains("labs/lab") || location.contains("tests/") {
        return location;
    }
    let trace = format!("{:#}", Backtrace::force_capture());
    own_frame(&trace).map_or(location, str::to_owned)
}

/// Returns a message if a rank calls a method that only the root calls, or if the root calls a method
/// of the other ranks. `None` if the panic has a different reason.
pub(crate) fn wrong_side(rank: i32, panic: &str, trace: &Backtrace) -> Option<String> {
    let trace = format!("{trace:#}");
    // If the compiler has not inlined the method, its name is on the line above its location.
    let above = trace.split_once("/collective.rs:").map_or("", |(above, _)| above);
    let name = above.lines().rev().nth(1).unwrap_or_default();
    let mut words = name.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
    let method = words.rfind(|word| word.contains("_into"));
    let location =
        own_location(&trace).map_or_else(String::new, |location| format!(" ({location})"));
    // Only methods for ranks other than the root assert that the rank and the root differ.
    if panic.contains("left != right") {
        let method = method.unwrap_or("a method of the other ranks");
        let why = "the methods of the root end in _root";
        return Some(format!("rank {rank}, the root, calls {method}{location}: {why}"));
    }
    let method = method.filter(|method| method.ends_with("_root"))?;
    let why = "only the root may call a method that ends in _root";
    Some(format!("rank {rank} calls {method}{location}: {why}"))
}

#[cfg(test)]
mod tests {
    use super::{by_rank, own_location, packed, unpacked};

    #[test]
    fn the_location_is_that_of_the_lab() {
        let trace = "  0: common_mpi::calls::hear\n    at /kit/labs/common-mpi/src/calls.rs:9:1\n  \
                     1: mpi::collective::Root::gather_into\n    at /x/mpi-0.8.2/src/collective.rs:730:13\n  \
                     2: lab5::root::gather_at_root\n    at /my labs/kit/labs/lab5/src/root.rs:29:14\n";
        assert_eq!(own_location(trace).as_deref(), Some("labs/lab5/src/root.rs, line 29"));
        assert_eq!(own_location("  0: main\n"), None);
    }

    #[test]
    fn texts_are_packed_and_unpacked() {
        let long = "MPI_Gather of root 0 … ".repeat(20);
        for text in ["", "MPI_Bcast (labs/lab5/src/scene.rs, line 27)", &long] {
            assert!(text.starts_with(&unpacked(&packed(text))), "{text}");
        }
        assert_eq!(unpacked(&packed("line 27")), "line 27");
    }

    #[test]
    fn ranks_with_the_same_text_share_a_line() {
        let words = ["a", "b", "a"].map(String::from);
        assert_eq!(by_rank(&words), "  ranks 0, 2: a\n  rank 1: b\n");
    }
}
