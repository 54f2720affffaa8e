// region: 7.8
// fails: task_7_8_fixed_parts_cover_the_loop
// loses: 7.8, 7.9
// story: Each worker has n / workers iterations, rounded down: the rest of the loop belongs to no part.
let length = n / workers;
worker * length..(worker + 1) * length
