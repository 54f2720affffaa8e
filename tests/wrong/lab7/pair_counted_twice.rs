// region: 7.6b
// fails: task_7_6_discs_exchange_what_lies_along_the_line_between, task_7_7_twenty_steps_of_twenty_scenes
// story: The counter goes up twice for each disc, once as the first of the pair and once as the second.
travel(a, time);
travel(b, time);
let n = b.position() - a.position();
let length = n.norm_squared();
if length > 0.0 {
    let exchange = ((b.velocity() - a.velocity()).dot(n) / length) * n;
    impulse(a, exchange);
    impulse(b, -exchange);
}
for disc in [&mut *a, &mut *b] {
    travel(disc, 1.0 - time);
    stop_at_wall(disc, square);
    disc.pair_collisions += 2;
}
