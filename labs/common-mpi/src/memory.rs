//! How much memory a rank takes.

use std::fs;

use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// The most memory that each rank had since it started, in MiB: of the mean rank and of the one
/// with most. All ranks call it together; only the root gets the answer, and only where the system
/// tells it (Linux). The MPI library's own memory is part of it.
pub fn report_memory(world: &SimpleCommunicator) -> Vec<(&'static str, f64)> {
    let own = peak_resident().unwrap_or(0.0);
    let (mut sum, mut most) = (0.0, 0.0);
    let root = world.process_at_rank(0);
    if world.rank() != 0 {
        root.reduce_into(&own, SystemOperation::sum());
        root.reduce_into(&own, SystemOperation::max());
        return Vec::new();
    }
    root.reduce_into_root(&own, &mut sum, SystemOperation::sum());
    root.reduce_into_root(&own, &mut most, SystemOperation::max());
    if most == 0.0 {
        return Vec::new();
    }
    vec![
        ("resident MiB, mean rank", sum / f64::from(world.size())),
        ("resident MiB, largest rank", most),
    ]
}

/// The most physical memory that this process had, in MiB.
fn peak_resident() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes / 1024.0)
}
