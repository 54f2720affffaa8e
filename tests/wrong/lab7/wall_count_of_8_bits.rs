// region: 7.6
// fails: task_7_6_walls_turn_what_they_must
// story: Counts wall collisions in 8 bits.
travel(disc, time);
if matches!(hit, Hit::WallX(_) | Hit::Corner(_)) {
    disc.vx = -disc.vx;
}
if matches!(hit, Hit::WallY(_) | Hit::Corner(_)) {
    disc.vy = -disc.vy;
}
travel(disc, 1.0 - time);
stop_at_wall(disc, square);
disc.wall_collisions = u32::from((disc.wall_collisions as u8).wrapping_add(1));
