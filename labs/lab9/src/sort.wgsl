// Task 9.7: the counting sort, in three kernels around the prefix sum.
//
// Lab 2 sorted particles into bins by going through them in order. Here all of them arrive at
// once, in whatever order the device likes. The result must not depend on it: sums of forces
// depend on their order, and a program that gives two answers cannot be debugged.

// How many particles each bin holds; after the prefix sum the same memory is `starts`.
@group(0) @binding(1) var<storage, read_write> counts: array<atomic<u32>>;

// Which particle of its bin came when: 0 for the first.
@group(0) @binding(8) var<storage, read_write> arrivals: array<u32>;

// The particles' numbers by bin, each bin's in order of arrival.
@group(0) @binding(9) var<storage, read_write> slots: array<u32>;

// Counts each particle i < box.n in its bin, tags[i].x, and notes in arrivals[i] how many were
// there before it. `counts` is zero at the start. Two invocations may meet at one bin: atomicAdd
// adds in one piece and returns what was there before.
@compute @workgroup_size(THREADS)
fn count(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let i = invocation(id, groups);
    // todo: task 9.7: count the particles of each bin
}

// Puts the number of each particle into the slots of its bin, in the order of their arrival.
@compute @workgroup_size(THREADS)
fn scatter(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let i = invocation(id, groups);
    // todo: task 9.7b: a slot for each particle
}

// Copies each particle (tag, position, velocity) to where it stands in the sorted arrays. A bin's
// particles stand in ascending order of their ids, tags[…].y, whatever the order of arrival was:
// a particle's rank is the number of particles in the slots of its bin with a smaller id.
@compute @workgroup_size(THREADS)
fn order(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let i = invocation(id, groups);
    // todo: task 9.7c: the same order every time
}
