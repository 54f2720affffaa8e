// Task 9.8: positions in single precision, relative to the bin.
//
// A single-precision number has 24 bits. In a box of ten million particles, 7,000 cutoffs wide, a
// coordinate measured from the corner has an error of up to 1/2,500 of a cutoff. Here a position is
// an offset from the lower left corner of the particle's bin, in units of the bin's side: 0 to 1.
// It is equally exact in every box, because the bin's column and row are integers.

// Returns the vector from sorted particle i to sorted particle j, a length.
//
// The bin of j is `over` = (columns, rows) away from the bin of i. Offsets are in units of
// box.side. The vector is a length, like box.side.
fn separation(i: u32, j: u32, over: vec2<i32>) -> vec2<real> {
    // todo: task 9.8: a vector between two bins
}

// A bin's column (or row), the offset from it, and the velocity along x (or y).
struct Along {
    column: i32,
    offset: real,
    v: real,
}

// Returns the position of a particle that moves by `distance`, as if there were no walls.
//
// `distance` is in units of the bin's side. The result has an offset 0 ≤ … < 1, from a column that
// may be outside the box. The offset plus the distance can be any number. Carry its floor over to
// the column.
//
// Mind the rounding: −1e-9 has floor −1, and −1e-9 + 1 is rounded to 1, which is not less than 1.
fn carry(from_: Along, distance: real) -> Along {
    // todo: task 9.8b: carry the whole bins
}

// Returns the mirror image of a position in the left edge of column 0: −(column + offset).
fn mirrored(at: Along) -> Along {
    var image = Along(-at.column - 1, 1.0 - at.offset, -at.v);
    if image.offset >= 1.0 {
        image.offset = 0.0;
        image.column++;
    }
    return image;
}

// Moves a particle along one direction, with the bounces.
fn travel(from_: Along) -> Along {
    let columns = i32(box.columns);
    // Moving twice the size of the box, there and back, changes nothing.
    let period = 2.0 * real(columns);
    var distance = from_.v * DT / box.side;
    if abs(distance) > period {
        distance = clamp(distance - floor(distance / period) * period, 0.0, period);
    }
    var at = carry(from_, distance);
    while true {
        if at.column < 0 {
            at = mirrored(at);
        } else if at.column > columns || (at.column == columns && at.offset > 0.0) {
            at = mirrored(at);
            at.column += 2 * columns;
        } else {
            break;
        }
    }
    // A particle on the far wall is inside: it is at the far edge of the last bin.
    if at.column == columns {
        at.column = columns - 1;
        at.offset = 1.0;
    }
    return at;
}

// Moves sorted particle i for one time step. Writes it to the unsorted arrays, with its new bin.
fn advance(i: u32, a: vec2<real>) {
    let tag = sorted_tags[i];
    let v = sorted_velocities[i] + a * DT;
    let x = travel(Along(i32(tag.x % box.columns), sorted_positions[i].x, v.x));
    let y = travel(Along(i32(tag.x / box.columns), sorted_positions[i].y, v.y));
    positions[i] = vec2<real>(x.offset, y.offset);
    velocities[i] = vec2<real>(x.v, y.v);
    tags[i] = vec2<u32>(u32(y.column) * box.columns + u32(x.column), tag.y);
}
