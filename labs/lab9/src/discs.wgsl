// Data that the kernels of a step share: the box and the particles.
//
// `real` is f32 or f64, as the host chose when it built the kernels; CUTOFF, MIN_R, MASS and DT
// are the constants of chapter 1.
//
// Each property has an array of its own, a structure of arrays, so that neighbouring invocations read
// neighbouring numbers: coalesced access. A graphics processor fetches memory for 32 or 64 at once.

struct Box {
    // Number of particles.
    n: u32,
    // Bins along x, and as many along y. The bin in column cx and row cy is cy * columns + cx.
    columns: u32,
    // Side of the box.
    size: real,
    // Side of a bin, size / columns, at least the cutoff.
    side: real,
}

@group(0) @binding(0) var<uniform> box: Box;

// Where each bin begins among the sorted particles; starts[bin + 1] is where it ends.
@group(0) @binding(1) var<storage, read> starts: array<u32>;

// The particles, in the order of the step before. A tag is (bin, id).
@group(0) @binding(2) var<storage, read_write> tags: array<vec2<u32>>;
@group(0) @binding(3) var<storage, read_write> positions: array<vec2<real>>;
@group(0) @binding(4) var<storage, read_write> velocities: array<vec2<real>>;

// The same, sorted by bin and within a bin by id.
@group(0) @binding(5) var<storage, read_write> sorted_tags: array<vec2<u32>>;
@group(0) @binding(6) var<storage, read_write> sorted_positions: array<vec2<real>>;
@group(0) @binding(7) var<storage, read_write> sorted_velocities: array<vec2<real>>;
