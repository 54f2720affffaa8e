// region: 7.6
// fails: task_7_6_walls_turn_what_they_must
// loses: 7.7
// story: After the wall a disc flies as long as before it. At λ = 1/2 that is right.
travel(disc, time);
if matches!(hit, Hit::WallX(_) | Hit::Corner(_)) {
    disc.vx = -disc.vx;
}
if matches!(hit, Hit::WallY(_) | Hit::Corner(_)) {
    disc.vy = -disc.vy;
}
travel(disc, time);
stop_at_wall(disc, square);
disc.wall_collisions += 1;
