// region: 8.1
// fails: task_8_1_few_blocks_make_every_distance
// story: Stops after sixteen offsets.
let mut offsets = vec![0];
let mut missing: Vec<usize> = (1..=workers / 2).collect();
while !missing.is_empty() && offsets.len() < 16 {
    let bridges = |offsets: &[usize], new: usize, d: usize| {
        offsets.iter().any(|&old| distance(old, new, workers) == d)
    };
    let gain = |new: usize| missing.iter().filter(|&&d| bridges(&offsets, new, d)).count();
    let best = (1..workers).rev().max_by_key(|&new| gain(new)).expect("two workers or more");
    missing.retain(|&d| !bridges(&offsets, best, d));
    offsets.push(best);
}
offsets
