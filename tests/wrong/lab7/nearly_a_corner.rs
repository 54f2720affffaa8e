// region: 7.1
// fails: task_7_1_walls_near_and_far
// story: Two walls within 1e-10 of a step are a corner: the disc turns round along both axes at one of the times.
let (x, y) = (along(disc.x, disc.vx, square), along(disc.y, disc.vy, square));
let (time, hit) = match (x, y) {
    (None, None) => return None,
    (Some(x), Some(y)) if (x - y).abs() < 1e-10 => (x.min(y), Hit::Corner(a)),
    (Some(x), Some(y)) if y < x => (y, Hit::WallY(a)),
    (Some(x), _) => (x, Hit::WallX(a)),
    (None, Some(y)) => (y, Hit::WallY(a)),
};
Some(Candidate { time, hit })
