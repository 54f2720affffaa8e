// region: 5.3
// fails: task_5_3_every_particle_of_a_border_row_is_copied_once, task_5_8_the_bits_of_all_pairs_in_a_dense_box
// loses: 5.8
// story: Only the first row of the block is copied, so that the next rank computes its forces without those on the other side.
if !block.is_empty() && block.start > 0 {
    let row = block.start;
    let bins = &bins.bins()[row * columns..(row + 1) * columns];
    copies.extend(bins.iter().flatten().map(Wire::from));
}
