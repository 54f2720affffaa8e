// region: 7.2
// fails: task_7_7_one_step_of_a_hundred_lattices
// story: Discs that touch at exactly the end of the step collide in it.
let d = b.position() - a.position();
let velocity = b.velocity() - a.velocity();
let s = d.dot(velocity);
if s >= 0.0 {
    return None;
}
let (distance, reach) = (d.norm_squared(), 4.0 * radius * radius);
if distance <= reach {
    return Some(0.0);
}
let cross = d.cross(velocity);
let delta = reach * velocity.norm_squared() - cross * cross;
if delta <= 0.0 {
    return None;
}
let time = (distance - reach) / (delta.sqrt() - s);
(time <= 1.0).then_some(time)
