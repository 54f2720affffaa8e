// region: 8.9
// fails: task_8_9_ghosts_go_where_their_boxes_reach
// loses: 8.13
// story: A disc goes to the first and the last strip that it reaches, not to those between.
for disc in own {
    let reached = reached(strips, disc, reach);
    for (partner, list) in partners.iter().zip(&mut lists) {
        if reached.first == *partner || reached.last == *partner {
            list.push(*disc);
        }
    }
}
