// region: 7.12b
// fails: task_7_12_blocks_of_boxes, task_7_12_the_grid_finds_every_pair, task_7_14_every_variant_gives_the_same_bits
// story: Small blocks are compared with the medium block around them, but not with the whole square.
match block {
    0..16 => vec![16 + 2 * (block / 8) + block % 4 / 2],
    16..20 => vec![20],
    _ => Vec::new(),
}
