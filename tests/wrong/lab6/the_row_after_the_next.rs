// region: 6.2
// fails: task_6_2_neighbours_have_the_rows_next_door
// story: The block is taken for one that includes its end: a next block of one row is passed over.
if block.is_empty() {
    return [None, None];
}
let before = block.start.checked_sub(1);
let after = (block.end + 1 < rows).then_some(block.end + 1);
[before, after].map(|row| row.map(|row| cuts.owner(row)))
