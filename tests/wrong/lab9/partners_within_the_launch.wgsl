// region: 9.3
// fails: task_9_3_the_list_grows_and_starts_again
// story: The partners of a disc end where the discs of the launch end, and not with the last disc: rows that are done in two launches lose the pairs between.
    for (var i = square.first + me; i < square.last; i += all) {
        if may_hit_wall(i) {
            append(i, WALL);
        }
        for (var j = i + 1u; j < square.last; j++) {
            if may_meet(i, j) {
                append(i, j);
            }
        }
    }
