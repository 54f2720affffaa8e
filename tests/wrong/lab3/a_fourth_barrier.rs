// region: 3.10
// fails: task_3_10_three_barriers_in_a_step
// story: One more barrier before each step, to be on the safe side: all wait for all once more than they need.
for _ in 0..steps {
    barrier.wait();
    part(Part::Forces);
    barrier.wait();
    part(Part::Moves);
    barrier.wait();
    part(Part::Arrivals);
    barrier.wait();
}
