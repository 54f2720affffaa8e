//! Which particles of the official scene fly freely through a window.

use anyhow::Result;
use common::soft::{CUTOFF, DT, Particle};

use super::canvas::{BLUE, Canvas, GREY, INK, ORANGE, Panel, filled, outlined};
use super::scenes::after;

const SIDE: f64 = 560.0;
const MARGIN: f64 = 10.0;
/// Steps in the window.
const STEPS: u32 = 8;

/// A window of eight steps: free flights and groups.
pub(super) fn window() -> Result<String> {
    let model = after(60, 300, 1)?;
    let title = "A window of eight steps: most particles meet no other and fly freely";
    let mut canvas = Canvas::new(title, SIDE + 2.0 * MARGIN, SIDE + 2.0 * MARGIN + 34.0);
    let panel = Panel { left: MARGIN, top: MARGIN, pixels: SIDE, side: model.size };
    let mut free = 0;
    for one in &model.particles {
        let alone = inside(one, model.size)
            && model.particles.iter().all(|other| other.id == one.id || !meet(one, other));
        free += usize::from(alone);
        let (at, colour) = (panel.at((one.x, one.y)), if alone { BLUE } else { ORANGE });
        let disc = if alone { outlined(GREY, 1.0) } else { filled(ORANGE).faint(0.75) };
        canvas.circle(at, panel.long(CUTOFF / 2.0), disc);
        let end = panel.at((ahead(one.x, one.vx), ahead(one.y, one.vy)));
        canvas.line(at, end, outlined(colour, 2.0));
    }
    panel.frame(&mut canvas, outlined(INK, 1.5));
    let said = format!("{free} of {} fly freely", model.particles.len());
    panel.text(&mut canvas, SIDE + MARGIN + 20.0, 17.0, &said);
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
