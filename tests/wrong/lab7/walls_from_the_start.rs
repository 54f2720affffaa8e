// region: 7.7b
// fails: task_7_7_a_window_takes_its_own_walls
// story: Walls of earlier windows come again.
engine.found.clear(1);
engine.finder.find(&engine.discs, &engine.free, engine.square, window, &mut engine.found);
let later = engine.walls[next_wall..].partition_point(|wall| wall.time < window.to);
engine.found.lists[0].extend_from_slice(&engine.walls[..next_wall + later]);
let Engine { choice, workers, found, free, taken, .. } = engine;
choice.take::<C>(workers, found, free, taken);
next_wall + later
