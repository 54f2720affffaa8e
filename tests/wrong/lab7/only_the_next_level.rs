// region: 7.12c
// fails: task_7_12_the_grid_finds_every_pair, task_7_12_every_pair_of_the_grid_once
// story: Of the blocks around only the first is looked at.
if let Some(coarser) = blocks_around(block).first() {
    look(&blocks[*coarser]);
}
look(&blocks[block][index + 1..]);
