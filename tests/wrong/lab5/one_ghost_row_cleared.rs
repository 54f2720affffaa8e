// region: 5.7
// fails: task_5_7_old_ghosts_go_and_new_ones_come, task_5_8_the_bits_of_all_pairs_in_a_dense_box
// loses: 5.8
// story: Only the row of ghosts before the block is cleared, not the one after it.
if let Some(row) = block.start.checked_sub(1) {
    bins.bins_mut()[row * columns..(row + 1) * columns].iter_mut().for_each(Vec::clear);
}
for wire in arrived {
    bins.put(wire.into());
}
