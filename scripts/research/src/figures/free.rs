//! Which particles of the official scene fly freely through a window.

use anyhow::Result;
use common::soft::{CUTOFF, DT, Particle, Scene};
use oracle::Model;

use super::canvas::{BLUE, Canvas, GREY, INK, ORANGE, Point, filled, outlined};

const SIDE: f64 = 560.0;
const MARGIN: f64 = 10.0;
/// Steps in the window.
const STEPS: u32 = 8;

/// A window of eight steps: free flights and groups.
pub(super) fn window() -> Result<String> {
    let mut model = Model::new(&Scene::official(300, 1)?);
    for _ in 0..60 {
        model.step();
    }
    let title = "A window of eight steps: most particles meet no other and fly freely";
    let mut canvas = Canvas::new(title, SIDE + 2.0 * MARGIN, SIDE + 2.0 * MARGIN + 34.0);
    let scale = SIDE / model.size;
    let place =
        |x: f64, y: f64| -> Point { (MARGIN + x * scale, MARGIN + (model.size - y) * scale) };
    let mut free = 0;
    for one in &model.particles {
        let alone = inside(one, model.size)
            && model.particles.iter().all(|other| other.id == one.id || !meet(one, other));
        free += usize::from(alone);
        let (at, colour) = (place(one.x, one.y), if alone { BLUE } else { ORANGE });
        let disc = if alone { outlined(GREY, 1.0) } else { filled(ORANGE).faint(0.75) };
        canvas.circle(at, CUTOFF / 2.0 * scale, disc);
        canvas.line(at, place(ahead(one.x, one.vx), ahead(one.y, one.vy)), outlined(colour, 2.0));
    }
    canvas.rectangle((MARGIN, MARGIN), SIDE, SIDE, outlined(INK, 1.5));
    let said = format!("{free} of {} fly freely", model.particles.len());
    canvas.text((MARGIN + SIDE / 2.0, SIDE + 2.0 * MARGIN + 20.0), 17.0, INK, &said);
    Ok(canvas.svg())
}

/// Where free flight ends.
fn ahead(x: f64, v: f64) -> f64 {
    x + v * f64::from(STEPS) * DT
}

fn inside(p: &Particle, size: f64) -> bool {
    [ahead(p.x, p.vx), ahead(p.y, p.vy)].iter().all(|end| (0.0..=size).contains(end))
}

/// Whether two free flights come within the cutoff and a margin of a twentieth, at any look.
fn meet(a: &Particle, b: &Particle) -> bool {
    (0..STEPS).any(|step| {
        let t = f64::from(step) * DT;
        let (dx, dy) = (b.x - a.x + t * (b.vx - a.vx), b.y - a.y + t * (b.vy - a.vy));
        dx.hypot(dy) <= 1.05 * CUTOFF
    })
}
