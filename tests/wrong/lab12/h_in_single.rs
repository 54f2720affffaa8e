// region: 12.2
// fails: task_12_2_four_looks_at_a_ring
// story: The step in single precision.
let h = f64::from(h as f32);
let n = start.at.len();
let mut sum = State { at: vec![Vec2::ZERO; n], v: vec![Vec2::ZERO; n] };
let mut stage = start.clone();
let mut a = vec![Vec2::ZERO; n];
// How much each slope weighs, and how far along it the next one is looked for.
for (weight, next) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)] {
    accelerations(&stage.at, &mut a);
    // `State::along` is shorter, and a fifth slower: each stage is a new one, in new memory.
    for (i, &a) in a.iter().enumerate() {
        sum.at[i] += weight * stage.v[i];
        sum.v[i] += weight * a;
        stage.at[i] = start.at[i] + (next * h) * stage.v[i];
        stage.v[i] = start.v[i] + (next * h) * a;
    }
}
sum
