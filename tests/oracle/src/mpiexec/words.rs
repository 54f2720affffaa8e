//! What a failed job has to say to a student.

/// Lines of Open MPI and of the test harness that hold one of these say nothing about the lab.
const NOISE: [&str; 13] = [
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
];

/// What the libraries say, and what that means.
const MEANINGS: [(&str, &str); 2] = [
    (
        "MPI_ERR_TRUNCATE",
        "A message was longer than the buffer for it. Either the buffer is too short, or ranks make their \
         calls in different orders, and two that do not belong together have met.",
    ),
    (
        "all(|(&c, &d)| c + d <= n)",
        "A part of a Partition or PartitionMut reaches beyond its buffer. The buffer must be as long as all \
         counts together, and displacements must be those of the same counts.",
    ),
];

/// What ranks and launcher said, without noise.
pub(super) fn of_a_failure(stderr: &str) -> String {
    let is_noise = |line: &&str| line.is_empty() || NOISE.iter().any(|noise| line.contains(noise));
    // Open MPI begins a line with a machine and a process.
    let said = |line| str::split_once(line, "] *** ").map_or(line, |(_, said)| said);
    let mut lines: Vec<&str> = stderr.lines().filter(|line| !is_noise(line)).map(said).collect();
    let meanings = MEANINGS.iter().filter(|(words, _)| stderr.contains(words));
    lines.splice(0..0, meanings.map(|(_, meaning)| *meaning));
    if lines.is_empty() {
        lines.push("a rank ended the job without a word");
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::of_a_failure;

    #[test]
    fn the_ranks_words_remain() {
        let said = "-----------------------\nMPI_ABORT was invoked on rank 0 in communicator MPI_COMM_WORLD\n\
                    with errorcode 101.\n\nrank 0: \nparticle 3 is lost\n";
        assert_eq!(of_a_failure(said), "rank 0: \nparticle 3 is lost");
        let said = "[vm:3] *** An error occurred in MPI_Reduce\n[vm:3] *** MPI_ERR_TRUNCATE: message truncated\n";
        let said = of_a_failure(said);
        assert!(said.starts_with("A message was longer than the buffer") && !said.contains("vm:3"));
        assert_eq!(of_a_failure(""), "a rank ended the job without a word");
    }
}
