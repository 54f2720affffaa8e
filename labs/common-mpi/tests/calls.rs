//! Messages about ranks whose calls do not match.
//!
//! As in `job.rs`, a test starts this program again on ranks to play a part.

use std::process::ExitCode;
use std::time::Duration;

use common_mpi::{as_rank, calls_made, together};
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::mpiexec::Job;

/// Time limit, much shorter than the time after which the watch would report where ranks are.
const AT_ONCE: Duration = Duration::from_secs(30);

fn program(part: impl FnOnce(&SimpleCommunicator)) {
    let code = as_rank(|world| {
        part(world);
        ExitCode::SUCCESS
    });
    assert_eq!(code, ExitCode::SUCCESS);
}

/// Returns the message of `part` on three ranks, which must fail immediately.
fn message(part: &str) -> String {
    let ended = Job::part("0.0", part, 3).run();
    assert!(!ended.status.success(), "{part} goes well");
    assert!(ended.took < AT_ONCE, "{part} took {:?}", ended.took);
    ended.stderr
}

fn assert_message(part: &str, words: &[&str]) {
    let message = message(part);
    for words in words {
        assert!(message.contains(words), "{part}: '{words}' is not in\n{message}");
    }
}

#[test]
fn different_calls_are_named_with_their_lines() {
    let [gather, broadcast] =
        ["rank 0: MPI_Gather of root 0 (", "ranks 1, 2: MPI_Bcast of root 0 ("];
    let words = ["Ranks make different calls as collective call 2", gather, broadcast];
    assert_message("one_gathers", &words);
    assert_message("one_gathers", &["tests/calls.rs, line "]);
}

#[test]
#[ignore = "a part of different_calls_are_named_with_their_lines"]
fn one_gathers() {
    program(|world| {
        world.barrier();
        let root = world.process_at_rank(0);
        if world.rank() == 0 {
            root.gather_into_root(&1, &mut [0; 3][..]);
        } else {
            root.broadcast_into(&mut 0);
        }
    });
}

#[test]
fn different_reductions_are_different_calls() {
    let words = ["rank 1: MPI_Allreduce of a maximum (", "ranks 0, 2: MPI_Allreduce of a sum ("];
    assert_message("one_takes_the_maximum", &words);
}

#[test]
#[ignore = "a part of different_reductions_are_different_calls"]
fn one_takes_the_maximum() {
    program(|world| {
        let maximum = world.rank() == 1;
        let by = if maximum { SystemOperation::max() } else { SystemOperation::sum() };
        world.all_reduce_into(&1, &mut 0, by);
    });
}

#[test]
fn a_rank_that_has_ended_is_named() {
    let words = ["rank 1: no further call: the rank has ended", "ranks 0, 2: MPI_Barrier ("];
    assert_message("one_ends", &words);
}

#[test]
#[ignore = "a part of a_rank_that_has_ended_is_named"]
fn one_ends() {
    program(|world| {
        if world.rank() != 1 {
            world.barrier();
        }
    });
}

#[test]
fn buffers_that_do_not_fit_are_named_with_their_lengths() {
    let words = ["rank 1 has room for 3 items of 8 bytes, and rank 0, the root, sends it 2 items"];
    assert_message("one_expects_more", &words);
    let words = ["use buffers of different lengths in", "rank 2: MPI_Bcast with 1 item of 8 bytes"];
    assert_message("one_expects_less", &words);
}

#[test]
#[ignore = "a part of buffers_that_do_not_fit_are_named_with_their_lengths"]
fn one_expects_more() {
    program(|world| {
        let root = world.process_at_rank(0);
        if world.rank() == 0 {
            root.scatter_into_root(&[0_u64; 6][..], &mut [0_u64; 2][..]);
        } else {
            root.scatter_into(&mut vec![0_u64; world.rank() as usize + 2][..]);
        }
    });
}

#[test]
#[ignore = "a part of buffers_that_do_not_fit_are_named_with_their_lengths"]
fn one_expects_less() {
    program(|world| {
        let mut buffer = vec![0_u64; if world.rank() == 2 { 1 } else { 2 }];
        world.process_at_rank(0).broadcast_into(&mut buffer[..]);
    });
}

#[test]
fn the_roots_methods_are_the_roots() {
    let words =
        ["rank 1 calls gather_into_root (", "only the root may call a method that ends in _root"];
    assert_message("all_call_as_the_root", &words);
    assert_message("the_root_calls_as_others", &["rank 0, the root, calls reduce_into ("]);
}

#[test]
#[ignore = "a part of the_roots_methods_are_the_roots"]
fn all_call_as_the_root() {
    program(|world| {
        if world.rank() < 2 {
            world.process_at_rank(0).gather_into_root(&1, &mut [0; 3][..]);
        } else {
            world.process_at_rank(0).gather_into(&1);
        }
    });
}

#[test]
#[ignore = "a part of the_roots_methods_are_the_roots"]
fn the_root_calls_as_others() {
    program(|world| {
        world.process_at_rank(0).reduce_into(&1, SystemOperation::sum());
    });
}

#[test]
fn calls_are_counted_from_the_last_that_is_watched() {
    let ended = Job::part("0.0", "two_calls_together", 2).run();
    assert!(ended.status.success(), "{}", ended.stderr);
}

#[test]
#[ignore = "a part of calls_are_counted_from_the_last_that_is_watched"]
fn two_calls_together() {
    program(|world| {
        world.barrier();
        together("two calls", || {
            world.process_at_rank(0).broadcast_into(&mut 0);
            world.barrier();
        });
        assert_eq!(calls_made(), ["MPI_Bcast", "MPI_Barrier"]);
    });
}
