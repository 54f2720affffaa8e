//! The greedy choice: on the host by sorting, or on the device without sorting.

use std::marker::PhantomData;

use device::{Bound, Gpu, GpuError, Kernel, Readback, Stopwatch, Work};
use solution7::{Candidate, Hit, take_in_order};
use thiserror::Error;
use wgpu::Buffer;

use super::finder::WALL;
use super::kernels::HardKernels;

/// Number of rounds that are submitted before the host tests whether more rounds are needed.
const ROUNDS: usize = 4;

/// The kernels of a round, in order.
const KERNELS: [&str; 5] = ["forget", "least_high", "least_low", "least_rank", "take"];

/// The reason why the device made no choice.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ChoiceError {
    /// A call failed, usually because the device has too little memory.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The rounds did not end, because the kernels or the device are faulty.
    #[error(
        "the choice among {open} candidates does not settle: each round takes one or more, but \
         after {rounds} rounds {left} are still open"
    )]
    Unsettled {
        /// Number of rounds that were run.
        rounds: usize,
        /// Number of open candidates before these rounds.
        open: u32,
        /// Number of open candidates after these rounds.
        left: u32,
    },
}

/// The place where the choice among the candidates is made.
pub enum Choice<K> {
    /// The host sorts the candidates and takes them in order.
    Host,
    /// In each round, the device takes all candidates that come first for all of their discs.
    Device(Box<Chooser<K>>),
}

impl<K: HardKernels> Choice<K> {
    /// Appends to `taken` the candidates that really happen, and marks their discs as not free.
    ///
    /// # Errors
    /// The device has too little memory for these candidates, or its rounds do not end.
    pub fn take(
        &mut self,
        candidates: &mut [Candidate],
        free: &mut [bool],
        taken: &mut Vec<Candidate>,
    ) -> Result<(), ChoiceError> {
        match self {
            Self::Host => take_in_order(candidates, free, taken),
            Self::Device(chooser) => {
                let flags = chooser.choose(candidates, free.len() as u32)?;
                for (candidate, _) in candidates.iter().zip(flags).filter(|(_, flag)| *flag == 1) {
                    free[candidate.hit.first() as usize] = false;
                    if let Some(second) = candidate.hit.second() {
                        free[second as usize] = false;
                    }
                    taken.push(*candidate);
                }
            }
        }
        Ok(())
    }
}

/// The choice on the device, with the kernels `K`.
pub struct Chooser<K> {
    gpu: &'static Gpu,
    kernels: Vec<Kernel>,
    threads: u32,
    stopwatch: Option<Stopwatch>,
    readback: Readback,
    memory: Option<Memory>,
    kernels_of: PhantomData<K>,
}

/// Buffers for a number of candidates and discs, bound to the kernels.
struct Memory {
    candidates: u32,
    discs: u32,
    numbers: Buffer,
    keys: Buffer,
    taken: Buffer,
    busy: Buffer,
    left: Buffer,
    bound: Vec<Bound>,
}

impl<K: HardKernels> Chooser<K> {
    /// Compiles the kernels.
    ///
    /// # Errors
    /// The device cannot run workgroups of `threads`.
    pub fn new(
        gpu: &'static Gpu,
        threads: u32,
        stopwatch: Option<Stopwatch>,
    ) -> Result<Self, GpuError> {
        K::launch(1, threads, &gpu.limits())?;
        let source = [K::choose()];
        let kernels = KERNELS.map(|name| K::compiled(gpu, name, &source, threads, &[]));
        Ok(Self {
            gpu,
            kernels: kernels.into_iter().collect::<Result<_, _>>()?,
            threads,
            stopwatch,
            readback: Readback::default(),
            memory: None,
            kernels_of: PhantomData,
        })
    }

    /// Returns 1 for each candidate that really happens, and 0 for the others. All `discs` discs
    /// are free at first.
    ///
    /// Every round takes at least the first of all open candidates, so the number of open
    /// candidates falls from round to round. If it does not, the kernels or the device are faulty,
    /// and more rounds would not help.
    ///
    /// # Errors
    /// The device has too little memory for these candidates, or the error is
    /// [`ChoiceError::Unsettled`].
    pub fn choose(
        &mut self,
        candidates: &[Candidate],
        discs: u32,
    ) -> Result<Vec<u32>, ChoiceError> {
        let count = candidates.len() as u32;
        if count == 0 {
            return Ok(Vec::new());
        }
        if self.memory.as_ref().is_none_or(|m| m.candidates < count || m.discs < discs) {
            self.memory = Some(Memory::new(self.gpu, &self.kernels, count, discs)?);
        }
        let memory = self.memory.as_ref().expect("it was just made");
        let limits = self.gpu.limits();
        let over_candidates =
            K::launch_over(count, self.threads, &limits).map_err(GpuError::from)?;
        let over_discs = K::launch_over(discs, self.threads, &limits).map_err(GpuError::from)?;
        self.gpu.upload(&memory.numbers, &[count, discs]);
        self.gpu.upload(&memory.keys, &candidates.iter().map(key).collect::<Vec<_>>());
        // ANCHOR: rounds
        let mut open = count;
        loop {
            let mut work = Work::new(self.gpu, self.stopwatch.as_ref());
            if open == count {
                work.clear(&memory.taken);
                work.clear(&memory.busy);
            }
            for _ in 0..ROUNDS {
                for (name, kernel) in KERNELS.iter().zip(&memory.bound) {
                    let forget = *name == "forget";
                    work.launch(kernel, if forget { over_discs } else { over_candidates });
                }
            }
            let wanted = [(&memory.left, 0..1), (&memory.taken, 0..u64::from(count))];
            let [left, taken] = self.readback.read::<u32, 2>(self.gpu, work, wanted);
            match left[0] {
                0 => return Ok(taken),
                left if left.saturating_add(ROUNDS as u32) > open => {
                    return Err(ChoiceError::Unsettled { rounds: ROUNDS, open, left });
                }
                left => open = left,
            }
        }
        // ANCHOR_END: rounds
    }

    /// Returns the clock, if there is one.
    pub fn stopwatch(&self) -> Option<&Stopwatch> {
        self.stopwatch.as_ref()
    }
}

impl Memory {
    fn new(gpu: &Gpu, kernels: &[Kernel], candidates: u32, discs: u32) -> Result<Self, GpuError> {
        let candidates = candidates.next_power_of_two();
        let word = size_of::<u32>() as u64;
        let of_candidates = word * u64::from(candidates);
        let of_discs = word * u64::from(discs);
        let numbers = gpu.uniform(&[0; 8]);
        let keys = gpu.storage("the candidates' keys", 4 * of_candidates)?;
        let taken = gpu.storage("the taken candidates", of_candidates)?;
        let busy = gpu.storage("the busy discs", of_discs)?;
        let firsts = gpu.storage("the discs' first candidates", 3 * of_discs)?;
        let left = gpu.storage("the candidates left", word)?;
        let all = [&numbers, &keys, &taken, &busy, &firsts, &left];
        // The buffers that each kernel uses, in the order of `KERNELS`.
        let used: [&[u32]; 5] =
            [&[0, 4, 5], &[0, 1, 3, 4], &[0, 1, 3, 4], &[0, 1, 3, 4], &[0, 1, 2, 3, 4, 5]];
        let bind = |(kernel, used): (&Kernel, &[u32])| {
            let buffers: Vec<_> = used.iter().map(|&k| (k, all[k as usize])).collect();
            kernel.bind(gpu, &buffers)
        };
        let bound = kernels.iter().zip(used).map(bind).collect();
        Ok(Self { candidates, discs, numbers, keys, taken, busy, left, bound })
    }
}

/// Returns a candidate in the kernels' form: the upper and the lower half of its time, and its
/// discs.
///
/// The bits of −0.0 would be sorted last. Adding zero turns −0.0 into 0.0.
fn key(candidate: &Candidate) -> [u32; 4] {
    let bits = (candidate.time + 0.0).to_bits();
    let (a, b) = match candidate.hit {
        Hit::Pair(a, b) => (a, b),
        wall => (wall.first(), WALL),
    };
    [(bits >> 32) as u32, bits as u32, a, b]
}
