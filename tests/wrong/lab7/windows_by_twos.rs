// region: 7.14
// fails: task_7_14_no_other_number_of_windows_costs_less
// story: Windows grow by two, not to twice as many, so that their number is no power of two.
let cost = |windows: usize| {
    let work = expected_work(survey, square, windows);
    ENTRY * work.entries + crowding * (work.pairs + ASK * work.asked)
};
let mut best = 1;
while best + 2 <= MOST_WINDOWS && cost(best + 2) < cost(best) {
    best += 2;
}
best
