// region: 7.7b
// fails: task_7_7_memory_grows_with_the_discs_not_with_their_pairs
// story: The finder gets copies of the discs, leaked so that nothing of the engine is borrowed: their memory never comes back.
engine.found.clear(1);
let (discs, free) = (engine.discs.clone().leak(), engine.free.clone().leak());
engine.finder.find(discs, free, engine.square, window, &mut engine.found);
let later = engine.walls[next_wall..].partition_point(|wall| wall.time < window.to);
engine.found.lists[0].extend_from_slice(&engine.walls[next_wall..next_wall + later]);
let Engine { choice, workers, found, free, taken, .. } = engine;
choice.take::<C>(workers, found, free, taken);
next_wall + later
