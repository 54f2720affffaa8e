//! Reports of ranks: the messages and bytes that they send, and their memory.

use std::fs;

use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// A counter of the messages and bytes that this rank sends to other ranks.
///
/// It counts the messages that the program requests. The library may send them in a different way,
/// such as a gather through other ranks.
#[derive(Clone, Copy, Debug, Default)]
pub struct Traffic {
    steps: u64,
    messages: u64,
    bytes: u64,
}

impl Traffic {
    /// Begins a step.
    pub fn begin_step(&mut self) {
        self.steps += 1;
    }

    /// Counts one message that carries these items to another rank.
    pub fn sent<T>(&mut self, items: &[T]) {
        self.messages += 1;
        self.bytes += size_of_val(items) as u64;
    }

    /// Counts an exchange. Rank `own` sends every other rank a count, followed by that rank's list
    /// unless the list is empty. `lists` has a list for each rank.
    pub fn exchanged<T>(&mut self, own: usize, lists: &[Vec<T>]) {
        for (_, list) in lists.iter().enumerate().filter(|(rank, _)| *rank != own) {
            self.sent(&[0_i32]);
            if !list.is_empty() {
                self.sent(list);
            }
        }
    }

    /// Returns the messages and bytes per step: the mean over all ranks, and the numbers of the busiest
    /// rank. All ranks call it together. Only the root, rank 0, gets the result.
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

/// Returns the peak memory of the ranks since they started: the mean and the maximum, in MiB.
///
/// The memory includes the MPI library's own memory. All ranks call it together. Only the root gets
/// the result, and only if the system reports it (Linux).
pub fn report_memory(world: &SimpleCommunicator) -> Vec<(&'static str, f64)> {
    let own = [peak_resident().unwrap_or(0.0)];
    match mean_and_greatest(own, world) {
        Some([(mean, most)]) if most > 0.0 => {
            vec![("resident MiB, mean rank", mean), ("resident MiB, largest rank", most)]
        }
        _ => Vec::new(),
    }
}

/// Returns the peak physical memory of this process in MiB.
fn peak_resident() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes / 1024.0)
}

/// Returns the mean and the maximum of each number over all ranks. All ranks call it together. Only
/// the root, rank 0, gets the result.
fn mean_and_greatest<const N: usize>(
    own: [f64; N],
    world: &SimpleCommunicator,
) -> Option<[(f64, f64); N]> {
    let (mut sum, mut greatest) = ([0.0; N], [0.0; N]);
    let root = world.process_at_rank(0);
    if world.rank() != 0 {
        root.reduce_into(&own, SystemOperation::sum());
        root.reduce_into(&own, SystemOperation::max());
        return None;
    }
    root.reduce_into_root(&own, &mut sum, SystemOperation::sum());
    root.reduce_into_root(&own, &mut greatest, SystemOperation::max());
    let ranks = f64::from(world.size());
    Some(std::array::from_fn(|k| (sum[k] / ranks, greatest[k])))
}
