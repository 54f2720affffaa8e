// Positions in double precision: (x, y) from the corner of the box.

const FEW: u32 = 8u;

// Returns the vector from sorted particle i to sorted particle j. `over`, the number of bins
// between them, is needed only for positions that are relative to their bin.
fn separation(i: u32, j: u32, over: vec2<i32>) -> vec2<real> {
    return sorted_positions[j] - sorted_positions[i];
}

// Reflects a coordinate that may be outside the walls, and its velocity: lab 1's `bounce`.
fn bounce(x_: real, v_: real) -> vec2<real> {
    var x = x_;
    var v = v_;
    for (var k = 0u; k < FEW; k++) {
        if x < 0.0 {
            x = -x;
            v = -v;
        } else if x > box.size {
            x = 2.0 * box.size - x;
            v = -v;
        } else {
            return vec2<real>(x, v);
        }
    }
    let period = 2.0 * box.size;
    let folded = clamp(x - floor(x / period) * period, 0.0, period);
    if folded <= box.size {
        return vec2<real>(folded, v);
    }
    return vec2<real>(period - folded, -v);
}

// Moves sorted particle i by one time step and writes it to the unsorted arrays, with its new bin.
fn advance(i: u32, a: vec2<real>) {
    let v = sorted_velocities[i] + a * DT;
    let position = sorted_positions[i] + v * DT;
    let x = bounce(position.x, v.x);
    let y = bounce(position.y, v.y);
    positions[i] = vec2<real>(x.x, y.x);
    velocities[i] = vec2<real>(x.y, y.y);
    let last = vec2<u32>(box.columns - 1u);
    let bin = min(vec2<u32>(positions[i] / box.side), last);
    tags[i] = vec2<u32>(bin.y * box.columns + bin.x, sorted_tags[i].y);
}
