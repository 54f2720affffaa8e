// region: 9.3
// fails: task_9_3_basic_has_the_candidates_of_all_pairs, task_9_3_the_list_grows_and_starts_again
// story: An invocation takes one disc and stops: a launch of fewer invocations than discs leaves the rest out.
    let i = square.first + me;
    if i < square.last {
        if may_hit_wall(i) {
            append(i, WALL);
        }
        for (var j = i + 1u; j < square.n; j++) {
            if may_meet(i, j) {
                append(i, j);
            }
        }
    }
