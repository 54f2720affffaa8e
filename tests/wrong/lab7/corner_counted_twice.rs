// region: 7.6
// fails: task_7_6_walls_turn_what_they_must, task_7_7_one_step_of_a_hundred_lattices
// story: The counter goes up once for each wall, so twice in a corner.
travel(disc, time);
if matches!(hit, Hit::WallX(_) | Hit::Corner(_)) {
    disc.vx = -disc.vx;
    disc.wall_collisions += 1;
}
if matches!(hit, Hit::WallY(_) | Hit::Corner(_)) {
    disc.vy = -disc.vy;
    disc.wall_collisions += 1;
}
travel(disc, 1.0 - time);
stop_at_wall(disc, square);
