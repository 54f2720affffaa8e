// region: 7.7
// fails: task_7_7_a_step_begins_with_nothing_taken
// story: A disc alone keeps what happened in the step before: its bounce is carried out again.
let windows = engine.finder.windows(&engine.discs, engine.square);
engine.free.fill(true);
if engine.discs.len() > 1 {
    engine.taken.clear();
}
engine.find_walls(windows);
let mut next_wall = 0;
for k in 0..windows {
    next_wall = collide_in(engine, Window::part(k, windows), next_wall);
}
engine.move_discs();
