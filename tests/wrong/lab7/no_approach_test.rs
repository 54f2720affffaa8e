// region: 7.2
// fails: task_7_2_discs_in_contact_or_nearly
// story: Discs that fly apart collide too, if they overlap or if they would have met before the step.
let d = b.position() - a.position();
let velocity = b.velocity() - a.velocity();
let s = d.dot(velocity);
if velocity.norm_squared() == 0.0 {
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
(time < 1.0).then_some(time)
