// region: 12.2
// fails: task_12_2_velocity_verlet_kicks_by_halves, task_12_2_orders_of_convergence
// story: Both kicks are whole ones: every push counts twice.
Self { drifts: vec![0.0, 1.0, 0.0], kicks: vec![1.0, 1.0] }
