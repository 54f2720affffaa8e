// region: 7.6b
// fails: task_7_6_discs_exchange_what_lies_along_the_line_between, task_7_7_three_steps_of_unseen_scenes
// story: The normal is divided by 2 r, which its length is only if the discs do not overlap.
travel(a, time);
travel(b, time);
let n = b.position() - a.position();
let length = 4.0 * square.radius * square.radius;
let exchange = ((b.velocity() - a.velocity()).dot(n) / length) * n;
impulse(a, exchange);
impulse(b, -exchange);
for disc in [&mut *a, &mut *b] {
    travel(disc, 1.0 - time);
    stop_at_wall(disc, square);
    disc.pair_collisions += 1;
}
