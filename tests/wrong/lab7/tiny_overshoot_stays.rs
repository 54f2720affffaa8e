// region: 7.5
// fails: task_7_5_waits_where_its_path_leaves
// loses: 7.6
// story: A disc less than 1e-12 beyond a wall stays there.
let back = |x: f64, v: f64| {
    let beyond = x - x.clamp(square.least(), square.most());
    let time = beyond / v;
    if beyond.abs() > 1e-12 && time > 0.0 && time <= 2.0 { time } else { 0.0 }
};
let time = back(disc.x, disc.vx).max(back(disc.y, disc.vy));
disc.x -= time * disc.vx;
disc.y -= time * disc.vy;
