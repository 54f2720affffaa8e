// region: 12.3
// fails: task_12_3_the_moment_at_which_something_falls_through_zero
// loses: 12.4
// story: The chord's own guess is taken, without a guard at the ends: it lands on the same end again and again, and the other end never comes near.
let close = 1e-12 * (high - low);
let (mut low, mut high) = (low, high);
let (mut above, mut below) = (value(low), value(high));
let mut stayed = 0;
while high - low > close {
    let guess = low + (high - low) * above / (above - below);
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
