// region: 9.3
// fails: task_9_3_invocations_share_the_discs
// story: The first invocation does what all should share, and the others nothing.
    if me > 0u {
        return;
    }
    for (var i = square.first; i < square.last; i++) {
        if may_hit_wall(i) {
            append(i, WALL);
        }
        for (var j = i + 1u; j < square.n; j++) {
            if may_meet(i, j) {
                append(i, j);
            }
        }
    }
