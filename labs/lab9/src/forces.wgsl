// Task 9.7e: the forces, gathered.
//
// Each invocation sums the forces on one particle and moves it. Many invocations read the same
// particles, and each writes only its own: no locks, no atomics, and the same order of summation in
// every run. The price is lab 2's: each pair is computed twice.

override STATISTICS: bool = false;

// The statistics of one workgroup's particles; the host adds the workgroups up.
struct Tally {
    // The least r² of a pair.
    nearest: real,
    // The sum of the distances.
    sum: real,
    // Their number.
    pairs: u32,
    // Pairs looked at.
    tests: u32,
}

@group(0) @binding(8) var<storage, read_write> tallies: array<Tally>;

var<workgroup> seen: array<Tally, THREADS>;

// The acceleration that a neighbour at `d` causes: chapter 1's formula.
fn pair_acceleration(d: vec2<real>) -> vec2<real> {
    let r2 = dot(d, d);
    if r2 > CUTOFF * CUTOFF {
        return vec2<real>();
    }
    let clamped = max(r2, MIN_R * MIN_R);
    let r = sqrt(clamped);
    return (1.0 - CUTOFF / r) / clamped / MASS * d;
}

// Takes the pair at `d` into the statistics, if it is near enough and not a particle with itself.
fn look(tally: ptr<function, Tally>, d: vec2<real>) {
    (*tally).tests++;
    let r2 = dot(d, d);
    if r2 > 0.0 && r2 <= CUTOFF * CUTOFF {
        (*tally).nearest = min((*tally).nearest, r2);
        (*tally).sum += sqrt(r2);
        (*tally).pairs++;
    }
}

// The acceleration of sorted particle i.
//
// It adds up pair_acceleration(d) over all particles j of its own bin and the eight around it that
// exist, where d = separation(i, j, over) and `over` = (bin column of j − that of i, bin row of j −
// that of i), each −1, 0 or 1. j = i may be among them; it adds zero. The bins come row by row, the
// particles of a bin as they stand: from starts[bin] to before starts[bin + 1].
//
// If STATISTICS is set, call look(tally, d) for each j as well.
fn acceleration(i: u32, tally: ptr<function, Tally>) -> vec2<real> {
    var a = vec2<real>();
    let bin = sorted_tags[i].x;
    let here = vec2<i32>(vec2<u32>(bin % box.columns, bin / box.columns));
    // todo: task 9.7e: gather from nine bins
}

@compute @workgroup_size(THREADS)
fn step(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) local: u32,
) {
    let i = invocation(id, groups);
    var tally = Tally(CUTOFF * CUTOFF, 0.0, 0u, 0u);
    if i < box.n {
        let a = acceleration(i, &tally);
        advance(i, a);
    }
    if STATISTICS {
        add_up(tally, local, i / THREADS);
    }
}

// Adds up the statistics of a workgroup, by halves, and writes it to tallies[block].
fn add_up(tally: Tally, local: u32, block: u32) {
    seen[local] = tally;
    var count = THREADS;
    while count > 1u {
        workgroupBarrier();
        let half = (count + 1u) / 2u;
        if local + half < count {
            let other = seen[local + half];
            seen[local].nearest = min(seen[local].nearest, other.nearest);
            seen[local].sum += other.sum;
            seen[local].pairs += other.pairs;
            seen[local].tests += other.tests;
        }
        count = half;
    }
    if local == 0u && block < arrayLength(&tallies) {
        tallies[block] = seen[0];
    }
}
