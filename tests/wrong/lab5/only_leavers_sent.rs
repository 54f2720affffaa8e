// region: 5.3
// fails: task_5_3_every_particle_of_a_border_row_is_copied_once, task_5_8_the_bits_of_all_pairs_in_a_dense_box
// loses: 5.8
// story: As in the course report, only particles that change ranks are sent; a particle that stays in its border row is never copied, and the neighbour does not see it.
let _ = (bins, cut, block, columns);
