//! All ranks of a job end together, even if one of them fails.
//!
//! Each test starts this test program again on ranks, to run one of the parts below. A plain run of
//! the tests ignores the parts.

use std::fs;
use std::panic::catch_unwind;
use std::process::{Command, ExitCode};
use std::time::Duration;

use common_mpi::{Ghost, Wire, as_rank, together};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::mpiexec::{Ended, Job};

/// Time limit for the end of a job. A launcher may need a second or two to notice that a rank has
/// ended.
const SOON: Duration = Duration::from_secs(20);

fn play(part: &str, ranks: usize) -> Ended {
    Job::part("0.0", part, ranks).run()
}

fn on_ranks(program: impl FnOnce(&SimpleCommunicator) -> ExitCode) {
    assert_eq!(as_rank(program), ExitCode::SUCCESS);
}

#[test]
fn a_sound_job_ends_well() {
    let ended = play("particles_travel", 3);
    assert!(ended.status.success(), "{}", ended.stderr);
}

#[test]
#[ignore = "a part of a_sound_job_ends_well"]
fn particles_travel() {
    on_ranks(|world| {
        let id = world.rank() as u64;
        let size = world.size();
        let mine = Wire { x: 0.1, y: 0.2, vx: -0.3, vy: 0.4, id };
        let ghost = Ghost { x: 0.5, y: 0.6, id };
        let mut all = vec![Wire::default(); size as usize];
        world.all_gather_into(&mine, &mut all[..]);
        let mut ghosts = vec![Ghost::default(); size as usize];
        world.all_gather_into(&ghost, &mut ghosts[..]);
        for other in 0..size as u64 {
            assert_eq!(all[other as usize], Wire { id: other, ..mine });
            assert_eq!(ghosts[other as usize], Ghost { id: other, ..ghost });
        }
        ExitCode::SUCCESS
    });
}

/// A file that exists once a rank has ended silently for the first time.
const ENDED_ONCE: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/ended-once");

#[test]
fn a_job_that_ends_without_a_message_runs_once_more() {
    // The file is missing if this is the first run of the test.
    let _ = fs::remove_file(ENDED_ONCE);
    Job::part("0.0", "a_rank_ends_silently_once", 2).succeed();
    assert!(fs::exists(ENDED_ONCE).unwrap());
}

#[test]
#[ignore = "a part of a_job_that_ends_without_a_message_runs_once_more"]
fn a_rank_ends_silently_once() {
    on_ranks(|world| {
        if world.rank() == 0 && fs::File::create_new(ENDED_ONCE).is_ok() {
            let own = std::process::id().to_string();
            Command::new("kill").args(["-KILL", &own]).status().unwrap();
        }
        ExitCode::SUCCESS
    });
}

#[test]
fn a_panic_on_one_rank_ends_the_others() {
    let ended = play("one_rank_panics", 3);
    assert!(!ended.status.success());
    assert!(ended.took < SOON, "took {:?}", ended.took);
    assert!(ended.stderr.contains("rank 1:\nthread '"), "{}", ended.stderr);
    assert!(ended.stderr.contains("lost its way"), "{}", ended.stderr);
}

#[test]
fn a_panic_in_the_library_names_its_caller() {
    let message = play("a_rank_unwraps_nothing", 1).stderr;
    assert!(message.contains(" panicked at tests/job.rs:"), "{message}");
}

#[test]
#[ignore = "a part of a_panic_in_the_library_names_its_caller"]
fn a_rank_unwraps_nothing() {
    on_ranks(|_| {
        let none: [Option<ExitCode>; 1] = [None];
        none.map(Option::unwrap)[0]
    });
}

#[test]
#[ignore = "a part of a_panic_on_one_rank_ends_the_others"]
fn one_rank_panics() {
    on_ranks(|world| {
        assert!(world.rank() != 1, "lost its way");
        world.barrier();
        ExitCode::SUCCESS
    });
}

#[test]
fn a_failure_on_one_rank_ends_the_others() {
    let ended = play("one_rank_fails", 3);
    assert!(!ended.status.success());
    assert!(ended.took < SOON, "took {:?}", ended.took);
}

#[test]
#[ignore = "a part of a_failure_on_one_rank_ends_the_others"]
fn one_rank_fails() {
    on_ranks(|world| {
        if world.rank() == 0 {
            return ExitCode::FAILURE;
        }
        world.barrier();
        ExitCode::SUCCESS
    });
}

#[test]
fn a_hang_names_its_task_and_where_each_rank_is() {
    let message = message_of_a_timeout();
    assert!(message.contains("task 0.1: 2 ranks gave no answer within 2 s"), "{message}");
    assert!(
        message.contains("some rank waits for a call that another rank does not make"),
        "{message}"
    );
    assert!(message.contains("rank 0 is in its receive, in MPI_"), "{message}");
    assert!(message.contains("rank 1 is in its receive, in MPI_"), "{message}");
    assert!(message_of_a_timeout().contains("task 0.1: not tried"), "another job of the same task");
}

fn message_of_a_timeout() -> String {
    let timeout = catch_unwind(|| Job::part("0.1", "all_ranks_wait", 2).within(2).run());
    *timeout.expect_err("it hangs").downcast().expect("words")
}

#[test]
#[ignore = "a part of a_hang_names_its_task_and_where_each_rank_is"]
fn all_ranks_wait() {
    on_ranks(|world| {
        let (_, _): (u8, _) = together("its receive", || world.any_process().receive());
        ExitCode::SUCCESS
    });
}
