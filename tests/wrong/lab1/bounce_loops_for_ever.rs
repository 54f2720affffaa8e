// region: 1.2
// fails: task_1_2_any_coordinate_in_any_box
// loses: 1.3
// story: Reflections one by one: at 1e18 box lengths each changes nothing any more, and the loop does not end.
let (mut x, mut v) = (x, v);
while x < 0.0 || x > size {
    x = if x < 0.0 { -x } else { 2.0 * size - x };
    v = -v;
}
(x, v)
