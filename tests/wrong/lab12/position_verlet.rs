// region: 12.1b
// fails: task_12_1_velocity_verlet_kicks_by_halves
// story: The drift is halved and not the kick: position Verlet, of second order too, but another method.
Self { drifts: vec![0.5, 0.5], kicks: vec![1.0] }
