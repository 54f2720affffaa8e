// Task 9.4: the balanced version.
//
// In the basic version, disc 0 has n − 1 partners and the last disc has no partners. The hardware
// runs neighbouring invocations in step. So most of them wait for the invocation with the most
// partners. Here walls and pairs have separate kernels. The n (n − 1) / 2 pairs are numbered, and
// the numbers are dealt like cards: invocation t of T takes the pairs t, t + T, t + 2T, …
//
// The report stores two arrays to find a pair by its number. No array is necessary, because the
// triangle of all pairs a < b folds into a rectangle.
//
//         n = 6: 5 rows of 3                n = 5: 5 rows of 2
//
//         01  45  35                        34  24
//         02  12  34                        01  23
//         03  13  23                        02  12
//         04  14  24                        03  13
//         05  15  25                        04  14
//
// The number of a pair is row * width + column. With 100,000 discs, a number has 33 bits, but an
// integer in WGSL has 32. The number itself is not needed: row and column are its two digits.

// The width of the rectangle, and its number of rows.
fn width() -> u32 {
    return square.n / 2u;
}

fn rows() -> u32 {
    return square.n - 1u + square.n % 2u;
}

// Returns the pair a < b at a row and a column of the rectangle, as in the pictures above.
//
// Let even be 1 if n is even, and 0 otherwise.
//
// - Below the diagonal (column < row + even), the pair is (column, row + even).
// - Above the diagonal, the pair is (n − 2 + even − column, n − 1 − row).
fn pair_at(row: u32, column: u32) -> vec2<u32> {
    // todo: task 9.4: a pair from its number
}

// Appends the pairs that may meet in the rows square.first <= row < square.last.
//
// The rectangle may have fewer rows. `me` is the number of this invocation, and `all` is the number
// of invocations.
//
// Advance from pair to pair as if you counted with two digits. The next pair of this invocation is
// all / width() rows and all % width() columns further. If the column becomes too large, carry over
// to the row.
fn find_of_pairs(me: u32, all: u32) {
    // todo: task 9.4b: deal the pairs
}

@compute @workgroup_size(THREADS)
fn find_walls(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let all = invocations(groups);
    for (var i = square.first + invocation(id, groups); i < square.last; i += all) {
        if may_hit_wall(i) {
            append(i, WALL);
        }
    }
}

@compute @workgroup_size(THREADS)
fn find_pairs(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    find_of_pairs(invocation(id, groups), invocations(groups));
}
