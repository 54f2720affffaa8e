//! The two loops of a step: all look while none moves, then all move while none looks.

use anyhow::Result;

use super::canvas::{BLUE, Canvas, GREY, INK, ORANGE, PALE_ORANGE, Point, filled, outlined};

const PANEL: f64 = 240.0;
const TOP: f64 = 36.0;
/// The cutoff, in pixels, and so the diameter of a disc.
const CUTOFF: f64 = 56.0;

/// Places and velocities of a few particles, in pixels; the first one looks at the others.
const PARTICLES: [(Point, Point); 7] = [
    ((118.0, 112.0), (12.0, 20.0)),
    ((158.0, 130.0), (-14.0, 22.0)),
    ((40.0, 52.0), (26.0, 16.0)),
    ((198.0, 48.0), (-30.0, 8.0)),
    ((52.0, 180.0), (8.0, -34.0)),
    ((190.0, 200.0), (-26.0, -14.0)),
    ((84.0, 78.0), (-20.0, 12.0)),
];

/// What the others do to a velocity: the nearer they are, the more.
fn pushed((x, y): Point, mut velocity: Point) -> Point {
    for ((other_x, other_y), _) in PARTICLES {
        let (dx, dy) = (x - other_x, y - other_y);
        let distance = dx.hypot(dy);
        if distance > 0.0 && distance < CUTOFF {
            let push = 2.0 * (CUTOFF / distance - 1.0);
            velocity.0 += push * dx;
            velocity.1 += push * dy;
        }
    }
    velocity
}

/// A step of lab 1.
pub(super) fn two_loops() -> Result<String> {
    let title = "Two loops make a step: in the first each particle looks at all others and none moves, in the second each moves and none looks";
    let mut canvas = Canvas::new(title, 2.0 * PANEL + 30.0, TOP + PANEL + 40.0);
    let panels = [
        ("loop 1: look, and add up", "six looks, two pushes"),
        ("loop 2: move", "dashed: where they were"),
    ];
    for (panel, (name, under)) in panels.into_iter().enumerate() {
        let left = 10.0 + panel as f64 * (PANEL + 10.0);
        let at = |(x, y): Point| (left + x, TOP + y);
        let [(one, _), ..] = PARTICLES;
        canvas.text((left + PANEL / 2.0, TOP - 12.0), 17.0, INK, name);
        for (place, velocity) in PARTICLES {
            let after = pushed(place, velocity);
            let is_pushed = after != velocity;
            let (x, y) = at(place);
            if panel == 0 {
                let (line, area) =
                    if is_pushed { (ORANGE, PALE_ORANGE) } else { (GREY, "#ffffff") };
                canvas.circle((x, y), CUTOFF / 2.0, outlined(line, 1.5).on(area).faint(0.7));
                canvas.line(at(one), (x, y), outlined(BLUE, 1.2));
            } else {
                let end = (x + after.0, y + after.1);
                let line = if is_pushed { ORANGE } else { GREY };
                canvas.circle((x, y), CUTOFF / 2.0, outlined(GREY, 1.0).dashed());
                canvas.circle(end, CUTOFF / 2.0, outlined(line, 1.5));
                canvas.arrow((x, y), end, if is_pushed { ORANGE } else { BLUE });
            }
        }
        for (place, _) in PARTICLES.iter().skip(usize::from(panel == 0)) {
            canvas.circle(at(*place), 3.5, filled(INK));
        }
        if panel == 0 {
            canvas.circle(at(one), 6.0, filled(ORANGE));
        }
        canvas.rectangle((left, TOP), PANEL, PANEL, outlined(INK, 1.5));
        canvas.text((left + PANEL / 2.0, TOP + PANEL + 26.0), 15.0, INK, under);
    }
    Ok(canvas.svg())
}
