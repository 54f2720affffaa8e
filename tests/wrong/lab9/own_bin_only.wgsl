// region: 9.7e
// fails: task_9_7_steps_in_double_precision
// loses: 9.8
// story: Only the own bin is searched: pairs across an edge do not feel each other.
    for (var j = starts[bin]; j < starts[bin + 1u]; j++) {
        let d = separation(i, j, vec2<i32>());
        a += pair_acceleration(d);
        if STATISTICS {
            look(tally, d);
        }
    }
    return a;
