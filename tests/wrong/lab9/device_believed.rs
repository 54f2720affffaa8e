// region: 9.3d
// fails: task_9_3_basic_has_the_candidates_of_all_pairs
// story: Whatever the device passes on is taken for a candidate: pairs that nearly touch collide at the step's start.
        candidates.clear();
        candidates.extend(found.iter().filter_map(|&[a, b]| match b {
            WALL => wall_hit(a, &discs[a as usize], square),
            b => pair_hit(discs, a, b, square.radius)
                .or(Some(solution7::Candidate { time: 0.0, hit: solution7::Hit::Pair(a, b) })),
        }));
