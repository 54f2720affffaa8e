// region: 7.14
// fails: task_7_14_no_other_number_of_windows_costs_less
// story: Pairs that are asked when they touch cost no more than a look: large discs get too few windows. Only time is lost.
let cost = |windows: usize| {
    let work = expected_work(survey, square, windows);
    ENTRY * work.entries + crowding * work.pairs
};
let counts = (0..).map(|k| 1 << k).take_while(|&count| count <= MOST_WINDOWS);
counts.min_by(|&a, &b| cost(a).total_cmp(&cost(b))).unwrap_or(1)
