// region: 11.2
// fails: task_11_2_closest_approach
// story: Only the beginning and the end of the window are looked at; two that pass in between are missed.
let (ex, ey) = (dx + span * wx, dy + span * wy);
larger(0.0, (dx * dx + dy * dy).min(ex * ex + ey * ey))
