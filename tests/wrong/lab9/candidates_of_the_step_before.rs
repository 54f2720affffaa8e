// region: 9.3d
// fails: task_9_3_the_host_has_the_last_word
// story: The list is not cleared: candidates of the step before stay and are decided again.
candidates.extend(found.iter().filter_map(|&[a, b]| match b {
    WALL => wall_hit(a, &discs[a as usize], square),
    b => pair_hit(discs, a, b, square.radius),
}));
