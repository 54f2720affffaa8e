// region: 7.2
// fails: task_7_2_discs_in_contact_or_nearly, task_7_7_three_steps_of_unseen_scenes
// story: Discs that overlap at the start of the step pass through each other.
let d = b.position() - a.position();
let velocity = b.velocity() - a.velocity();
let s = d.dot(velocity);
if s >= 0.0 {
    return None;
}
let (distance, reach) = (d.norm_squared(), 4.0 * radius * radius);
if distance <= reach {
    return None;
}
let cross = d.cross(velocity);
let delta = reach * velocity.norm_squared() - cross * cross;
if delta <= 0.0 {
    return None;
}
let time = (distance - reach) / (delta.sqrt() - s);
(time < 1.0).then_some(time)
