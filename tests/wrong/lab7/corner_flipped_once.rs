// region: 7.6
// fails: task_7_6_walls_turn_what_they_must, task_7_7_one_step_of_a_hundred_lattices
// story: In a corner only vx turns round.
travel(disc, time);
if matches!(hit, Hit::WallY(_)) {
    disc.vy = -disc.vy;
} else {
    disc.vx = -disc.vx;
}
travel(disc, 1.0 - time);
stop_at_wall(disc, square);
disc.wall_collisions += 1;
