// region: 5.3
// fails: task_5_3_every_particle_of_a_border_row_is_copied_once, task_5_8_more_ranks_than_rows
// story: First and last row are copied one after the other, and a block of a single row has its particles copied twice: their ghosts push twice.
if !block.is_empty() {
    for row in [block.start, block.end - 1] {
        if cut.neighbours(row).next().is_some() {
            let bins = &bins.bins()[row * columns..(row + 1) * columns];
            copies.extend(bins.iter().flatten().map(Wire::from));
        }
    }
}
