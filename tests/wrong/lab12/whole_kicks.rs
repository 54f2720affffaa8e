// region: 12.1b
// fails: task_12_1_velocity_verlet_kicks_by_halves, task_12_1_orders_of_convergence
// story: Both kicks are whole ones: every force counts twice.
Self { drifts: vec![0.0, 1.0, 0.0], kicks: vec![1.0, 1.0] }
