// region: 7.2
// fails: task_7_2_discs_that_meet
// story: A pair further apart than 100000 diameters is skipped.
let d = b.position() - a.position();
let velocity = b.velocity() - a.velocity();
let s = d.dot(velocity);
let (distance, reach) = (d.norm_squared(), 4.0 * radius * radius);
if s >= 0.0 || distance > 1e10 * reach {
    return None;
}
if distance <= reach {
    return Some(0.0);
}
let cross = d.cross(velocity);
let delta = reach * velocity.norm_squared() - cross * cross;
if delta <= 0.0 {
    return None;
}
let time = (distance - reach) / (delta.sqrt() - s);
(time < 1.0).then_some(time)
