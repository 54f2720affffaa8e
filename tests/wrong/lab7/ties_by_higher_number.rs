// region: 7.3
// fails: task_7_3_the_order_of_candidates, task_7_7_one_step_of_a_hundred_lattices
// loses: 7.4
// story: Of several collisions at the same time the one of the higher number is taken. It shows only where times are exactly equal, as on lattices of whole numbers.
let by_time = a.time.partial_cmp(&b.time).expect("no time is NaN");
by_time.then(b.hit.cmp(&a.hit))
