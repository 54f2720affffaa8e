//! Questions about barriers between accesses of different invocations to the same shared number. A
//! barrier is needed between two such accesses if one of them writes.
//!
//! A device may run invocations in an order in which a missing barrier is harmless. Therefore the
//! shared numbers are replaced by numbers that record their readers and writers since the last
//! barrier.

use device::{Gpu, Kernel, Launch, Launcher, Readback, Work};
use device_discs::soft::SoftKernels;
use lab9::Lab9;
use oracle::{Ask, Random};

use super::adapter::adapter;

/// Number of barriers that are counted. A correct program needs fewer: two in each round.
const MEETINGS: u32 = 64;

/// Factor of the barrier count in the code of a conflict. The code is the number of barriers before
/// the conflict, times this factor, plus the index of the number.
const PLACES: u32 = 1 << 16;

/// A kernel that records accesses. An access is recorded as barriers times 65,536 plus the number
/// of the invocation, so that the greatest record is the latest. One record is kept for the first
/// invocation and one for the last, so at least one of them belongs to a different invocation if
/// such an access exists.
const WATCHED: &str = "
@group(0) @binding(2) var<storage, read_write> conflict: atomic<u32>;
@group(0) @binding(3) var<storage, read_write> meetings: array<atomic<u32>>;

@group(0) @binding(4) var<storage, read_write> parting: atomic<u32>;

var<private> own: u32;
var<private> now: u32 = 1u;
// For each barrier, a bit for each place of the program at which an invocation has called meet() as
// this barrier.
var<workgroup> places: array<atomic<u32>, 64>;

var<workgroup> numbers: array<atomic<u32>, THREADS>;
var<workgroup> first_reader: array<atomic<u32>, THREADS>;
var<workgroup> last_reader: array<atomic<u32>, THREADS>;
var<workgroup> first_writer: array<atomic<u32>, THREADS>;
var<workgroup> last_writer: array<atomic<u32>, THREADS>;

fn as_first() -> u32 {
    return now * 65536u + 65535u - own;
}

fn as_last() -> u32 {
    return now * 65536u + own;
}

fn look(k: u32, first: u32, last: u32) {
    let is_another = (first / 65536u == now && first != as_first()) || (last / 65536u == now && last != as_last());
    if is_another {
        atomicMin(&conflict, now * 65536u + k);
    }
}

fn put(k: u32, number: u32) {
    atomicMax(&first_writer[k], as_first());
    atomicMax(&last_writer[k], as_last());
    look(k, atomicLoad(&first_writer[k]), atomicLoad(&last_writer[k]));
    look(k, atomicLoad(&first_reader[k]), atomicLoad(&last_reader[k]));
    atomicStore(&numbers[k], number);
}

fn fetch(k: u32) -> u32 {
    atomicMax(&first_reader[k], as_first());
    atomicMax(&last_reader[k], as_last());
    look(k, atomicLoad(&first_writer[k]), atomicLoad(&last_writer[k]));
    return atomicLoad(&numbers[k]);
}

fn meet_at(place: u32) {
    let index = min(now, arrayLength(&meetings)) - 1u;
    atomicAdd(&meetings[index], 1u);
    atomicOr(&places[index], 1u << place);
    workgroupBarrier();
    if countOneBits(atomicLoad(&places[index])) > 1u {
        atomicMin(&parting, now);
    }
    now++;
}
";

pub(crate) fn meetings(_: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.6") else { return };
    assert!(
        !Lab9::scan().contains("Barrier("),
        "task 9.6: call meet() instead of a WGSL barrier, because this test watches the accesses between two calls of \
         meet()"
    );
    for threads in [2, 3, 8, 64, 96] {
        // The last of three workgroups is nearly empty.
        let n = 2 * threads + 1;
        let question = format!(
            "{n} numbers, workgroups of {threads}: (1) the first conflict, encoded as {PLACES} × (1 + the number of \
             barriers before it) + the index of the shared number, or -1 if there is no conflict, (2) the number of \
             the first barrier that invocations reach at different calls of meet(), or -1 if there is none, (3) for \
             each barrier, the number of invocations that reach it"
        );
        let found = || watched(gpu, n, threads);
        ask.judge(&question, found, |found| verdict(found, threads));
    }
}

/// Returns the kernel's source, in which each call of `meet()` passes its number.
///
/// Two calls in two branches are two barriers, even if each invocation executes one of them.
fn with_places() -> String {
    let mut parts = Lab9::scan().split("meet()");
    let first = parts.next().unwrap_or_default().to_owned();
    (0..)
        .zip(parts)
        .fold(first, |all, (place, part)| format!("{all}meet_at({}u){part}", place % 32))
}

/// Returns the first conflict, the first barrier at which invocations part (or -1), and for each
/// barrier the number of invocations of three workgroups that reached it.
fn watched(gpu: &Gpu, n: u32, threads: u32) -> Vec<f64> {
    let scan = with_places();
    let sources = [&scan, WATCHED];
    let kernel = Lab9::checked(gpu, "scan_blocks", || {
        Kernel::new(gpu, "scan_blocks", &sources, threads, &[])
    });
    let kernel = kernel.unwrap_or_else(|error| panic!("{error}"));
    let buffer = |numbers: &[u32]| {
        let buffer = gpu.storage("the test's memory", 4 * numbers.len() as u64);
        let buffer = buffer.expect("the device has enough memory");
        gpu.upload(&buffer, numbers);
        buffer
    };
    let values = buffer(&vec![1; n as usize]);
    let sums = buffer(&[0; 3]);
    let conflict = buffer(&[u32::MAX]);
    let meetings = buffer(&[0; MEETINGS as usize]);
    let parting = buffer(&[u32::MAX]);
    let buffers = [(0, &values), (1, &sums), (2, &conflict), (3, &meetings), (4, &parting)];
    let mut work = Work::new(gpu, None);
    work.launch(&kernel.bind(gpu, &buffers), Launch { groups: [3, 1], threads });
    let all = [(&conflict, 0..1), (&parting, 0..1), (&meetings, 0..u64::from(MEETINGS))];
    let [conflict, parting, met] = Readback::default().read::<u32, 3>(gpu, work, all);
    let first = |all: &[u32]| if all[0] == u32::MAX { -1.0 } else { f64::from(all[0]) };
    [first(&conflict), first(&parting)]
        .into_iter()
        .chain(met.iter().map(|met| f64::from(*met)))
        .collect()
}

fn verdict(found: &[f64], threads: u32) -> Result<(), String> {
    let [conflict, parting, met @ ..] = found else {
        return Err("the answer is not complete".into());
    };
    let all = f64::from(3 * threads);
    if let Some(k) = met.iter().position(|met| *met != 0.0 && *met != all) {
        return Err(format!(
            "call {} of meet() is reached by {} of {all} invocations, but all invocations must reach each call",
            k + 1,
            met[k]
        ));
    }
    if *parting >= 0.0 {
        return Err(format!(
            "the invocations of a workgroup reach barrier number {parting} at two different calls of meet() in the \
             program. Whether meet() is called may not depend on `local`"
        ));
    }
    if *conflict < 0.0 {
        let rounds = threads.next_power_of_two().ilog2();
        let calls = met.iter().filter(|met| **met != 0.0).count() as u32;
        // One barrier more may be before the first round, and one after the last.
        if calls > 2 * rounds + 2 {
            return Err(format!(
                "each invocation calls meet() {calls} times, but {rounds} rounds need only two calls each"
            ));
        }
        return Ok(());
    }
    let (before, number) = (*conflict as u32 / PLACES - 1, *conflict as u32 % PLACES);
    Err(format!(
        "after {before} calls of meet(), one invocation writes the shared number {number}, and a different invocation \
         reads or writes it without a call of meet() in between"
    ))
}
