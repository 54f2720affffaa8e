// region: 12.3
// fails: task_12_3_the_moment_at_which_something_falls_through_zero
// story: The chord is computed by a product of values, which overflows or vanishes.
let close = 1e-12 * (high - low);
let (mut low, mut high) = (low, high);
let (mut above, mut below) = (value(low), value(high));
let mut stayed = 0;
for _ in 0..100 {
    if high - low <= close || below == 0.0 {
        break;
    }
    // Where the chord falls through, kept a little away from both ends so that both close in;
    // the middle if the numbers are too large to say.
    let share = above * above / (above * above - above * below);
    let share = if share.is_nan() { 0.0 } else { share };
    let guess = (low + (high - low) * share).clamp(low + 0.4 * close, high - 0.4 * close);
    let found = value(guess);
    if found > 0.0 {
        (low, above) = (guess, found);
        // Illinois: an end that stays twice counts half, so that the chord comes over to it.
        below *= if stayed == 1 { 0.5 } else { 1.0 };
        stayed = 1;
    } else {
        (high, below) = (guess, found);
        above *= if stayed == -1 { 0.5 } else { 1.0 };
        stayed = -1;
    }
}
high
