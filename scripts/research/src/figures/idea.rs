//! The kit's idea in one picture: which particles does a program look at?

use anyhow::Result;
use common::soft::{CUTOFF, Particle};
use oracle::Model;

use super::canvas::{BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, Panel, Point, filled, outlined};
use super::scenes::{after, neighbours};

const PIXELS: f64 = 280.0;
const GAP: f64 = 24.0;
const TOP: f64 = 36.0;
/// How far beyond the cutoff the list looks, in cutoffs.
const SKIN: f64 = 1.5;

/// What one particle looks at.
type Look = fn(&mut Canvas, &Panel, &Model, &Particle);

/// Three times the same scene: all pairs, bins, and a neighbour list.
pub(super) fn idea() -> Result<String> {
    let model = after(60, 120, 3)?;
    let title =
        "Which particles does one particle look at? All, those in nine bins, or those on its list";
    let mut canvas = Canvas::new(title, 3.0 * PIXELS + 4.0 * GAP, PIXELS + TOP + 60.0);
    let one = centre(&model);
    let ways: [(&str, &str, Look); 3] = [
        ("all pairs", "lab 1: look at every particle", all_pairs),
        ("bins", "lab 2: look into nine bins", bins),
        ("a list", "lab 10: look at a list that lasts", list),
    ];
    for (number, (name, what, draw)) in ways.into_iter().enumerate() {
        let left = GAP + number as f64 * (PIXELS + GAP);
        let panel = Panel { left, top: TOP, pixels: PIXELS, side: model.size };
        draw(&mut canvas, &panel, &model, one);
        panel.frame(&mut canvas, outlined(INK, 1.5));
        panel.text(&mut canvas, -12.0, 19.0, name);
        panel.text(&mut canvas, PIXELS + 28.0, 16.0, what);
    }
    Ok(canvas.svg())
}

/// A list alone.
pub(super) fn listed() -> Result<String> {
    const SIDE: f64 = 560.0;
    let model = after(60, 300, 1)?;
    let title = "A neighbour list: every pair that could touch before the list is rebuilt";
    let mut canvas = Canvas::new(title, SIDE + 2.0 * GAP, SIDE + TOP + GAP);
    let panel = Panel { left: GAP, top: TOP, pixels: SIDE, side: model.size };
    list(&mut canvas, &panel, &model, centre(&model));
    panel.frame(&mut canvas, outlined(INK, 1.5));
    Ok(canvas.svg())
}

fn position(panel: &Panel, particle: &Particle) -> Point {
    panel.at((particle.x, particle.y))
}

/// The particle nearest to the middle of the box.
fn centre(model: &Model) -> &Particle {
    let middle = model.size / 2.0;
    let distance = |p: &Particle| (p.x - middle).hypot(p.y - middle);
    model.particles.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).expect("a particle")
}

fn all_pairs(canvas: &mut Canvas, panel: &Panel, model: &Model, one: &Particle) {
    for other in &model.particles {
        canvas.line(position(panel, one), position(panel, other), outlined(BLUE, 0.8).faint(0.6));
    }
    dots(canvas, panel, model);
    canvas.circle(position(panel, one), 5.0, filled(ORANGE));
}

fn bins(canvas: &mut Canvas, panel: &Panel, model: &Model, one: &Particle) {
    let across = (model.size / CUTOFF).floor();
    let width = model.size / across;
    let bin = |x: f64| (x / width).floor();
    let corner = Particle { x: (bin(one.x) - 1.0) * width, y: (bin(one.y) + 2.0) * width, ..*one };
    let pixels = panel.long(width);
    canvas.rectangle(position(panel, &corner), 3.0 * pixels, 3.0 * pixels, filled(PALE_BLUE));
    for k in 1..across as u32 {
        let at = f64::from(k) * pixels;
        let style = outlined(GREY, 0.6);
        canvas.line((panel.left + at, TOP), (panel.left + at, TOP + PIXELS), style);
        canvas.line((panel.left, TOP + at), (panel.left + PIXELS, TOP + at), style);
    }
    for other in &model.particles {
        if (bin(other.x) - bin(one.x)).abs() <= 1.0 && (bin(other.y) - bin(one.y)).abs() <= 1.0 {
            canvas.line(position(panel, one), position(panel, other), outlined(BLUE, 1.5));
        }
    }
    dots(canvas, panel, model);
    canvas.circle(position(panel, one), 5.0, filled(ORANGE));
}

/// All listed pairs, the particle's own in blue; touching pairs are drawn as discs.
fn list(canvas: &mut Canvas, panel: &Panel, model: &Model, one: &Particle) {
    let reach = (1.0 + SKIN) * CUTOFF;
    for (i, p) in model.particles.iter().enumerate() {
        let listed = |q: &&Particle| (p.x - q.x).hypot(p.y - q.y) <= reach;
        for q in model.particles[i + 1..].iter().filter(listed) {
            let own = std::ptr::eq(p, one) || std::ptr::eq(q, one);
            let style = if own { outlined(BLUE, 1.5) } else { outlined(GREY, 0.7) };
            canvas.line(position(panel, p), position(panel, q), style);
        }
    }
    let touches = |p: &Particle| neighbours(p, &model.particles) > 0;
    for p in model.particles.iter().filter(|p| touches(p)) {
        canvas.circle(position(panel, p), panel.long(CUTOFF / 2.0), filled(ORANGE).faint(0.35));
    }
    canvas.circle(position(panel, one), panel.long(reach), outlined(BLUE, 1.0));
    dots(canvas, panel, model);
    canvas.circle(position(panel, one), 5.0, filled(ORANGE));
}

fn dots(canvas: &mut Canvas, panel: &Panel, model: &Model) {
    for p in &model.particles {
        canvas.circle(position(panel, p), 3.2, filled(GREY));
    }
}
