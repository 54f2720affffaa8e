// region: 12.3
// fails: task_12_3_the_moment_at_which_something_falls_through_zero
// story: Halves until the moment is known, and never looks at how far it still is: three times as many Runge-Kutta steps.
let close = 1e-12 * (high - low);
let (mut low, mut high) = (low, high);
while high - low > close {
    let middle = 0.5 * (low + high);
    if value(middle) > 0.0 { low = middle } else { high = middle }
}
high
