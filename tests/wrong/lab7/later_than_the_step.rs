// region: 7.1
// fails: task_7_1_walls_near_and_far
// story: λ is clamped below only: a disc that rounding has put outside, and that creeps back, hits its wall after the end of the step.
let along = |x: f64, v: f64| {
    if x + v < square.least() {
        Some(((square.least() - x) / v).max(0.0))
    } else if x + v > square.most() {
        Some(((square.most() - x) / v).max(0.0))
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
