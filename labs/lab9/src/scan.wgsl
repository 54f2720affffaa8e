// Task 9.6: the prefix sum of one block.
//
// The prefix sum of [3, 1, 0, 2] is [0, 3, 4, 4]: each number becomes the sum of the numbers before
// it. It turns the numbers of particles in the bins into the starts of the bins.
//
// A workgroup sums a block of THREADS numbers in its own fast memory. It cannot see the work of
// other workgroups, so it writes the sum of its block to `sums`. The host then launches the prefix
// sum of these sums, and a kernel that adds the result to the blocks (task 9.6b).

@group(0) @binding(0) var<storage, read_write> values: array<u32>;
@group(0) @binding(1) var<storage, read_write> sums: array<u32>;

// Replaces each block of `values` by its prefix sum, and writes the sum of the block to
// `sums[block]`.
//
// `local` is the number of the invocation in its workgroup. The invocations share THREADS numbers.
// Three functions are given for them (shared.wgsl in labs/engines/device-discs/src/soft):
//
// - `put(k, number)` writes number k.
// - `fetch(k)` reads number k.
// - `meet()` is the barrier.
//
// The algorithm is that of Hillis and Steele. In the rounds reach = 1, 2, 4, … below THREADS, each
// invocation adds number local − reach, if it exists, to number local. After the last round,
// fetch(local) is the sum of the numbers 0 to local of the block. The prefix sum does not include
// number local itself.
//
// The invocations of a workgroup do not run in step. meet() holds each of them until all have
// called it and all their writes are visible. Each round needs two barriers, and no more: one before
// any invocation reads the numbers that its neighbours wrote in the previous round, and one before
// any invocation overwrites a number that its neighbours have not read yet.
//
// Every invocation must call every meet(). So no meet() may depend on `local`. And the last block,
// which may be partly empty, sums zeros instead of returning early.
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

// Adds the sum of all previous blocks to each number. `sums` already contains these sums.
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
