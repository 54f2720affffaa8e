// region: 7.16
// fails: task_7_16_no_half_or_double_number_of_windows_costs_less
// story: Windows grow by two, not to twice as many, so that their number is no power of two and grows too slowly.
let cost = |windows: usize| {
    let (entries, pairs) = expected_work(survey, square, windows);
    ENTRY * entries + crowding * pairs
};
let mut best = 1;
while 2 * best <= MOST_WINDOWS && cost(2 * best) < cost(best) {
    best += 2;
}
best
