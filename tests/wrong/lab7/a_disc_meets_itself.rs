// region: 7.12c
// fails: task_7_12_every_pair_of_the_grid_once
// story: A disc is among its own partners. No result is wrong: it does not approach itself.
for coarser in blocks_around(block) {
    look(&blocks[coarser]);
}
look(&blocks[block][index..]);
