// Task 9.6: the prefix sum of one block.
//
// The prefix sum of [3, 1, 0, 2] is [0, 3, 4, 4]: each number becomes the sum of those before it.
// It turns the numbers of particles in the bins into the starts of the bins.
//
// A workgroup sums a block of THREADS numbers in its own fast memory. It cannot see what other workgroups do, so it
// leaves the sum of its block in `sums`; the host has those summed in turn, and added back (task 9.6b).

@group(0) @binding(0) var<storage, read_write> values: array<u32>;
@group(0) @binding(1) var<storage, read_write> sums: array<u32>;

// Replaces each block of `values` by its prefix sum and writes the sum of the whole block to
// `sums[block]`. `local` is the number of the invocation within its workgroup.
//
// The invocations share THREADS numbers, and three functions are given for them (shared.wgsl in
// labs/engines/device-discs/src/soft): `put(k, number)` writes number k, `fetch(k)` reads it, and `meet()` is the
// barrier.
//
// The algorithm is that of Hillis and Steele: for reach = 1, 2, 4, … each invocation adds to its
// number the one `reach` before it. After the last round fetch(local) is the sum of the
// numbers 0 to local of the block, its own included; the prefix sum leaves its own out.
//
// The invocations of a workgroup do not run in step. meet() holds each of them until all have come so
// far and all their writes can be seen. Each round needs two: one before any invocation reads what its
// neighbours wrote in the round before, and one before any overwrites what its neighbours still have to
// read. Every invocation must come to every meet(), so no meet() may depend on `local`, and the last block, which may
// be partly empty, sums zeros instead of leaving early.
@compute @workgroup_size(THREADS)
fn scan_blocks(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) local: u32,
) {
    let i = invocation(id, groups);
    let block = i / THREADS;
    own = local;
    // todo: task 9.6: the prefix sum of a block
}

// Adds to each number the sum of all blocks before its own, which `sums` holds by now.
@compute @workgroup_size(THREADS)
fn add_sums(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let i = invocation(id, groups);
    if i < arrayLength(&values) {
        values[i] += sums[i / THREADS];
    }
}
