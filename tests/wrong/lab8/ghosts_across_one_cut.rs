// region: 8.9
// fails: task_8_9_ghosts_go_where_their_boxes_reach, task_8_13_the_bits_of_one_rank
// loses: 8.13
// story: A ghost goes to one partner at most, the first that needs it. A box across three strips is missing in the third.
for disc in own {
    let reached = reached(strips, disc, reach);
    let first = partners.iter().position(|partner| reached.contains(*partner));
    if let Some(partner) = first {
        lists[partner].push(*disc);
    }
}
