// region: 7.12c
// fails: task_7_12_the_grid_finds_every_pair, task_7_12_every_pair_of_the_grid_once
// story: A disc looks at all other discs of its block: every pair there comes up twice.
for coarser in blocks_around(block) {
    look(&blocks[coarser]);
}
look(&blocks[block][..index]);
look(&blocks[block][index + 1..]);
