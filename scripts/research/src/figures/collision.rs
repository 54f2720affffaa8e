//! Two hard discs, before and at their contact.

use anyhow::Result;

use super::canvas::{
    BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, Point, filled, outlined,
};

const RADIUS: f64 = 52.0;
const A: Point = (120.0, 240.0);
const B: Point = (420.0, 90.0);
/// How far each would travel in the whole step.
const V_A: Point = (260.0, -60.0);
const V_B: Point = (-110.0, 150.0);

fn along(from: Point, velocity: Point, share: f64) -> Point {
    (from.0 + share * velocity.0, from.1 + share * velocity.1)
}

fn dot(a: Point, b: Point) -> f64 {
    a.0 * b.0 + a.1 * b.1
}

/// The share of the step after which the two touch.
fn contact_time() -> f64 {
    let d = (B.0 - A.0, B.1 - A.1);
    let relative = (V_B.0 - V_A.0, V_B.1 - V_A.1);
    let s = dot(d, relative);
    let cross = d.0 * relative.1 - d.1 * relative.0;
    let root = (4.0 * RADIUS * RADIUS * dot(relative, relative) - cross * cross).sqrt();
    (dot(d, d) - 4.0 * RADIUS * RADIUS) / (-s + root)
}

/// Where two discs touch: the share λ of the step.
pub(super) fn contact() -> Result<String> {
    let title = "Two discs on their way: after the share lambda of the step they touch";
    let mut canvas = Canvas::new(title, 560.0, 340.0);
    let share = contact_time();
    let discs = [(A, V_A, BLUE, PALE_BLUE, "a"), (B, V_B, ORANGE, PALE_ORANGE, "b")];
    for (start, velocity, colour, tint, _) in discs {
        for place in [start, along(start, velocity, share)] {
            canvas.circle(place, RADIUS, outlined(colour, 1.5).on(tint));
        }
    }
    for (start, velocity, colour, _, name) in discs {
        let touch = along(start, velocity, share);
        canvas.circle(along(start, velocity, 1.0), RADIUS, outlined(GREY, 1.2).dashed());
        canvas.arrow(start, along(start, velocity, 1.0), colour);
        canvas.circle(touch, 4.0, filled(colour));
        canvas.text((start.0 - 14.0, start.1 - 10.0), 19.0, INK, name);
        canvas.text((touch.0 - 2.0, touch.1 - 14.0), 17.0, INK, "λ");
    }
    canvas.line(along(A, V_A, share), along(B, V_B, share), outlined(INK, 1.5).dashed());
    canvas.text(
        (280.0, 328.0),
        15.0,
        INK,
        "dashed circles: where they would be without each other",
    );
    Ok(canvas.svg())
}

/// What a contact does to the velocities: they exchange their parts along the line of centres.
pub(super) fn exchange() -> Result<String> {
    let title = "At contact the discs exchange their velocities along the line of centres";
    let mut canvas = Canvas::new(title, 580.0, 260.0);
    let share = contact_time();
    let (a, b) = (along(A, V_A, share), along(B, V_B, share));
    let normal = (b.0 - a.0, b.1 - a.1);
    let part = |v: Point| dot(v, normal) / dot(normal, normal);
    let (from_a, from_b) = (part(V_A), part(V_B));
    let exchanged = |v: Point, gain: f64| (v.0 + gain * normal.0, v.1 + gain * normal.1);
    let after = [exchanged(V_A, from_b - from_a), exchanged(V_B, from_a - from_b)];
    for (side, velocities, name) in [(0.0, [V_A, V_B], "before"), (1.0, after, "after")] {
        let shift = |p: Point| (p.0 - 150.0 + side * 240.0, p.1 - 48.0);
        canvas.line(
            shift(along(a, normal, -0.4)),
            shift(along(a, normal, 1.4)),
            outlined(GREY, 1.5).dashed(),
        );
        // Each part keeps the colour of the disc that brought it.
        let brought = if side == 0.0 { [BLUE, ORANGE] } else { [ORANGE, BLUE] };
        for (place, velocity, colour, tint, part_colour) in [
            (a, velocities[0], BLUE, PALE_BLUE, brought[0]),
            (b, velocities[1], ORANGE, PALE_ORANGE, brought[1]),
        ] {
            let normal_part = part(velocity);
            canvas.circle(shift(place), RADIUS, outlined(colour, 1.5).on(tint));
            canvas.line(
                shift(place),
                shift(along(place, normal, 0.4 * normal_part)),
                outlined(part_colour, 7.0).faint(0.4),
            );
            canvas.arrow(shift(place), shift(along(place, velocity, 0.4)), colour);
        }
        let (x, _) = shift(((a.0 + b.0) / 2.0, 0.0));
        canvas.text((x, 28.0), 19.0, INK, name);
    }
    canvas.text(
        (290.0, 246.0),
        15.0,
        INK,
        "thick: the part along the line of centres, which changes hands",
    );
    Ok(canvas.svg())
}
