// region: 12.4
// fails: task_12_4_what_falls_and_when
// story: What is at zero and level falls at once, also if it rises then.
if start.value <= 0.0 && start.slope <= 0.0 {
    return Some(0.0);
}
let falls = |slope: f64| slope <= 0.0;
match (falls(start.slope), falls(end.slope)) {
    (_, true) if end.value >= 0.0 => None,
    (true, true) => Some(crossing(0.0, h, &mut |t| at(t).value)),
    // It rises and then falls: the crossing lies behind the top.
    (false, true) => {
        let top = crossing(0.0, h, &mut |t| at(t).slope);
        (at(top).value > 0.0).then(|| crossing(top, h, &mut |t| at(t).value)).or(Some(top))
    }
    // It falls and then rises: it may dip below zero.
    (true, false) => {
        let bottom = crossing(0.0, h, &mut |t| -at(t).slope);
        (at(bottom).value < 0.0).then(|| crossing(0.0, bottom, &mut |t| at(t).value))
    }
    (false, false) => None,
}
