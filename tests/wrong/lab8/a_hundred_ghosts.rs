// region: 8.9
// fails: task_8_9_ghosts_go_where_their_boxes_reach
// story: A hundred ghosts at most for a partner.
for disc in own {
    let reached = reached(strips, disc, reach);
    for (partner, list) in partners.iter().zip(&mut lists) {
        if reached.contains(*partner) && list.len() < 100 {
            list.push(*disc);
        }
    }
}
