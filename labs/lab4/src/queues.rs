//! Tasks 4.7 and 4.8: changes are passed to the owners of the bins.

use crossbeam::channel::{Receiver, Sender};
use crossbeam::queue::SegQueue;

use crate::{Bin, Change, Cut, apply_own};

/// Posts a change to the owners of its two bins, or only once if both bins have the same owner.
///
/// Thread r owns the bins of region r, and `queues[r]` is its queue. All threads post at the same
/// time. They need not wait for each other, because [`SegQueue::push`] needs no lock.
///
/// Book: chapter 4, *Queues*.
pub fn post(cut: Cut, queues: &[SegQueue<Change>], change: Change) {
    todo!("task 4.7: post a change to the owners of its bins")
}

/// Carries out the changes in the queue of region `own`, until the queue is empty.
///
/// `bins` are the bins of region `own`. No thread posts while this runs. [`apply_own`] makes the
/// changes.
///
/// Book: chapter 4, *Queues*.
pub fn take(cut: Cut, own: usize, bins: &mut [Bin], queue: &SegQueue<Change>) {
    todo!("task 4.7b: empty the own queue")
}

/// Sends a change to the owners of its two bins, or only once if both bins have the same owner.
///
/// Thread r owns the bins of region r, and receives the changes sent through `senders[r]`. No
/// channel is ever closed or full.
///
/// Book: chapter 4, *Channels*.
pub fn send(cut: Cut, senders: &[Sender<Change>], change: Change) {
    todo!("task 4.8: send a change to the owners of its bins")
}

/// Carries out the changes sent so far to the owner of region `own`, and returns without waiting.
///
/// `bins` are the bins of region `own`. The senders still exist, because the next step needs them.
/// So a loop that ends when all senders are gone ([`iter`](Receiver::iter)) would wait forever.
///
/// Book: chapter 4, *Channels*.
pub fn receive(cut: Cut, own: usize, bins: &mut [Bin], receiver: &Receiver<Change>) {
    todo!("task 4.8b: make the changes that have been received")
}
