//! Messages for students about failed jobs.

use std::time::Duration;

/// Parts of lines of Open MPI and of the test harness that contain no information about the lab.
const NOISE: [&str; 20] = [
    "-----------------",
    "MPI_ABORT was invoked on rank",
    "with errorcode ",
    "NOTE: invoking MPI_ABORT causes Open MPI",
    "You may or may not see output from other processes",
    "exactly when Open MPI kills them",
    "ORTE_ERROR_LOG",
    "[warn] Epoll",
    "] *** reported by process",
    "] *** on communicator",
    "] *** MPI_ERRORS_ARE_FATAL",
    "] ***    and potentially your MPI job",
    "note: run with `RUST_BACKTRACE",
    "Process received signal ***",
    "Signal: ",
    "Signal code: ",
    "End of error message ***",
    "Primary job  terminated normally",
    "a non-zero exit code. Per user-direction",
    "mpiexec noticed that process rank",
];

/// Messages of the libraries, and their meanings.
const MEANINGS: [(&str, &str); 3] = [
    (
        "Process received signal",
        "A rank crashed inside the MPI library. The usual cause is that two messages met that do not belong together, \
         because ranks make their calls in different orders, or because one rank stops after fewer rounds than \
         another.",
    ),
    (
        "MPI_ERR_TRUNCATE",
        "A message was longer than its buffer. Either the buffer is too short, or ranks make their calls in different \
         orders, so that two calls that do not belong together have met.",
    ),
    (
        "all(|(&c, &d)| c + d <= n)",
        "A part of a Partition or PartitionMut reaches beyond its buffer. The length of the buffer must be the sum of \
         the counts, and the displacements must belong to the same counts.",
    ),
];

/// Parts of the names of MPI calls that wait for a single message. Other calls wait for all ranks.
const OF_ONE_MESSAGE: [&str; 4] = ["send", "recv", "probe", "wait"];

const MISSING_CALL: &str = "Each rank waits in a call of MPI. So some rank waits for a call that another rank does \
                            not make. Look for a collective operation that some ranks omit or repeat, for a message \
                            that no rank sends, and for a send that no rank receives.";

const NOT_KNOWN: &str = "The usual causes are a loop that does not end, a list that grows in each step, or a busy \
                         machine.";

/// Explains why a job of `ranks` ranks may have given no answer within `limit`, and shows the
/// ranks' messages.
///
/// A missing call is the reason only if all ranks have waited in calls for a quarter of the time,
/// and these calls are not all the same collective operation. Otherwise the reason is unknown,
/// because correct programs may also take too long on a busy machine.
pub(super) fn of_no_answer(stderr: &str, ranks: usize, limit: Duration) -> String {
    let mut lines: Vec<&str> = stderr.lines().collect();
    lines.sort_unstable();
    let waits: Vec<(&str, u64)> = lines.iter().filter_map(|line| wait(line)).collect();
    let all_wait =
        waits.len() == ranks && waits.iter().all(|(_, seconds)| 4 * seconds >= limit.as_secs());
    let all_in_one = waits.iter().all(|(call, _)| *call == waits[0].0 && is_of_all(call));
    let why = if all_wait && !all_in_one { MISSING_CALL } else { NOT_KNOWN };
    format!("{why}\n{}", lines.join("\n"))
}

/// Returns the call with its location, and the seconds that a rank has waited in it.
///
/// An example of a line is
/// `after 20 s rank 1 is in a run, in MPI_Recv (labs/lab5/src/root.rs, line 29) for 19 s`.
fn wait(line: &str) -> Option<(&str, u64)> {
    let (_, wait) = line.split_once(", in MPI_")?;
    let (call, seconds) = wait.strip_suffix(" s")?.rsplit_once(" for ")?;
    Some((call, seconds.parse().ok()?))
}

fn is_of_all(call: &str) -> bool {
    let name = call.split(' ').next().unwrap_or_default().to_lowercase();
    !OF_ONE_MESSAGE.iter().any(|part| name.contains(part))
}

/// The message of a failure if neither the ranks nor the launcher print a reason.
pub(super) const SILENT: &str = "a rank ended the job without a message";

/// Returns the messages of ranks and launcher without noise.
pub(super) fn of_a_failure(stderr: &str) -> String {
    let is_noise = |line: &&str| {
        line.is_empty() || is_frame(line) || NOISE.iter().any(|noise| line.contains(noise))
    };
    // Open MPI begins a line with the name of a machine and a process.
    let message = |line| str::split_once(line, "] *** ").map_or(line, |(_, message)| message);
    let mut lines: Vec<&str> = stderr.lines().filter(|line| !is_noise(line)).map(message).collect();
    let meanings = MEANINGS.iter().filter(|(words, _)| stderr.contains(words));
    lines.splice(0..0, meanings.map(|(_, meaning)| *meaning));
    if lines.is_empty() {
        lines.push(SILENT);
    }
    lines.join("\n")
}

/// Returns whether a line belongs to a backtrace of Open MPI, such as `[vm:11471] [ 5]
/// /lib/libc.so.6(abort+0xd3)[0x7f22]`.
fn is_frame(line: &str) -> bool {
    let Some((_, frame)) = line.split_once("] [") else { return false };
    frame.split_once(']').is_some_and(|(number, _)| number.trim().parse::<u32>().is_ok())
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::{MISSING_CALL, NOT_KNOWN, SILENT, of_a_failure, of_no_answer};

    #[test]
    fn a_call_is_missing_only_where_all_ranks_wait() {
        let says = |calls: [&str; 2]| {
            let lines = [0, 1].map(|rank| format!("after 20 s rank {rank} is {}\n", calls[rank]));
            let message = of_no_answer(&lines.concat(), 2, Duration::from_secs(20));
            assert!(message.contains("rank 0 is") && message.contains("rank 1 is"), "{message}");
            message
        };
        let waits = "in a run, in MPI_Wait (labs/lab8/src/x.rs, line 3) for 19 s";
        let sums = "in a run, in MPI_Allreduce (labs/lab8/src/x.rs, line 9) for 19 s";
        for calls in [[waits, waits], [waits, sums]] {
            assert!(says(calls).starts_with(MISSING_CALL), "{calls:?}");
        }
        let soon = "in a run, in MPI_Wait (labs/lab8/src/x.rs, line 3) for 1 s";
        let computes = "in a run, past MPI_Wait (labs/lab8/src/x.rs, line 3)";
        for calls in [[sums, sums], [waits, soon], [waits, computes], ["past a run", sums]] {
            assert!(says(calls).starts_with(NOT_KNOWN), "{calls:?}");
        }
        let one_of_two = format!("after 20 s rank 0 is {waits}\n");
        let message = of_no_answer(&one_of_two, 2, Duration::from_secs(20));
        assert!(message.starts_with(NOT_KNOWN), "{message}");
    }

    #[test]
    fn the_ranks_words_remain() {
        let message = "-----------------------\nMPI_ABORT was invoked on rank 0 in communicator MPI_COMM_WORLD\nwith \
                       errorcode 101.\n\nrank 0: \nparticle 3 is lost\n";
        assert_eq!(of_a_failure(message), "rank 0: \nparticle 3 is lost");
        let message = "[vm:3] *** An error occurred in MPI_Reduce\n[vm:3] *** MPI_ERR_TRUNCATE: message truncated\n";
        let message = of_a_failure(message);
        assert!(
            message.starts_with("A message was longer than its buffer")
                && !message.contains("vm:3")
        );
        assert_eq!(of_a_failure(""), SILENT);
    }

    #[test]
    fn a_crash_is_explained_and_its_trace_left_out() {
        let message = "malloc(): unaligned tcache chunk detected\n[vm:7] *** Process received signal ***\n[vm:7] \
                       Signal: Aborted (6)\n[vm:7] [ 0] /lib/libc.so.6(+0x3c0)[0x7f]\n[vm:7] [13] \
                       /kit/lab8(+0x1)[0x2]\n[vm:7] *** End of error message ***\n";
        let message = of_a_failure(message);
        let lines: Vec<&str> = message.lines().collect();
        assert!(lines[0].starts_with("A rank crashed inside the MPI library."), "{message}");
        assert_eq!(lines[1..], ["malloc(): unaligned tcache chunk detected"]);
    }
}
