// region: 9.4
// fails: task_9_4_every_pair_has_a_number
// story: The triangle is folded as if the number of discs were even: an odd number loses pairs and doubles others.
    if column < row + 1u {
        return vec2<u32>(column, row + 1u);
    }
    return vec2<u32>(square.n - 1u - column, square.n - 1u - row);
