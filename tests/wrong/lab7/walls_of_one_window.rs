// region: 7.7
// fails: task_7_7_a_window_takes_its_own_walls
// story: The walls are found as for one window, so they are not sorted by time, and with several windows some are put into the wrong one.
let windows = engine.finder.windows(&engine.discs, engine.square);
engine.free.fill(true);
engine.taken.clear();
engine.find_walls(1);
let mut next_wall = 0;
for k in 0..windows {
    next_wall = collide_in(engine, Window::part(k, windows), next_wall);
}
engine.move_discs();
