// region: 7.14
// fails: task_7_14_no_other_number_of_windows_costs_less
// story: How crowded the discs are is added to the pairs, not multiplied by them, so that it hardly counts: crowds get too few windows. Only time is lost.
let cost = |windows: usize| {
    let work = expected_work(survey, square, windows);
    ENTRY * work.entries + crowding + work.pairs + ASK * work.asked
};
let counts = (0..).map(|k| 1 << k).take_while(|&count| count <= MOST_WINDOWS);
counts.min_by(|&a, &b| cost(a).total_cmp(&cost(b))).unwrap_or(1)
