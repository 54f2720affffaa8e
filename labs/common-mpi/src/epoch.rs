//! The moment from which all ranks count their times.

use std::time::{SystemTime, UNIX_EPOCH};

use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// Number of comparisons of the clocks of two machines.
const LOOKS: usize = 9;

/// Greatest length of a machine's name in bytes.
const LONGEST_NAME: usize = 256;

/// A moment from which all ranks count their times.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Epoch {
    /// The moment in nanoseconds, by the root's clock.
    start: u64,
    /// Seconds by which this rank's clock is ahead of the root's.
    ahead: f64,
}

impl Epoch {
    /// Returns the present moment of this rank alone.
    pub(crate) fn now() -> Self {
        Self { start: nanoseconds(), ahead: 0.0 }
    }

    /// Returns the present moment of the root. All ranks call it together.
    ///
    /// The ranks of one machine have the same clock. All ranks leave a barrier at nearly the same
    /// time, so the clocks of two machines are compared after barriers. The median of several
    /// comparisons is right even if a rank sometimes leaves a barrier late.
    pub(crate) fn of_root(world: &SimpleCommunicator) -> Self {
        let root = world.process_at_rank(0);
        let mut epoch = Self::now();
        root.broadcast_into(&mut epoch.start);
        let looks: [f64; LOOKS] = std::array::from_fn(|_| {
            world.barrier();
            epoch.seconds()
        });
        let mut roots = looks;
        root.broadcast_into(&mut roots[..]);
        let mut own_machine = mpi::environment::processor_name().unwrap_or_default().into_bytes();
        own_machine.resize(LONGEST_NAME, 0);
        let mut machine = own_machine.clone();
        root.broadcast_into(&mut machine[..]);
        if machine != own_machine {
            let mut apart: [f64; LOOKS] = std::array::from_fn(|k| looks[k] - roots[k]);
            apart.sort_by(f64::total_cmp);
            epoch.ahead = apart[LOOKS / 2];
        }
        epoch
    }

    /// Returns the seconds since the moment, by the root's clock.
    pub(crate) fn seconds(&self) -> f64 {
        nanoseconds().wrapping_sub(self.start).cast_signed() as f64 * 1e-9 - self.ahead
    }
}

fn nanoseconds() -> u64 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_nanos() as u64)
}
