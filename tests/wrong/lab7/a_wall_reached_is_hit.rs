// region: 7.1
// fails: task_7_1_walls_near_and_far
// story: A disc that reaches a wall exactly at the end of the step has hit it. It does so in the next step.
let along = |x: f64, v: f64| {
    if x + v <= square.least() {
        Some(((square.least() - x) / v).clamp(0.0, 1.0))
    } else if x + v >= square.most() {
        Some(((square.most() - x) / v).clamp(0.0, 1.0))
    } else {
        None
    }
};
let (x, y) = (along(disc.x, disc.vx), along(disc.y, disc.vy));
let (time, hit) = match (x, y) {
    (None, None) => return None,
    (Some(x), Some(y)) if x == y => (x, Hit::Corner(a)),
    (Some(x), Some(y)) if y < x => (y, Hit::WallY(a)),
    (Some(x), _) => (x, Hit::WallX(a)),
    (None, Some(y)) => (y, Hit::WallY(a)),
};
Some(Candidate { time, hit })
