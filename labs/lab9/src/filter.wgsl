// Task 9.2: discs that may collide.
//
// The device does only the n² part: it tests all pairs, and passes on the few that may collide. The
// host's single candidate function decides whether and when they collide. So every program computes
// the same bytes, although devices may round in their own ways, contract a * b + c, and flush small
// numbers to zero. The device may pass on a pair that does not collide. It must never lose a pair
// that does.
//
// Lengths are in units of the square's side, so that nothing is too large or too small for f32.

struct Square {
    // The number of discs.
    n: u32,
    // The rows of work for this launch: first <= row < last.
    first: u32,
    last: u32,
    // Not 0 if velocities are so large that no pair can be ruled out.
    everything: u32,
    // The square of the distance below which two discs may touch: two radii, and a margin for all
    // rounding errors of this file.
    reach_squared: real,
    // The greatest d · D that rounding errors can yield for a pair that approaches.
    receding: real,
    // A disc hits no wall if both coordinates of its centre are between these two numbers after the
    // step. A margin is included.
    least: real,
    most: real,
}

// The second number of a candidate that consists of a disc and a wall.
const WALL: u32 = 0xffffffffu;

@group(0) @binding(0) var<uniform> square: Square;

// (x, y, vx, vy) of each disc.
@group(0) @binding(1) var<storage, read> discs: array<vec4<real>>;

// The number of all candidates, and a list that contains as many of them as there is room for.
@group(0) @binding(2) var<storage, read_write> count: atomic<u32>;
@group(0) @binding(3) var<storage, read_write> candidates: array<vec2<u32>>;

// Whether discs a and b may collide in this step.
//
// Let d be the vector from a to b, and D the velocity of b minus the velocity of a.
//
// - If square.everything is not 0, return true.
// - If d · D > square.receding, return false, because the discs move apart.
// - Otherwise, they are nearest at the time t = −(d · D) / (D · D). Clamp t to the step, 0 to 1. If
//   D · D is 0, take t = 0. They may collide if |d + t D|² is at most square.reach_squared.
//
// This needs neither a root nor λ, so there are fewer operations. An error in t increases the
// distance only by the square of the error, because the distance has its minimum there. So the
// margin can be small.
fn may_meet(a: u32, b: u32) -> bool {
    // todo: task 9.2: discs that may meet
}

// Whether disc a may hit a wall in this step.
fn may_hit_wall(a: u32) -> bool {
    let end = discs[a].xy + discs[a].zw;
    let beyond = any(end < vec2<real>(square.least)) || any(end > vec2<real>(square.most));
    return beyond || square.everything != 0u;
}

// Appends a candidate to the list: the discs a < b, or the disc a and WALL.
//
// Thousands of invocations append to one list at the same time. atomicAdd gives each of them its
// own index, and no invocation waits. The list has room for arrayLength(&candidates). Write nothing
// beyond that, but count all candidates, so that the host knows how much room is needed.
fn append(a: u32, b: u32) {
    // todo: task 9.2b: an index of one's own
}
