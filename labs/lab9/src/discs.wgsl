// The data that the kernels of a step share: the box and the particles.
//
// The host chooses f32 or f64 for `real` when it builds the kernels. CUTOFF, MIN_R, MASS and DT are
// the constants of chapter 1.
//
// Each property has its own array (a structure of arrays), so that neighbouring invocations read
// neighbouring numbers. This is coalesced access: a graphics processor fetches memory for 32 or 64
// invocations at once.

struct Box {
    // The number of particles.
    n: u32,
    // The number of bins along x, and along y. The bin in column cx and row cy is
    // cy * columns + cx.
    columns: u32,
    // The side of the box.
    size: real,
    // The side of a bin, size / columns, at least the cutoff.
    side: real,
}

@group(0) @binding(0) var<uniform> box: Box;

// The index at which each bin begins in the sorted arrays. The bin ends before starts[bin + 1].
@group(0) @binding(1) var<storage, read> starts: array<u32>;

// The particles, in the order of the previous step. A tag is (bin, id).
@group(0) @binding(2) var<storage, read_write> tags: array<vec2<u32>>;
@group(0) @binding(3) var<storage, read_write> positions: array<vec2<real>>;
@group(0) @binding(4) var<storage, read_write> velocities: array<vec2<real>>;

// The particles, sorted by bin, and within a bin by id.
@group(0) @binding(5) var<storage, read_write> sorted_tags: array<vec2<u32>>;
@group(0) @binding(6) var<storage, read_write> sorted_positions: array<vec2<real>>;
@group(0) @binding(7) var<storage, read_write> sorted_velocities: array<vec2<real>>;
