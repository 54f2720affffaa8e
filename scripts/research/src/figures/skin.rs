//! A list with its skin, from the step in which it is made to the one in which it is worn out.

use anyhow::Result;

use super::canvas::{
    BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, Point, filled, outlined,
};

const PANEL: f64 = 240.0;
const TOP: f64 = 36.0;
const CUTOFF: f64 = 52.0;
const SKIN: f64 = 44.0;

/// Where others are, as seen from the particle, and where each goes.
const OTHERS: [(Point, Point); 6] = [
    ((-30.0, 22.0), (10.0, 8.0)),
    ((48.0, 46.0), (-8.0, 12.0)),
    ((-52.0, -52.0), (14.0, 0.0)),
    ((20.0, -84.0), (-6.0, 10.0)),
    ((-88.0, 72.0), (18.0, -12.0)),
    ((97.0, 0.0), (-22.0, 0.0)),
];
/// Where the particle goes: towards the last one, which is not on its list.
const OWN: Point = (22.0, 0.0);

/// The list when it is made, and when the first pair that it lacks could touch.
pub(super) fn ageing() -> Result<String> {
    let title = "A list holds the pairs within cutoff and skin. When two particles have each gone half a skin, a pair that is not on it may touch";
    let mut canvas = Canvas::new(title, 2.0 * PANEL + 30.0, TOP + PANEL + 62.0);
    let panels = [
        ("the list is made", ["blue: on the list,", "within c + s"]),
        ("worn out", ["each has gone s / 2:", "a pair not on the list may touch"]),
    ];
    for (panel, (name, under)) in panels.into_iter().enumerate() {
        let left = 10.0 + panel as f64 * (PANEL + 10.0);
        let share = panel as f64;
        let moved = |(x, y): Point, (dx, dy): Point| -> Point {
            let centre = (left + PANEL / 2.0 - 8.0, TOP + PANEL / 2.0);
            (centre.0 + x + share * dx, centre.1 - y - share * dy)
        };
        let one = moved((0.0, 0.0), OWN);
        canvas.text((left + PANEL / 2.0, TOP - 12.0), 17.0, INK, name);
        canvas.rectangle((left, TOP), PANEL, PANEL, outlined(GREY, 1.0));
        if panel == 0 {
            canvas.circle(one, CUTOFF + SKIN, outlined(BLUE, 1.5).on(PALE_BLUE).dashed());
        }
        canvas.circle(one, CUTOFF, outlined(ORANGE, 1.5).on(PALE_ORANGE));
        for (place, way) in OTHERS {
            let is_listed = place.0.hypot(place.1) <= CUTOFF + SKIN;
            let other = moved(place, way);
            if is_listed {
                canvas.line(one, other, outlined(BLUE, 1.5));
            } else if panel == 0 {
                canvas.arrow(other, (other.0 + 1.4 * way.0, other.1 - 1.4 * way.1), INK);
            }
            canvas.circle(other, 6.0, filled(if is_listed { BLUE } else { INK }));
        }
        canvas.circle(one, 7.0, filled(ORANGE));
        if panel == 0 {
            canvas.arrow(one, (one.0 + 1.4 * OWN.0, one.1), ORANGE);
            canvas.text((one.0 - 12.0, one.1 + CUTOFF - 14.0), 15.0, INK, "c");
            canvas.text((one.0 - 12.0, one.1 + CUTOFF + 28.0), 15.0, INK, "s");
        }
        for (line, text) in under.into_iter().enumerate() {
            let below = TOP + PANEL + 24.0 + 20.0 * line as f64;
            canvas.text((left + PANEL / 2.0, below), 15.0, INK, text);
        }
    }
    Ok(canvas.svg())
}
