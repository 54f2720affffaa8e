// region: 9.3
// fails: task_9_3_basic_has_the_candidates_of_all_pairs, task_9_3_basic_has_the_bytes_of_the_sequential_program
// story: The walls are forgotten: discs leave the square, or stop at its edge.
    for (var i = square.first + me; i < square.last; i += all) {
        for (var j = i + 1u; j < square.n; j++) {
            if may_meet(i, j) {
                append(i, j);
            }
        }
    }
