// Task 9.5: the greedy choice, on the device.
//
// On the host the candidates are sorted, and each is taken whose discs are still free. A sort is
// hard to spread over thousands of invocations, and it is not needed. A candidate that comes first
// among all candidates of *each* of its discs must happen: nothing can take its discs away. Take
// all of those at once, drop the candidates whose discs are gone, and begin again. The first of
// all is always among them, so it ends; and it takes the same candidates as the sort.
//
// Times are f64, and this device may have none. But of two positive floating-point numbers the
// larger also has the larger bits. So a time is two u32, `high` and `low`, compared one after the
// other, exactly and on any device.
//
// At the same time walls come before pairs, and pairs in the order of their first disc, then
// their second. For the candidates of one disc that is the order of the *other* disc's number:
// its `rank` is 0 for a wall and else the other disc's number + 1.

struct Candidate {
    high: u32,
    low: u32,
    // The discs, or the disc and WALL.
    a: u32,
    b: u32,
}

const WALL: u32 = 0xffffffffu;
const NONE: u32 = 0xffffffffu;

struct Numbers {
    candidates: u32,
    discs: u32,
}
@group(0) @binding(0) var<uniform> numbers: Numbers;

@group(0) @binding(1) var<storage, read> candidates: array<Candidate>;

// 1 for the candidates that happen.
@group(0) @binding(2) var<storage, read_write> taken: array<u32>;

// 1 for the discs that have collided in this step. Atomic, because some invocations read it while others write.
@group(0) @binding(3) var<storage, read_write> busy: array<atomic<u32>>;

// What comes first among a disc's candidates: NONE in all three at the start of a round.
struct First {
    high: atomic<u32>,
    low: atomic<u32>,
    rank: atomic<u32>,
}
@group(0) @binding(4) var<storage, read_write> firsts: array<First>;

// Candidates that have been neither taken nor dropped when the round ends.
@group(0) @binding(5) var<storage, read_write> left: atomic<u32>;

// Whether candidate number i exists and both its discs are free.
fn is_open(i: u32) -> bool {
    if i >= numbers.candidates {
        return false;
    }
    let c = candidates[i];
    return atomicLoad(&busy[c.a]) == 0u && (c.b == WALL || atomicLoad(&busy[c.b]) == 0u);
}

// A round is five launches: each must see all that the one before it wrote.

@compute @workgroup_size(THREADS)
fn forget(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let disc = invocation(id, groups);
    if disc < numbers.discs {
        atomicStore(&firsts[disc].high, NONE);
        atomicStore(&firsts[disc].low, NONE);
        atomicStore(&firsts[disc].rank, NONE);
    }
    if disc == 0u {
        atomicStore(&left, 0u);
    }
}

// First launch: firsts[disc].high becomes the least `high` of the disc's open candidates. Here
// `c` is one of them.
fn lower_high(c: Candidate, disc: u32) {
    atomicMin(&firsts[disc].high, c.high);
}

// Second launch: firsts[disc].low becomes the least `low` of those of its open candidates whose
// `high` is the least.
fn lower_low(c: Candidate, disc: u32) {
    // task 9.5: the lower half of a time
    if c.high == atomicLoad(&firsts[disc].high) {
        atomicMin(&firsts[disc].low, c.low);
    }
    // end 9.5
}

// Whether no open candidate of `disc` is earlier than `c`.
fn is_earliest(c: Candidate, disc: u32) -> bool {
    return atomicLoad(&firsts[disc].high) == c.high && atomicLoad(&firsts[disc].low) == c.low;
}

// The rank of a candidate for one of its discs, if `other` is its other disc or WALL. WALL is the
// greatest number, and adding 1 to it gives 0.
fn rank(other: u32) -> u32 {
    return other + 1u;
}

// Third launch: firsts[disc].rank becomes the least rank of those of its open candidates that are
// the earliest.
fn lower_rank(c: Candidate, disc: u32, other: u32) {
    // task 9.5b: of equal times the lower rank
    if is_earliest(c, disc) {
        atomicMin(&firsts[disc].rank, rank(other));
    }
    // end 9.5b
}

// Whether `c` comes first among the open candidates of `disc`.
fn is_first(c: Candidate, disc: u32, other: u32) -> bool {
    return is_earliest(c, disc) && atomicLoad(&firsts[disc].rank) == rank(other);
}

// Fourth launch, for each open candidate, number i: if it comes first for each of its discs (a
// wall is no disc), it happens: taken[i] becomes 1, and so does `busy` of its discs. If not, it is
// counted in `left`.
fn take_or_leave(i: u32) {
    let c = candidates[i];
    // task 9.5c: take what comes first
    if is_first(c, c.a, c.b) && (c.b == WALL || is_first(c, c.b, c.a)) {
        taken[i] = 1u;
        atomicStore(&busy[c.a], 1u);
        if c.b != WALL {
            atomicStore(&busy[c.b], 1u);
        }
    } else {
        atomicAdd(&left, 1u);
    }
    // end 9.5c
}

@compute @workgroup_size(THREADS)
fn least_high(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let i = invocation(id, groups);
    if is_open(i) {
        let c = candidates[i];
        lower_high(c, c.a);
        if c.b != WALL {
            lower_high(c, c.b);
        }
    }
}

@compute @workgroup_size(THREADS)
fn least_low(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let i = invocation(id, groups);
    if is_open(i) {
        let c = candidates[i];
        lower_low(c, c.a);
        if c.b != WALL {
            lower_low(c, c.b);
        }
    }
}

@compute @workgroup_size(THREADS)
fn least_rank(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let i = invocation(id, groups);
    if is_open(i) {
        let c = candidates[i];
        lower_rank(c, c.a, c.b);
        if c.b != WALL {
            lower_rank(c, c.b, c.a);
        }
    }
}

@compute @workgroup_size(THREADS)
fn take(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let i = invocation(id, groups);
    if is_open(i) {
        take_or_leave(i);
    }
}
