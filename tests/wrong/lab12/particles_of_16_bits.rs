// region: 12.2
// fails: task_12_2_four_looks_at_a_ring
// story: Particles are numbered in 16 bits: those behind the first 65,536 have no slope, and stay.
let n = start.at.len();
let mut sum = State { at: vec![Vec2::ZERO; n], v: vec![Vec2::ZERO; n] };
let mut stage = start.clone();
let mut a = vec![Vec2::ZERO; n];
for (weight, next) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)] {
    accelerations(&stage.at, &mut a);
    for i in (0..=u16::MAX).map(usize::from).take_while(|i| *i < n) {
        sum.at[i] += weight * stage.v[i];
        sum.v[i] += weight * a[i];
        stage.at[i] = start.at[i] + (next * h) * stage.v[i];
        stage.v[i] = start.v[i] + (next * h) * a[i];
    }
}
sum
