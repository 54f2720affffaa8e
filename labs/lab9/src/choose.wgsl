// Task 9.5: the greedy choice, on the device.
//
// The host sorts the candidates, and takes each candidate whose discs are still free. A sort is
// hard to spread over thousands of invocations, and it is not necessary. A candidate that comes
// first among all candidates of *each* of its discs must happen, because no other candidate can
// take its discs. Take all such candidates at once, drop the candidates whose discs are taken, and
// repeat. Each round takes at least the first of the remaining candidates, so the rounds end.
// Together they take the same candidates as the host does after its sort.
//
// Times are f64, but this device may not have f64. If positive floating-point numbers are in
// ascending order, their bits are too. So a time is stored as two u32, `high` and `low`. Comparing
// `high` first and then `low` is exact on any device.
//
// Of candidates with equal times, walls come before pairs, and pairs are in the order of their
// first disc, then of their second disc. For the candidates of one disc, this is the order of the
// *other* disc's number. So the `rank` of a candidate is 0 for a wall, and the other disc's
// number + 1 for a pair.

struct Candidate {
    high: u32,
    low: u32,
    // The two discs, or the disc and WALL.
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

// 1 for each candidate that happens.
@group(0) @binding(2) var<storage, read_write> taken: array<u32>;

// 1 for each disc that has collided in this step. It is atomic, because some invocations read it
// while others write it.
@group(0) @binding(3) var<storage, read_write> busy: array<atomic<u32>>;

// The first of a disc's candidates. All three numbers are NONE at the start of a round.
struct First {
    high: atomic<u32>,
    low: atomic<u32>,
    rank: atomic<u32>,
}
@group(0) @binding(4) var<storage, read_write> firsts: array<First>;

// The number of candidates that have been neither taken nor dropped at the end of the round.
@group(0) @binding(5) var<storage, read_write> left: atomic<u32>;

// Whether candidate number i exists and all its discs are free.
fn is_open(i: u32) -> bool {
    if i >= numbers.candidates {
        return false;
    }
    let c = candidates[i];
    return atomicLoad(&busy[c.a]) == 0u && (c.b == WALL || atomicLoad(&busy[c.b]) == 0u);
}

// A round is five launches, because each launch must see everything that the previous launch wrote.

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

// First launch: lowers firsts[disc].high to the least `high` of the disc's open candidates. `c` is
// one of them.
fn lower_high(c: Candidate, disc: u32) {
    atomicMin(&firsts[disc].high, c.high);
}

// Second launch: lowers firsts[disc].low to the least `low` of the disc's open candidates with the
// least `high`. `c` is one of the disc's open candidates.
fn lower_low(c: Candidate, disc: u32) {
    // todo: task 9.5: the lower half of a time
}

// Whether `c` is at least as early as every open candidate of `disc`.
fn is_earliest(c: Candidate, disc: u32) -> bool {
    return atomicLoad(&firsts[disc].high) == c.high && atomicLoad(&firsts[disc].low) == c.low;
}

// Returns the rank of a candidate for one of its discs. `other` is its other disc or WALL. WALL is
// the greatest number, so WALL + 1 is 0.
fn rank(other: u32) -> u32 {
    return other + 1u;
}

// Third launch: lowers firsts[disc].rank to the least rank of the disc's earliest open candidates.
// `c` is one of the disc's open candidates, and `other` is its other disc or WALL.
fn lower_rank(c: Candidate, disc: u32, other: u32) {
    // todo: task 9.5b: of equal times the lower rank
}

// Whether `c` comes first among the open candidates of `disc`.
fn is_first(c: Candidate, disc: u32, other: u32) -> bool {
    return is_earliest(c, disc) && atomicLoad(&firsts[disc].rank) == rank(other);
}

// Fourth launch: takes open candidate number i, or counts it in `left`.
//
// The candidate happens if it comes first for each of its discs (a wall is not a disc). Then set
// taken[i] to 1, and `busy` of its discs to 1.
fn take_or_leave(i: u32) {
    let c = candidates[i];
    // todo: task 9.5c: take what comes first
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
