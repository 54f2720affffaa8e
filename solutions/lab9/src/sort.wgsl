// Task 9.7: the counting sort, in three kernels around the prefix sum.
//
// Lab 2 visited the particles one after the other, and put each of them into its bin. Here all
// particles arrive at the same time, in any order that the device chooses. The result must not
// depend on this order, because sums of forces depend on the order of particles. A program with two
// different answers cannot be debugged.

// The number of particles in each bin. After the prefix sum, the same memory is `starts`.
@group(0) @binding(1) var<storage, read_write> counts: array<atomic<u32>>;

// The arrival number of each particle in its bin: 0 for the first particle.
@group(0) @binding(8) var<storage, read_write> arrivals: array<u32>;

// The indices of the particles, bin by bin. The particles of a bin are in the order of arrival.
@group(0) @binding(9) var<storage, read_write> slots: array<u32>;

// Counts each particle i < box.n in its bin, tags[i].x.
//
// Set arrivals[i] to the number of particles that were counted in this bin before particle i.
// `counts` is zero at the start. Two invocations may reach the same bin at the same time. atomicAdd
// is indivisible, and returns the value before the addition.
@compute @workgroup_size(THREADS)
fn count(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let i = invocation(id, groups);
    // task 9.7: count the particles of each bin
    if i < box.n {
        arrivals[i] = atomicAdd(&counts[tags[i].x], 1u);
    }
    // end 9.7
}

// Puts the index of each particle into the slots of its bin, in the order of arrival.
@compute @workgroup_size(THREADS)
fn scatter(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let i = invocation(id, groups);
    // task 9.7b: a slot for each particle
    if i < box.n {
        slots[starts[tags[i].x] + arrivals[i]] = i;
    }
    // end 9.7b
}

// Copies each particle (tag, position, velocity) to its place in the sorted arrays.
//
// The particles of a bin must be in ascending order of their ids, tags[…].y, whatever the order of
// arrival was. A particle's place within its bin is the number of the bin's slots that contain a
// particle with a smaller id.
@compute @workgroup_size(THREADS)
fn order(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let i = invocation(id, groups);
    // task 9.7c: the same order every time
    if i < box.n {
        let tag = tags[i];
        let first = starts[tag.x];
        var to = first;
        for (var slot = first; slot < starts[tag.x + 1u]; slot++) {
            if tags[slots[slot]].y < tag.y {
                to++;
            }
        }
        sorted_tags[to] = tag;
        sorted_positions[to] = positions[i];
        sorted_velocities[to] = velocities[i];
    }
    // end 9.7c
}
