// region: 1.2
// fails: task_1_2_bounces_once, task_1_3_steps_of_a_dense_box
// loses: 1.3
// story: A particle beyond a wall is put on the wall, where it loses the way it had still to go.
if x < 0.0 || x > size { (x.clamp(0.0, size), -v) } else { (x, v) }
