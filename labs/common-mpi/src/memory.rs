//! How much memory a rank takes.

use std::fs;

use mpi::topology::SimpleCommunicator;

use crate::ranks::mean_and_greatest;

/// The most memory that each rank had since it started, in MiB: of the mean rank and of the one
/// with most. All ranks call it together; only the root gets the answer, and only where the system
/// tells it (Linux). The MPI library's own memory is part of it.
pub fn report_memory(world: &SimpleCommunicator) -> Vec<(&'static str, f64)> {
    let own = [peak_resident().unwrap_or(0.0)];
    match mean_and_greatest(own, world) {
        Some([(mean, most)]) if most > 0.0 => {
            vec![("resident MiB, mean rank", mean), ("resident MiB, largest rank", most)]
        }
        _ => Vec::new(),
    }
}

/// The most physical memory that this process had, in MiB.
fn peak_resident() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes / 1024.0)
}
