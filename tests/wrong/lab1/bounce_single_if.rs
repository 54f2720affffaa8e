// region: 1.2
// fails: task_1_2_any_coordinate_in_any_box, task_1_3_fast_particles
// loses: 1.3
// story: One reflection at most: a fast particle in a small box is left outside.
if x < 0.0 {
    (-x, -v)
} else if x > size {
    (2.0 * size - x, -v)
} else {
    (x, v)
}
