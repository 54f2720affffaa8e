// region: 7.12c
// fails: task_7_12_the_grid_finds_every_pair, task_7_12_every_pair_of_the_grid_once
// story: In coarser blocks too only discs after the own index are looked at: no call looks the other way.
for coarser in blocks_around(block) {
    look(blocks[coarser].get(index + 1..).unwrap_or_default());
}
look(&blocks[block][index + 1..]);
