// region: 7.11
// fails: task_7_11_the_box_of_a_window, task_7_13_cells_find_every_pair
// story: The box is drawn round the position at the end of the window and forgets where the disc came from.
let end = x + v * window.to.min(1.0);
Span { low: end - reach, high: end + reach }
