// region: 7.2
// fails: task_7_2_discs_that_meet
// story: Discs that are slow as seen from each other are taken for resting.
let d = b.position() - a.position();
let velocity = b.velocity() - a.velocity();
let s = d.dot(velocity);
if s >= 0.0 || velocity.norm_squared() < 1e-20 {
    return None;
}
let (distance, reach) = (d.norm_squared(), 4.0 * radius * radius);
if distance <= reach && distance != 0.0 {
    return Some(0.0);
}
let cross = d.cross(velocity);
let delta = reach * velocity.norm_squared() - cross * cross;
if delta <= 0.0 {
    return None;
}
let time = (distance - reach) / (delta.sqrt() - s);
(time < 1.0).then_some(time)
