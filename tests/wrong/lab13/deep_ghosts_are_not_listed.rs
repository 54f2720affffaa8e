// region: 13.7b
// fails: task_13_7_no_other_epoch_is_cheaper
// story: Ghosts cost something in each step and nothing when lists are made: epochs of fast particles become too deep.
let Outlook { fastest, height, particles, most } = outlook;
let cost = |steps: u32| {
    let all = 1.0 + 2.0 * deep_width(fastest, steps) / height;
    all * STEP + (crate::RENEWAL + WAIT / particles) / f64::from(steps)
};
let mut best = 1;
for steps in 2..=most {
    if cost(steps) < cost(best) {
        best = steps;
    }
}
best
