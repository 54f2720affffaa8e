// Task 9.4: the balanced version.
//
// In the basic version disc 0 has n − 1 partners and the last disc none: while one invocation
// works, its neighbours, which the hardware runs in step with it, are long done. Here walls and
// pairs are apart, the n (n − 1) / 2 pairs are numbered, and the numbers are dealt like cards:
// invocation t of T takes the pairs t, t + T, t + 2T, …
//
// The report keeps two arrays to look a pair up by its number. Nothing needs to be stored: the
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
// A pair's number is row * width + column. With 100,000 discs numbers need 33 bits, and WGSL has
// 32. But the number itself is not needed: a row and a column are a number with two digits.

// The rectangle's width and its number of rows.
fn width() -> u32 {
    return square.n / 2u;
}

fn rows() -> u32 {
    return square.n - 1u + square.n % 2u;
}

// The pair a < b at a row and a column of the rectangle, as in the pictures above. With even = 1
// if n is even, else 0:
// - left and below, column < row + even: the pair (column, row + even);
// - else: the pair (n − 2 + even − column, n − 1 − row).
fn pair_at(row: u32, column: u32) -> vec2<u32> {
    // todo: task 9.4: a pair from its number
}

// Appends the pairs that may meet in the rows square.first <= row < square.last, as far as the
// rectangle has such rows. `me` is the number of this invocation, `all` how many there are.
//
// Go from pair to pair as one counts with two digits: `all` further is all / width() rows and
// all % width() columns, and if the column is too large, it carries.
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
