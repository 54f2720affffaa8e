// region: 12.4
// fails: task_12_4_what_falls_and_when
// story: The turn is looked for at one moment after another, 1000 in a step: right, and as dear as 1000 steps.
if start.value <= 0.0 && start.slope < 0.0 {
    return Some(0.0);
}
let falls = |slope: f64| slope <= 0.0;
let moment = |k: u32| h * f64::from(k) / 1000.0;
match (falls(start.slope), falls(end.slope)) {
    (_, true) if end.value >= 0.0 => None,
    (true, true) => Some(crossing(0.0, h, &mut |t| at(t).value)),
    (false, false) => None,
    (dips, _) => {
        let turned = (1..1000).find(|&k| falls(at(moment(k)).slope) != dips).unwrap_or(1000);
        let sign = if dips { -1.0 } else { 1.0 };
        let between = (moment(turned - 1), moment(turned));
        let turn = crossing(between.0, between.1, &mut |t| sign * at(t).slope);
        if dips {
            return (at(turn).value < 0.0).then(|| crossing(0.0, turn, &mut |t| at(t).value));
        }
        (at(turn).value > 0.0).then(|| crossing(turn, h, &mut |t| at(t).value)).or(Some(turn))
    }
}
