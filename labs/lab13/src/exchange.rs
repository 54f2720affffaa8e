//! Task 13.4: positions travel while inner particles move.

use mpi::Rank;
use mpi::request;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// Exchanges positions with all partners, and calls `meanwhile` once while the messages travel.
///
/// Send `sent[k]` to rank `partners[k]`, and fill `received[k]` with the positions from that rank.
/// Return when all positions have arrived.
///
/// Lab 6 had to send lengths first. Here both sides have known the number of ghosts since the list
/// was made. So `received[k]` has the right length, and every partner gets only one message.
///
/// Start all receives and all sends, call `meanwhile`, and finally wait
/// ([`Source::immediate_receive_into`], [`Destination::immediate_send`], [`request::scope`]). Send
/// empty lists too, because the partner waits for them.
///
/// Book: chapter 13, *Meanwhile*.
pub fn exchange_positions(
    world: &SimpleCommunicator,
    partners: &[Rank],
    sent: &[Vec<f64>],
    received: &mut [Vec<f64>],
    meanwhile: impl FnOnce(),
) {
    todo!("task 13.4: positions travel while inner particles move")
}
