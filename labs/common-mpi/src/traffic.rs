//! Messages and bytes that a rank sends.

use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::ranks::mean_and_greatest;

/// Counts the messages and bytes that this rank sends to other ranks.
///
/// It counts what the program asks for. How the library carries it, such as a gather by way of
/// other ranks, is its own affair.
#[derive(Clone, Copy, Debug, Default)]
pub struct Traffic {
    steps: u64,
    messages: u64,
    bytes: u64,
}

impl Traffic {
    /// A step begins.
    pub fn begin_step(&mut self) {
        self.steps += 1;
    }

    /// These items go to one other rank in one message.
    pub fn sent<T>(&mut self, items: &[T]) {
        self.messages += 1;
        self.bytes += size_of_val(items) as u64;
    }

    /// Rank `own` sends each other rank a count, and its list if that has items: `lists` has one for every rank.
    pub fn exchanged<T>(&mut self, own: usize, lists: &[Vec<T>]) {
        for (_, list) in lists.iter().enumerate().filter(|(rank, _)| *rank != own) {
            self.sent(&[0_i32]);
            if !list.is_empty() {
                self.sent(list);
            }
        }
    }

    /// Messages and bytes per step: of the mean rank and of the one that sends most. All ranks
    /// call it together; only the root, rank 0, gets the answer.
    pub fn report(&self, world: &SimpleCommunicator) -> Vec<(&'static str, f64)> {
        let steps = self.steps.max(1) as f64;
        let own = [self.messages as f64 / steps, self.bytes as f64 / steps];
        let Some([messages, bytes]) = mean_and_greatest(own, world) else { return Vec::new() };
        vec![
            ("ranks", f64::from(world.size())),
            ("messages per step, mean rank", messages.0),
            ("messages per step, busiest rank", messages.1),
            ("bytes per step, mean rank", bytes.0),
            ("bytes per step, busiest rank", bytes.1),
        ]
    }
}
