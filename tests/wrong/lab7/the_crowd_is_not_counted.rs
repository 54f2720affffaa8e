// region: 7.16
// fails: task_7_16_no_half_or_double_number_of_windows_costs_less
// story: How crowded the discs are is added to the pairs, not multiplied by them, so that it hardly counts: crowds get too few windows. Only time is lost.
let cost = |windows: usize| {
    let (entries, pairs) = expected_work(survey, square, windows);
    ENTRY * entries + crowding + pairs
};
let mut best = 1;
while 2 * best <= MOST_WINDOWS && cost(2 * best) < cost(best) {
    best *= 2;
}
best
