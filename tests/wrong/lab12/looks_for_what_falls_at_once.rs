// region: 12.4
// fails: task_12_4_what_falls_and_when
// story: It knows no fall at once, and looks for the moment: that comes out a little after the start.
let falls = |slope: f64| slope <= 0.0;
match (falls(start.slope), falls(end.slope)) {
    (_, true) if end.value >= 0.0 => None,
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
