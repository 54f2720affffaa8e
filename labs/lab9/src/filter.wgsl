// Task 9.2: which discs may collide.
//
// The device does the n² part and nothing else: it looks at all pairs and passes on the few that
// may collide. The host's one candidate function says whether and when they do. So every
// program gives the same bytes, though devices round, contract a * b + c, and flush small numbers
// as they like. The device may pass on a pair that does not collide. It must never lose one.
//
// Lengths are in units of the square's side, so that nothing is too large or too small for f32.

struct Square {
    // Number of discs.
    n: u32,
    // The rows of work for this launch: first <= row < last.
    first: u32,
    last: u32,
    // Not 0: velocities are so large that nothing can be ruled out.
    everything: u32,
    // The square of the distance below which two discs may touch: that of two radii and a margin
    // for all rounding errors of this file.
    reach_squared: real,
    // No rounding error makes a pair with d · D > receding out of one that approaches.
    receding: real,
    // A centre that ends between these two, margin included, hits no wall.
    least: real,
    most: real,
}

// The second number of a candidate that is a disc and a wall.
const WALL: u32 = 0xffffffffu;

@group(0) @binding(0) var<uniform> square: Square;

// (x, y, vx, vy) of each disc.
@group(0) @binding(1) var<storage, read> discs: array<vec4<real>>;

// How many candidates there are, and as many of them as there is room for.
@group(0) @binding(2) var<storage, read_write> count: atomic<u32>;
@group(0) @binding(3) var<storage, read_write> candidates: array<vec2<u32>>;

// Whether discs a and b may collide in this step.
//
// With d the vector from a to b and D the velocity of b less that of a:
// - square.everything is not 0: yes.
// - d · D > square.receding: no, they move apart.
// - Else they are nearest at the time t = −(d · D) / (D · D), or at 0 or 1 if t lies outside the
//   step; take 0 if D · D is 0. They may collide if |d + t D|² is at most square.reach_squared.
//
// No root and no λ: fewer operations, and an error in t only makes the distance larger by its
// square, since at the nearest point the distance stands still. That is what lets the margin be
// small.
fn may_meet(a: u32, b: u32) -> bool {
    // todo: task 9.2: discs that may meet
}

// Whether disc a may hit a wall in this step.
fn may_hit_wall(a: u32) -> bool {
    let end = discs[a].xy + discs[a].zw;
    let beyond = any(end < vec2<real>(square.least)) || any(end > vec2<real>(square.most));
    return beyond || square.everything != 0u;
}

// Passes a candidate on: the discs a < b, or the disc a and WALL.
//
// Thousands of invocations append to one list. atomicAdd gives each of them an index of its own;
// none waits. The list has room for arrayLength(&candidates). Beyond that nothing is written, but
// all are counted, so that the host knows how much room is needed.
fn append(a: u32, b: u32) {
    // todo: task 9.2b: an index of one's own
}
