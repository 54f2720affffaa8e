// region: 7.12c
// fails: task_7_12_every_pair_of_the_grid_once
// story: The index in a block is kept in 16 bits.
for coarser in blocks_around(block) {
    look(&blocks[coarser]);
}
look(&blocks[block][usize::from(index as u16) + 1..]);
