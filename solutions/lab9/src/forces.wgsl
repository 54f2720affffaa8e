// Task 9.7e: the forces, gathered.
//
// Each invocation sums the forces on one particle, and moves it. Many invocations read the same
// particles, but each of them writes only its own. So there are no locks and no atomics, and the
// order of summation is the same in every run. The price is the same as in lab 2: each pair is
// computed twice.

override STATISTICS: bool = false;

// The statistics of one workgroup's particles. The host adds up the workgroups.
struct Tally {
    // The least r² of a pair.
    nearest: real,
    // The sum of the distances of the pairs.
    sum: real,
    // The number of pairs.
    pairs: u32,
    // The number of pairs tested.
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

// Adds the pair at `d` to the statistics, if it is within the cutoff and not a particle with
// itself.
fn look(tally: ptr<function, Tally>, d: vec2<real>) {
    (*tally).tests++;
    let r2 = dot(d, d);
    if r2 > 0.0 && r2 <= CUTOFF * CUTOFF {
        (*tally).nearest = min((*tally).nearest, r2);
        (*tally).sum += sqrt(r2);
        (*tally).pairs++;
    }
}

// Returns the acceleration of sorted particle i.
//
// - Add up pair_acceleration(d) over all particles j of i's bin and of the eight bins around it, as
//   far as they exist. j = i may be included, because it adds zero.
// - d is separation(i, j, over), where `over` =
//   (bin column of j − bin column of i, bin row of j − bin row of i). Both numbers are −1, 0 or 1.
// - Take the bins, and the particles of a bin, in an order that is always the same. For example,
//   take the bins row by row. The particles of a bin begin at starts[bin], and end before
//   starts[bin + 1].
// - If STATISTICS is set, also call look(tally, d) for each j.
fn acceleration(i: u32, tally: ptr<function, Tally>) -> vec2<real> {
    var a = vec2<real>();
    let bin = sorted_tags[i].x;
    let here = vec2<i32>(vec2<u32>(bin % box.columns, bin / box.columns));
    // task 9.7e: gather from nine bins
    for (var row = -1; row <= 1; row++) {
        for (var column = -1; column <= 1; column++) {
            let over = vec2<i32>(column, row);
            let there = here + over;
            if any(there < vec2<i32>()) || any(there >= vec2<i32>(i32(box.columns))) {
                continue;
            }
            let neighbours = u32(there.y) * box.columns + u32(there.x);
            for (var j = starts[neighbours]; j < starts[neighbours + 1u]; j++) {
                let d = separation(i, j, over);
                a += pair_acceleration(d);
                if STATISTICS {
                    look(tally, d);
                }
            }
        }
    }
    return a;
    // end 9.7e
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

// Adds up the statistics of a workgroup, by halves, and writes them to tallies[block].
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
