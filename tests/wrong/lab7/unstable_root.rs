// region: 7.2
// fails: task_7_2_discs_in_contact_or_nearly
// story: The root as the textbook prints it: the difference of two numbers that agree in nearly all digits.
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
let time = (-s - delta.sqrt()) / velocity.norm_squared();
(time < 1.0).then_some(time)
