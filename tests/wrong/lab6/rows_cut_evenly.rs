// region: 6.1
// fails: task_6_1_blocks_are_cut_where_the_lab_says
// story: Blocks of equally many rows, however many particles lie in them: in a scene that fills a corner one rank has it all.
let starts = (0..=ranks).map(|rank| rank * counts.len() / ranks).collect();
Cuts { starts }
