// region: 12.2
// fails: task_12_2_four_looks_at_a_ring, task_12_2_order_of_convergence
// story: All four slopes weigh the same: the slopes of half-way are the better ones, and count too little.
let n = start.at.len();
let mut sum = State { at: vec![Vec2::ZERO; n], v: vec![Vec2::ZERO; n] };
let mut stage = start.clone();
let mut a = vec![Vec2::ZERO; n];
for (weight, next) in [(1.5, 0.5), (1.5, 0.5), (1.5, 1.0), (1.5, 0.0)] {
    accelerations(&stage.at, &mut a);
    for i in 0..n {
        let v = stage.v[i];
        sum.at[i] += weight * v;
        sum.v[i] += weight * a[i];
        stage.at[i] = start.at[i] + (next * h) * v;
        stage.v[i] = start.v[i] + (next * h) * a[i];
    }
}
sum
