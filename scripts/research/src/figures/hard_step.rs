//! A few hard discs step by step, computed by the graders' model, which lab 7's solution
//! agrees with step by step.

use anyhow::Result;
use common::hard::{Disc, RandomScene};
use oracle::hard::{Event, What, possible, step};

use super::canvas::{
    BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, Panel, Point, Style, filled, outlined,
};

const DISCS: u64 = 9;
const SIDE: f64 = 20.0;
const RADIUS: f64 = 1.0;
const SPEEDS: (f64, f64) = (2.0, 7.0);
/// A scene whose first step has all that a step can have.
const SEED: u32 = 19;

/// Pixels of a panel's square.
const PIXELS: f64 = 250.0;
/// Pixels between panels, where nothing leaves them, and where straight ways do.
const NARROW: f64 = 24.0;
const WIDE: f64 = 50.0;
/// Pixels of a caption.
const CAPTION: f64 = 15.0;
/// Radius of a rank's badge.
const BADGE: f64 = 9.0;

/// One step, and what was looked at in it.
struct Step {
    before: Vec<Disc>,
    /// All that could happen, in order.
    candidates: Vec<Event>,
    /// What did.
    taken: Vec<Event>,
    after: Vec<Disc>,
}

impl Step {
    /// What happens to a disc.
    fn hit(&self, number: usize) -> Option<&Event> {
        self.taken.iter().find(|event| event.involves(number))
    }

    /// How a disc is drawn at the end: orange if something happened to it.
    fn look(&self, number: usize) -> Style {
        let hit = self.hit(number).is_some();
        let (line, area) = if hit { (ORANGE, PALE_ORANGE) } else { (BLUE, PALE_BLUE) };
        outlined(line, 1.5).on(area)
    }
}

/// The first `count` steps of the scene.
fn steps(count: usize) -> Result<Vec<Step>> {
    let (least, greatest) = SPEEDS;
    let scene = RandomScene::new(DISCS, SIDE, RADIUS, SEED).with_speeds(least, greatest).draw()?;
    let mut discs = scene.discs().to_vec();
    let steps = (0..count).map(|_| {
        let (after, taken) = step(&discs, SIDE, RADIUS);
        let candidates = possible(&discs, SIDE, RADIUS);
        let before = std::mem::replace(&mut discs, after.clone());
        Step { before, candidates, taken, after }
    });
    Ok(steps.collect())
}

/// One panel of a sheet, with a caption above whatever leaves its square.
fn panel(canvas: &mut Canvas, index: usize, columns: usize, gap: f64, caption: &str) -> Panel {
    let (row, column) = ((index / columns) as f64, (index % columns) as f64);
    let left = gap + column * (PIXELS + gap);
    let top = gap + CAPTION + row * (PIXELS + gap + CAPTION);
    let panel = Panel { left, top, pixels: PIXELS, side: SIDE };
    panel.frame(canvas, outlined(INK, 1.5));
    panel.text(canvas, CAPTION - gap, 15.0, caption);
    panel
}

impl Panel {
    /// The rank of a candidate where discs meet, or outside the wall that one hits.
    fn badge(&self, canvas: &mut Canvas, discs: &[Disc], candidate: &Event, rank: usize) {
        let there = |number: usize| position(&discs[number], candidate.time);
        let (x, y) = self.at(there(candidate.disc));
        let middle = match candidate.what {
            What::Disc(other) => {
                let (other_x, other_y) = self.at(there(other));
                (0.5 * (x + other_x), 0.5 * (y + other_y))
            }
            What::Corner | What::WallX | What::WallY => {
                let out = self.long(RADIUS) + BADGE + 2.0;
                let away = |p: f64, middle: f64| p + out * (p - middle).signum();
                let centre = self.at((SIDE / 2.0, SIDE / 2.0));
                let x_out = if candidate.what == What::WallY { x } else { away(x, centre.0) };
                (x_out, if candidate.what == What::WallX { y } else { away(y, centre.1) })
            }
        };
        canvas.circle(middle, BADGE, outlined(INK, 1.2).on("#ffffff"));
        canvas.text((middle.0, middle.1 + 4.5), 13.0, INK, &rank.to_string());
    }

    fn disc(&self, canvas: &mut Canvas, position: Point, style: Style) {
        canvas.circle(self.at(position), self.long(RADIUS), style);
    }

    /// A disc with its number.
    fn named(&self, canvas: &mut Canvas, number: usize, disc: &Disc, style: Style) {
        self.disc(canvas, (disc.x, disc.y), style);
        let (x, y) = self.at((disc.x, disc.y));
        canvas.text((x, y + 5.0), 14.0, INK, &number.to_string());
    }

    /// Where a disc was, is or will be on its straight way, and the way from the start.
    fn way(&self, canvas: &mut Canvas, disc: &Disc, until: f64, style: Style) {
        canvas.line(self.at((disc.x, disc.y)), self.at(position(disc, until)), style);
    }
}

fn position(disc: &Disc, time: f64) -> Point {
    (disc.x + time * disc.vx, disc.y + time * disc.vy)
}

fn sheet(title: &str, columns: usize, rows: usize, gap: f64) -> Canvas {
    let width = gap + columns as f64 * (PIXELS + gap);
    Canvas::new(title, width, rows as f64 * (PIXELS + gap + CAPTION) + NARROW)
}

/// The discs that take part.
fn discs_of(event: &Event) -> impl Iterator<Item = usize> {
    let other = if let What::Disc(other) = event.what { Some(other) } else { None };
    [Some(event.disc), other].into_iter().flatten()
}

/// What one or two discs meet, in short.
fn words(discs: &[Disc], event: &Event) -> String {
    let Disc { vx, vy, .. } = discs[event.disc];
    let what = match event.what {
        What::Corner => "corner".into(),
        What::WallX => if vx < 0.0 { "left wall" } else { "right wall" }.into(),
        What::WallY => if vy < 0.0 { "floor" } else { "ceiling" }.into(),
        What::Disc(other) => other.to_string(),
    };
    format!("{}, {what}", event.disc)
}

/// Draws a part of a step.
type Part = fn(&mut Canvas, &Panel, &Step);

/// One step in four pictures: straight ways, candidates, the choice among them, the rest of the step.
pub(super) fn one_step() -> Result<String> {
    let step = &steps(1)?[0];
    let mut canvas = sheet("One step of nine hard discs, from the search to the end", 2, 2, WIDE);
    let parts: [(&str, Part); 4] = [
        ("1. straight paths", straight_ways),
        ("2. candidates: what could happen", candidates),
        ("3. the choice, in order of λ", choice),
        ("4. what happens, and the end", rest),
    ];
    for (index, (caption, draw)) in parts.into_iter().enumerate() {
        let panel = panel(&mut canvas, index, 2, WIDE, caption);
        draw(&mut canvas, &panel, step);
    }
    Ok(canvas.svg())
}

/// The start, and where each disc would be at the end if nothing were in its way.
fn straight_ways(canvas: &mut Canvas, panel: &Panel, step: &Step) {
    for disc in &step.before {
        panel.way(canvas, disc, 1.0, outlined(GREY, 2.0 * panel.long(RADIUS)).faint(0.3));
        panel.disc(canvas, position(disc, 1.0), outlined(GREY, 1.2).dashed());
    }
    for (number, disc) in step.before.iter().enumerate() {
        panel.named(canvas, number, disc, outlined(BLUE, 1.5).on(PALE_BLUE));
    }
}

/// Discs at the moment of each candidate; its number is the position in the order.
fn candidates(canvas: &mut Canvas, panel: &Panel, step: &Step) {
    for (number, disc) in step.before.iter().enumerate() {
        panel.named(canvas, number, disc, outlined(GREY, 1.2).dashed());
    }
    for candidate in &step.candidates {
        let style = outlined(if step.taken.contains(candidate) { ORANGE } else { BLUE }, 1.5);
        for disc in discs_of(candidate).map(|number| &step.before[number]) {
            panel.way(canvas, disc, candidate.time, outlined(GREY, 1.2));
            panel.disc(canvas, position(disc, candidate.time), style);
        }
    }
    for (rank, candidate) in (1..).zip(&step.candidates) {
        panel.badge(canvas, &step.before, candidate, rank);
    }
}

/// The candidates in order of their time, and why each is taken or not.
fn choice(canvas: &mut Canvas, panel: &Panel, step: &Step) {
    const LINE: f64 = 29.0;
    let columns = [18.0, 58.0, 123.0, 203.0].map(|x| panel.left + x);
    let heads = ["", "λ", "who", "both free?"];
    for (x, head) in columns.into_iter().zip(heads) {
        canvas.text((x, panel.top + 24.0), 14.0, INK, head);
    }
    for (row, candidate) in step.candidates.iter().enumerate() {
        let rank = row + 1;
        let y = panel.top + 24.0 + LINE * rank as f64;
        let caught = discs_of(candidate).find(|number| {
            let mut earlier =
                step.candidates[..row].iter().filter(|event| step.taken.contains(event));
            earlier.any(|other| other.involves(*number))
        });
        let (verdict, colour) = match caught {
            None => ("taken".into(), ORANGE),
            Some(disc) => (format!("{disc} is not"), INK),
        };
        canvas.circle((columns[0], y - 4.5), BADGE, outlined(INK, 1.2).on("#ffffff"));
        let cells =
            [rank.to_string(), format!("{:.3}", candidate.time), words(&step.before, candidate)];
        for (column, cell) in cells.iter().chain([&verdict]).enumerate() {
            let ink = if column == 0 { INK } else { colour };
            canvas.text((columns[column], y), if column == 0 { 13.0 } else { 14.0 }, ink, cell);
        }
    }
}

/// What happens: the way to a collision, the discs in it, the way from it, and where all end.
fn rest(canvas: &mut Canvas, panel: &Panel, step: &Step) {
    for (number, (disc, end)) in step.before.iter().zip(&step.after).enumerate() {
        panel.disc(canvas, (disc.x, disc.y), outlined(GREY, 1.0).dashed());
        let Some(hit) = step.hit(number) else {
            panel.way(canvas, disc, 1.0, outlined(GREY, 1.5));
            continue;
        };
        let bend = position(disc, hit.time);
        panel.disc(canvas, bend, outlined(ORANGE, 1.0));
        panel.way(canvas, disc, hit.time, outlined(ORANGE, 2.0));
        canvas.line(panel.at(bend), panel.at((end.x, end.y)), outlined(ORANGE, 2.0).dashed());
    }
    for (number, end) in step.after.iter().enumerate() {
        panel.named(canvas, number, end, step.look(number));
    }
}

/// Nine steps: who collides in each is orange, and its way has a bend.
pub(super) fn nine_steps() -> Result<String> {
    let mut canvas = sheet("Nine steps of nine hard discs", 3, 3, NARROW);
    for (index, step) in steps(9)?.iter().enumerate() {
        let pairs = step.taken.iter().filter(|c| matches!(c.what, What::Disc(_))).count();
        let walls = step.taken.len() - pairs;
        let s = |count: usize| if count == 1 { "" } else { "s" };
        let t = index + 1;
        let caption = format!("step {t}: {pairs} pair{}, {walls} wall{}", s(pairs), s(walls));
        let panel = panel(&mut canvas, index, 3, NARROW, &caption);
        for (number, disc) in step.before.iter().enumerate() {
            let hit = step.hit(number);
            let end = &step.after[number];
            let bend = position(disc, hit.map_or(1.0, |candidate| candidate.time));
            let colour = if hit.is_some() { ORANGE } else { GREY };
            panel.disc(&mut canvas, (disc.x, disc.y), outlined(GREY, 1.0).dashed());
            canvas.line(panel.at((disc.x, disc.y)), panel.at(bend), outlined(colour, 1.5));
            canvas.line(panel.at(bend), panel.at((end.x, end.y)), outlined(colour, 1.5));
            canvas.circle(panel.at(bend), if hit.is_some() { 3.0 } else { 0.0 }, filled(ORANGE));
        }
        for (number, disc) in step.after.iter().enumerate() {
            panel.named(&mut canvas, number, disc, step.look(number));
        }
    }
    Ok(canvas.svg())
}
