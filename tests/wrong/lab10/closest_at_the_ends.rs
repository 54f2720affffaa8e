// region: 10.6
// fails: task_10_6_closest_approach
// story: Only the beginning and the end of the window are looked at; two that pass in between are missed.
let (ex, ey) = (dx + span * wx, dy + span * wy);
larger(0.0, (dx * dx + dy * dy).min(ex * ex + ey * ey))
