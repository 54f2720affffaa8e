// region: 7.7b
// fails: task_7_7_a_window_takes_its_own_walls
// story: The walls are added before the finder has found its pairs: finders with several workers replace the lists, and no disc hits a wall.
engine.found.clear(1);
let later = engine.walls[next_wall..].partition_point(|wall| wall.time < window.to);
engine.found.lists[0].extend_from_slice(&engine.walls[next_wall..next_wall + later]);
engine.finder.find(&engine.discs, &engine.free, engine.square, window, &mut engine.found);
let Engine { choice, workers, found, free, taken, .. } = engine;
choice.take::<C>(workers, found, free, taken);
next_wall + later
