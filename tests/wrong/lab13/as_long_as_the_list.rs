// region: 13.1b
// fails: task_13_1_no_other_number_of_steps_is_cheaper, task_13_1_table_of_widths
// story: Ghosts are always chosen for as long as lists last: where a particle crosses the box in a step, every particle is a ghost of every rank.
let _ = (scenery.fastest, scenery.density, scenery.height);
scenery.most
