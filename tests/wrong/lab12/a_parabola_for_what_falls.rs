// region: 12.4
// fails: task_12_4_what_falls_and_when
// story: The moment is that of the parabola through both ends and the slope at the start: nobody looks at what the particles do between.
let (c, d) = (start.value, start.slope * h);
let e = end.value - c - d;
let mut at = |t: f64| {
    let t = t / h;
    Watched { value: c + t * (d + t * e), slope: (d + 2.0 * t * e) / h }
};
if start.value <= 0.0 && start.slope < 0.0 {
    return Some(0.0);
}
match (start.slope <= 0.0, end.slope <= 0.0) {
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
