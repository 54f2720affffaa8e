// region: 12.6
// fails: task_12_6_a_distance_across_cells, task_12_6_the_error_does_not_depend_on_the_box
// story: Both places are computed from the corner of the box, in single precision, and then subtracted.
let x = |place: &Place| place.column as f32 * side + place.x;
let y = |place: &Place| place.row as f32 * side + place.y;
(x(to) - x(from), y(to) - y(from))
