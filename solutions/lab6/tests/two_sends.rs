//! The example of chapter 6: two ranks that both send first, and the same messages started
//! together.

use std::process::ExitCode;

use common_mpi::as_rank;
use mpi::request::{Request, scope};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::mpiexec::{join_columns, on_each, print_column};
use oracle::{spaced, watched};

/// The number of times that a rank tests whether its send is complete.
const LOOKS: usize = 1000;

/// Two synchronous sends do not complete before their receives begin.
///
/// The library may not buffer a synchronous send, however short it is. The sends are started and
/// tested instead of called, so that this test finishes. A rank begins its receive only after both
/// ranks have tested their sends for the last time.
#[test]
fn two_sends_wait_for_each_other() {
    watched("two_sends_wait_for_each_other", || {
        let table = on_two_ranks(|world| {
            let (own, mut incoming) = (ghosts(world.rank()), [0; 2]);
            let other = world.process_at_rank(1 - world.rank());
            scope(|scope| {
                let mut rows = vec![("ghosts to send", spaced(own)), ("send", "begins".into())];
                let mut send = Some(other.immediate_synchronous_send(scope, &own[..]));
                world.barrier();
                rows.push(("is it through?", ask(&mut send)));
                for _ in 1..LOOKS {
                    ask(&mut send);
                }
                rows.push(("asked 1000 times", ask(&mut send)));
                world.barrier();
                // In the two programs, the receives come after the sends, and are not reached.
                let reached = if send.is_some() { "not reached" } else { "begins" };
                rows.push(("receive", reached.into()));
                print_column(world.rank(), &rows);
                other.receive_into(&mut incoming[..]);
                if let Some(send) = send {
                    send.wait_without_status();
                }
            });
        });
        insta::assert_snapshot!(table);
    });
}

#[test]
fn started_together_they_arrive() {
    watched("started_together_they_arrive", || {
        let table = on_two_ranks(|world| {
            let (own, mut incoming) = (ghosts(world.rank()), [0; 2]);
            let other = world.process_at_rank(1 - world.rank());
            let mut rows = vec![("ghosts to send", spaced(own))];
            scope(|scope| {
                let receive = other.immediate_receive_into(scope, &mut incoming[..]);
                rows.push(("receive", "started".into()));
                let send = other.immediate_synchronous_send(scope, &own[..]);
                rows.push(("send", "started".into()));
                receive.wait_without_status();
                rows.push(("wait for the receive", "through".into()));
                send.wait_without_status();
                rows.push(("wait for the send", "through".into()));
            });
            rows.push(("ghosts received", spaced(incoming)));
            print_column(world.rank(), &rows);
        });
        insta::assert_snapshot!(table);
    });
}

/// Returns the columns printed by two ranks that each run `part`.
fn on_two_ranks(part: impl FnOnce(&SimpleCommunicator)) -> String {
    let job = on_each("6.3", &[2], || {
        as_rank(|world| {
            part(world);
            ExitCode::SUCCESS
        });
    });
    join_columns(&job.stdout)
}

/// The particles that a rank sends to the other.
fn ghosts(rank: i32) -> [u32; 2] {
    if rank == 0 { [2, 3] } else { [4, 5] }
}

/// Tests whether the send is complete. A complete send is removed from `send`.
fn ask<'a, D: ?Sized, S: mpi::request::Scope<'a>>(send: &mut Option<Request<'a, D, S>>) -> String {
    *send = send.take().and_then(|request| request.test().err());
    if send.is_some() { "waits" } else { "through" }.into()
}
