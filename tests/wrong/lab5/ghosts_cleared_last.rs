// region: 5.7
// fails: task_5_7_old_ghosts_go_and_new_ones_come, task_5_8_the_bits_of_all_pairs_in_a_dense_box
// loses: 5.8
// story: The ghost rows are cleared after the new ghosts have come, so that there are none at all.
for wire in arrived {
    bins.put(wire.into());
}
let after = (block.end < bins.grid().rows()).then_some(block.end);
for row in block.start.checked_sub(1).into_iter().chain(after) {
    bins.bins_mut()[row * columns..(row + 1) * columns].iter_mut().for_each(Vec::clear);
}
