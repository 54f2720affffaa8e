// region: 12.3
// fails: task_12_3_the_moment_at_which_something_falls_through_zero
// story: The chord multiplies before it divides. Where all values are nearly zero the product is 0, the guess stays at the low end, and the search has no end.
let close = 1e-12 * (high - low);
let (mut low, mut high) = (low, high);
let (mut above, mut below) = (value(low), value(high));
let mut stayed = 0;
while high - low > close && below != 0.0 {
    let share = above / (above - below);
    let step = if share.is_finite() { (high - low) * above / (above - below) } else { 0.5 * (high - low) };
    let guess = (low + step).clamp(low + 0.4 * close, high - 0.4 * close);
    let found = value(guess);
    if found > 0.0 {
        (low, above) = (guess, found);
        below *= if stayed == 1 { 0.5 } else { 1.0 };
        stayed = 1;
    } else {
        (high, below) = (guess, found);
        above *= if stayed == -1 { 0.5 } else { 1.0 };
        stayed = -1;
    }
}
high
