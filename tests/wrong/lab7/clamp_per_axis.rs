// region: 7.5
// fails: task_7_5_waits_where_its_path_leaves, task_7_7_crafted_scenes
// loses: 7.7
// story: Each coordinate is clamped for itself, so the disc leaves its path and waits at another point of the wall.
disc.x = disc.x.clamp(square.least(), square.most());
disc.y = disc.y.clamp(square.least(), square.most());
