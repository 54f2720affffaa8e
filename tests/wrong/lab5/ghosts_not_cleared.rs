// region: 5.7
// fails: task_5_7_old_ghosts_go_and_new_ones_come, task_5_8_the_bits_of_all_pairs_in_a_dense_box
// loses: 5.8
// story: Ghosts of earlier steps stay where they are, as in the course report: they pile up, and repel from positions where no particle is any more.
let _ = (columns, block);
for wire in arrived {
    bins.put(wire.into());
}
