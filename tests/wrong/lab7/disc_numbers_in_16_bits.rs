// region: 7.1
// fails: task_7_1_walls_near_and_far
// story: The disc is named by the lower 16 bits of its number.
let along = |x: f64, v: f64| {
    let end = x + v;
    if end < square.least() {
        Some(((square.least() - x) / v).clamp(0.0, 1.0))
    } else if end > square.most() {
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
let a = a & 0xffff;
let hit = match hit {
    Hit::Corner(_) => Hit::Corner(a),
    Hit::WallX(_) => Hit::WallX(a),
    _ => Hit::WallY(a),
};
Some(Candidate { time, hit })
