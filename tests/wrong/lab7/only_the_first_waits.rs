// region: 7.6b
// fails: task_7_6_discs_exchange_what_lies_along_the_line_between
// story: Only a disc that collides in the first half of a step waits at the wall.
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
    if time <= 0.5 {
        stop_at_wall(disc, square);
    }
    disc.pair_collisions += 1;
}
