//! Task 13.4: positions under way while inner particles move.

use mpi::Rank;
use mpi::request;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// Sends `sent[k]` to rank `partners[k]`, fills `received[k]` with what that rank sends, and calls
/// `meanwhile` once, while the messages are under way. Returns when everything has arrived.
///
/// Lab 6 had to send lengths first. Here both sides have known since the list was made how many
/// ghosts there are: `received[k]` has the right length, and every partner gets one message.
///
/// Start all receives, then all sends, then work; wait last
/// ([`Source::immediate_receive_into`], [`Destination::immediate_send`], [`request::scope`]). A
/// list may be empty: it is sent all the same, for the partner waits for it.
///
/// Book: chapter 13, *Meanwhile*.
pub fn exchange_positions(
    world: &SimpleCommunicator,
    partners: &[Rank],
    sent: &[Vec<f64>],
    received: &mut [Vec<f64>],
    meanwhile: impl FnOnce(),
) {
    todo!("task 13.4: positions under way while inner particles move")
}
