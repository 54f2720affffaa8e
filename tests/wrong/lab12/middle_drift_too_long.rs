// region: 12.1c
// fails: task_12_1_pefrl_is_symmetric_and_whole, task_12_1_orders_of_convergence
// story: The middle drift leaves room for one drift on either side of it, not for two: time runs on.
let outer = (1.0 - 2.0 * LAMBDA) / 2.0;
Self {
    drifts: vec![XI, CHI, 1.0 - 2.0 * XI, CHI, XI],
    kicks: vec![outer, LAMBDA, LAMBDA, outer],
}
