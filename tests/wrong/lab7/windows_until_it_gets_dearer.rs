// region: 7.14
// fails: task_7_14_no_other_number_of_windows_costs_less
// story: Stops at the first number of windows that is no cheaper.
let cost = |windows: usize| {
    let work = expected_work(survey, square, windows);
    ENTRY * work.entries + crowding * (work.pairs + ASK * work.asked)
};
let mut best = 1;
while best < MOST_WINDOWS && cost(2 * best) < cost(best) {
    best *= 2;
}
best
