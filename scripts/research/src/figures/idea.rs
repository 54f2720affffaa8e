//! The kit's idea in one picture: which particles does a program look at?

use anyhow::Result;
use common::soft::{CUTOFF, Particle, Scene};
use oracle::Model;

use super::canvas::{BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, Point, filled, outlined};
use super::scenes::neighbours;

const PANEL: f64 = 280.0;
const GAP: f64 = 24.0;
const TOP: f64 = 36.0;
/// How far beyond the cutoff the list looks, in cutoffs.
const SKIN: f64 = 1.5;

/// Three times the same scene: all pairs, bins, and a neighbour list.
pub(super) fn idea() -> Result<String> {
    let mut model = Model::new(&Scene::official(120, 3)?);
    for _ in 0..60 {
        model.step();
    }
    let title =
        "Which particles does one particle look at? All, those in nine bins, or those on its list";
    let mut canvas = Canvas::new(title, 3.0 * PANEL + 4.0 * GAP, PANEL + TOP + 60.0);
    let one = centre(&model);
    let captions = [
        ("all pairs", "lab 1: look at every particle"),
        ("bins", "lab 2: look into nine bins"),
        ("a list", "lab 10: look at a list that lasts"),
    ];
    for (panel, (name, what)) in captions.into_iter().enumerate() {
        let left = GAP + panel as f64 * (PANEL + GAP);
        let sheet = Sheet { left, scale: PANEL / model.size, size: model.size };
        match panel {
            0 => all_pairs(&mut canvas, &sheet, &model, one),
            1 => bins(&mut canvas, &sheet, &model, one),
            _ => list(&mut canvas, &sheet, &model, one),
        }
        canvas.rectangle((left, TOP), PANEL, PANEL, outlined(INK, 1.5));
        canvas.text((left + PANEL / 2.0, TOP - 12.0), 19.0, INK, name);
        canvas.text((left + PANEL / 2.0, TOP + PANEL + 28.0), 16.0, INK, what);
    }
    Ok(canvas.svg())
}

/// A list alone.
pub(super) fn listed() -> Result<String> {
    const SIDE: f64 = 560.0;
    let mut model = Model::new(&Scene::official(300, 1)?);
    for _ in 0..60 {
        model.step();
    }
    let title = "A neighbour list: every pair that could touch before the list is made anew";
    let mut canvas = Canvas::new(title, SIDE + 2.0 * GAP, SIDE + TOP + GAP);
    let sheet = Sheet { left: GAP, scale: SIDE / model.size, size: model.size };
    list(&mut canvas, &sheet, &model, centre(&model));
    canvas.rectangle((GAP, TOP), SIDE, SIDE, outlined(INK, 1.5));
    Ok(canvas.svg())
}

/// Where a panel lies and how large a cutoff is in it.
struct Sheet {
    left: f64,
    scale: f64,
    size: f64,
}

impl Sheet {
    fn place(&self, p: &Particle) -> Point {
        (self.left + p.x * self.scale, TOP + (self.size - p.y) * self.scale)
    }
}

/// The particle nearest to the middle of the box.
fn centre(model: &Model) -> &Particle {
    let middle = model.size / 2.0;
    let distance = |p: &Particle| (p.x - middle).hypot(p.y - middle);
    model.particles.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).expect("a particle")
}

fn all_pairs(canvas: &mut Canvas, sheet: &Sheet, model: &Model, one: &Particle) {
    for other in &model.particles {
        canvas.line(sheet.place(one), sheet.place(other), outlined(BLUE, 0.8).faint(0.6));
    }
    dots(canvas, sheet, model);
    canvas.circle(sheet.place(one), 5.0, filled(ORANGE));
}

fn bins(canvas: &mut Canvas, sheet: &Sheet, model: &Model, one: &Particle) {
    let across = (model.size / CUTOFF).floor();
    let width = model.size / across;
    let bin = |x: f64| (x / width).floor();
    let corner = Particle { x: (bin(one.x) - 1.0) * width, y: (bin(one.y) + 2.0) * width, ..*one };
    let pixels = width * sheet.scale;
    canvas.rectangle(sheet.place(&corner), 3.0 * pixels, 3.0 * pixels, filled(PALE_BLUE));
    for k in 1..across as u32 {
        let at = f64::from(k) * pixels;
        let style = outlined(GREY, 0.6);
        canvas.line((sheet.left + at, TOP), (sheet.left + at, TOP + PANEL), style);
        canvas.line((sheet.left, TOP + at), (sheet.left + PANEL, TOP + at), style);
    }
    for other in &model.particles {
        if (bin(other.x) - bin(one.x)).abs() <= 1.0 && (bin(other.y) - bin(one.y)).abs() <= 1.0 {
            canvas.line(sheet.place(one), sheet.place(other), outlined(BLUE, 1.5));
        }
    }
    dots(canvas, sheet, model);
    canvas.circle(sheet.place(one), 5.0, filled(ORANGE));
}

/// All listed pairs, the particle's own in blue; touching pairs are drawn as discs.
fn list(canvas: &mut Canvas, sheet: &Sheet, model: &Model, one: &Particle) {
    let reach = (1.0 + SKIN) * CUTOFF;
    for (i, p) in model.particles.iter().enumerate() {
        let listed = |q: &&Particle| (p.x - q.x).hypot(p.y - q.y) <= reach;
        for q in model.particles[i + 1..].iter().filter(listed) {
            let own = std::ptr::eq(p, one) || std::ptr::eq(q, one);
            let style = if own { outlined(BLUE, 1.5) } else { outlined(GREY, 0.7) };
            canvas.line(sheet.place(p), sheet.place(q), style);
        }
    }
    let touches = |p: &Particle| neighbours(p, &model.particles) > 0;
    for p in model.particles.iter().filter(|p| touches(p)) {
        canvas.circle(sheet.place(p), CUTOFF / 2.0 * sheet.scale, filled(ORANGE).faint(0.35));
    }
    canvas.circle(sheet.place(one), reach * sheet.scale, outlined(BLUE, 1.0));
    dots(canvas, sheet, model);
    canvas.circle(sheet.place(one), 5.0, filled(ORANGE));
}

fn dots(canvas: &mut Canvas, sheet: &Sheet, model: &Model) {
    for p in &model.particles {
        canvas.circle(sheet.place(p), 3.2, filled(GREY));
    }
}
