// region: 3.10
// fails: task_3_10_three_barriers_in_a_step
// story: The number of steps in sixteen bits: a long run is over after a few.
for _ in 0..steps as u16 {
    part(Part::Forces);
    barrier.wait();
    part(Part::Moves);
    barrier.wait();
    part(Part::Arrivals);
    barrier.wait();
}
