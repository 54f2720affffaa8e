// region: 12.1c
// fails: task_12_1_pefrl_is_symmetric_and_whole, task_12_1_orders_of_convergence
// story: The two kinds of kicks take turns. They add up to 1, but backwards they are others: the order is lost.
let outer = (1.0 - 2.0 * LAMBDA) / 2.0;
Self {
    drifts: vec![XI, CHI, 1.0 - 2.0 * (CHI + XI), CHI, XI],
    kicks: vec![outer, LAMBDA, outer, LAMBDA],
}
