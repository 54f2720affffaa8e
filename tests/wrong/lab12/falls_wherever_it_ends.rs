// region: 12.4
// fails: task_12_4_what_falls_and_when, task_12_4_keeps_fourth_order_across_the_cutoff
// story: A number that rises and then falls is taken to fall through zero, though it may end above it.
if start.value <= 0.0 && start.slope < 0.0 {
    return Some(0.0);
}
let falls = |slope: f64| slope <= 0.0;
match (falls(start.slope), falls(end.slope)) {
    (true, true) if end.value >= 0.0 => None,
    (true, true) => Some(crossing(0.0, h, &mut |t| at(t).value)),
    (false, true) => {
        let top = crossing(0.0, h, &mut |t| at(t).slope);
        (at(top).value > 0.0).then(|| crossing(top, h, &mut |t| at(t).value)).or(Some(top))
    }
    (true, false) => {
        let bottom = crossing(0.0, h, &mut |t| -at(t).slope);
        (at(bottom).value < 0.0).then(|| crossing(0.0, bottom, &mut |t| at(t).value))
    }
    (false, false) => None,
}
