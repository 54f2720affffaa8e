//! A few hard discs step by step, computed by the graders' model, which lab 7's solution
//! agrees with step by step.

use anyhow::Result;
use common::hard::{Disc, RandomScene};
use oracle::hard::{Event, What, possible, step};

use super::canvas::{
    BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, Point, Style, filled, outlined,
};

const DISCS: u64 = 9;
const SIDE: f64 = 20.0;
const RADIUS: f64 = 1.0;
const SPEEDS: (f64, f64) = (2.0, 7.0);
/// A scene whose first step has all that a step can have.
const SEED: u32 = 19;

/// Pixels of a panel's square.
const PANEL: f64 = 270.0;
/// Pixels between panels, where nothing leaves them, and where straight ways do.
const NARROW: f64 = 24.0;
const WIDE: f64 = 60.0;
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

/// One panel of the sheet.
struct Panel {
    left: f64,
    top: f64,
    gap: f64,
}

impl Panel {
    fn number(index: usize, columns: usize, gap: f64) -> Self {
        let (row, column) = ((index / columns) as f64, (index % columns) as f64);
        let left = gap + column * (PANEL + gap);
        Self { left, top: gap + CAPTION + row * (PANEL + gap + CAPTION), gap }
    }

    /// A place in the square; y goes up.
    fn at(&self, (x, y): Point) -> Point {
        (self.left + x * PANEL / SIDE, self.top + PANEL - y * PANEL / SIDE)
    }

    fn frame(&self, canvas: &mut Canvas, caption: &str) {
        canvas.rectangle((self.left, self.top), PANEL, PANEL, outlined(INK, 1.5));
        // Above whatever leaves the square there.
        let above = self.top - self.gap + CAPTION;
        canvas.text((self.left + PANEL / 2.0, above), 15.0, INK, caption);
    }

    /// The rank of a candidate where discs meet, or outside the wall that one hits.
    fn badge(&self, canvas: &mut Canvas, discs: &[Disc], candidate: &Event, rank: usize) {
        let there = |number: usize| place(&discs[number], candidate.time);
        let (x, y) = self.at(there(candidate.disc));
        let middle = match candidate.what {
            What::Disc(other) => {
                let (other_x, other_y) = self.at(there(other));
                (0.5 * (x + other_x), 0.5 * (y + other_y))
            }
            What::Corner | What::WallX | What::WallY => {
                let out = RADIUS * PANEL / SIDE + BADGE + 2.0;
                let away = |p: f64, middle: f64| p + out * (p - middle).signum();
                let centre = (self.left + PANEL / 2.0, self.top + PANEL / 2.0);
                let x_out = if candidate.what == What::WallY { x } else { away(x, centre.0) };
                (x_out, if candidate.what == What::WallX { y } else { away(y, centre.1) })
            }
        };
        canvas.circle(middle, BADGE, outlined(INK, 1.2).on("#ffffff"));
        canvas.text((middle.0, middle.1 + 4.5), 13.0, INK, &rank.to_string());
    }

    fn disc(&self, canvas: &mut Canvas, place: Point, style: Style) {
        canvas.circle(self.at(place), RADIUS * PANEL / SIDE, style);
    }

    /// A disc with its number.
    fn named(&self, canvas: &mut Canvas, number: usize, disc: &Disc, style: Style) {
        self.disc(canvas, (disc.x, disc.y), style);
        let (x, y) = self.at((disc.x, disc.y));
        canvas.text((x, y + 5.0), 14.0, INK, &number.to_string());
    }

    /// Where a disc was, is or will be on its straight way, and the way from the start.
    fn way(&self, canvas: &mut Canvas, disc: &Disc, until: f64, style: Style) {
        canvas.line(self.at((disc.x, disc.y)), self.at(place(disc, until)), style);
    }
}

fn place(disc: &Disc, time: f64) -> Point {
    (disc.x + time * disc.vx, disc.y + time * disc.vy)
}

fn sheet(title: &str, columns: usize, rows: usize, gap: f64) -> Canvas {
    let width = gap + columns as f64 * (PANEL + gap);
    Canvas::new(title, width, rows as f64 * (PANEL + gap + CAPTION) + NARROW)
}

/// The discs that take part.
fn discs_of(event: &Event) -> impl Iterator<Item = usize> {
    let other = if let What::Disc(other) = event.what { Some(other) } else { None };
    [Some(event.disc), other].into_iter().flatten()
}

fn words(event: &Event) -> String {
    let what = match event.what {
        What::Corner => "a corner".into(),
        What::WallX => "a side wall".into(),
        What::WallY => "floor or ceiling".into(),
        What::Disc(other) => other.to_string(),
    };
    format!("λ = {:.3}: {} and {what}", event.time, event.disc)
}

const START: (&str, &str) = (BLUE, PALE_BLUE);

/// One step in six pictures: start, ways, candidates, their order, what happens, the end.
pub(super) fn one_step() -> Result<String> {
    let step = &steps(1)?[0];
    let Step { ref before, ref candidates, ref taken, ref after } = *step;
    let mut canvas =
        sheet("One step of nine hard discs, from the search to the result", 2, 3, WIDE);
    let panels: Vec<Panel> = (0..6).map(|index| Panel::number(index, 2, WIDE)).collect();
    let calm = outlined(START.0, 1.5).on(START.1);
    let ghost = outlined(GREY, 1.2).dashed();

    panels[0].frame(&mut canvas, "1. the start");
    for (number, disc) in before.iter().enumerate() {
        panels[0].named(&mut canvas, number, disc, calm);
        // From the rim, so that the number stays free.
        let rim = RADIUS / disc.vx.hypot(disc.vy);
        let (from, to) = (panels[0].at(place(disc, rim)), panels[0].at(place(disc, rim + 0.3)));
        canvas.arrow(from, to, ORANGE);
        panels[1].way(&mut canvas, disc, 1.0, outlined(GREY, 2.0 * PANEL / SIDE).faint(0.3));
        panels[1].disc(&mut canvas, place(disc, 1.0), ghost);
    }
    for (number, disc) in before.iter().enumerate() {
        panels[1].named(&mut canvas, number, disc, calm);
    }

    panels[1].frame(&mut canvas, "2. straight ways");

    panels[2].frame(&mut canvas, "3. what could happen, where");
    for (number, disc) in before.iter().enumerate() {
        panels[2].named(&mut canvas, number, disc, ghost);
    }
    for candidate in candidates {
        for number in discs_of(candidate) {
            let there = place(&before[number], candidate.time);
            let way = outlined(GREY, 1.2);
            panels[2].way(&mut canvas, &before[number], candidate.time, way);
            panels[2].disc(&mut canvas, there, outlined(BLUE, 1.2));
        }
    }
    for (rank, candidate) in (1..).zip(candidates) {
        panels[2].badge(&mut canvas, before, candidate, rank);
    }

    panels[3].frame(&mut canvas, "4. in order of λ: taken, or too late");
    for (rank, candidate) in candidates.iter().enumerate() {
        let happens = taken.contains(candidate);
        let middle = panels[3].left + PANEL / 2.0;
        let y = panels[3].top + 42.0 + 34.0 * rank as f64;
        let mark = if happens { "" } else { ", too late" };
        let text = format!("{}. {}{mark}", rank + 1, words(candidate));
        canvas.text((middle, y), 12.5, if happens { ORANGE } else { INK }, &text);
    }

    panels[4].frame(&mut canvas, "5. what happens");
    let busy = |number: usize| {
        taken.iter().find(|candidate| discs_of(candidate).any(|other| other == number))
    };
    for (number, disc) in before.iter().enumerate() {
        let style = match busy(number) {
            Some(candidate) => {
                panels[4].way(&mut canvas, disc, candidate.time, outlined(ORANGE, 1.5));
                let there = place(disc, candidate.time);
                let (to, from) = (&after[number], panels[4].at(there));
                canvas.line(from, panels[4].at((to.x, to.y)), outlined(ORANGE, 1.5).dashed());
                let touching = outlined(ORANGE, 1.5).on(PALE_ORANGE);
                let meeting = Disc { x: there.0, y: there.1, ..*disc };
                panels[4].named(&mut canvas, number, &meeting, touching);
                ghost
            }
            None => {
                panels[4].way(&mut canvas, disc, 1.0, outlined(GREY, 1.2));
                ghost
            }
        };
        panels[4].disc(&mut canvas, (disc.x, disc.y), style);
    }

    panels[5].frame(&mut canvas, "6. the end");
    for (number, disc) in after.iter().enumerate() {
        let style =
            if busy(number).is_some() { outlined(ORANGE, 1.5).on(PALE_ORANGE) } else { calm };
        panels[5].named(&mut canvas, number, disc, style);
    }
    Ok(canvas.svg())
}

/// Nine steps: who collides in each is orange, and its way has a bend.
pub(super) fn nine_steps() -> Result<String> {
    let mut canvas = sheet("Nine steps of nine hard discs", 3, 3, NARROW);
    for (index, step) in steps(9)?.iter().enumerate() {
        let panel = Panel::number(index, 3, NARROW);
        let pairs = step.taken.iter().filter(|c| matches!(c.what, What::Disc(_))).count();
        let walls = step.taken.len() - pairs;
        let s = |count: usize| if count == 1 { "" } else { "s" };
        let t = index + 1;
        let caption = format!("step {t}: {pairs} pair{}, {walls} wall{}", s(pairs), s(walls));
        panel.frame(&mut canvas, &caption);
        for (number, disc) in step.before.iter().enumerate() {
            let hit = step.taken.iter().find(|c| discs_of(c).any(|other| other == number));
            let end = &step.after[number];
            let bend = place(disc, hit.map_or(1.0, |candidate| candidate.time));
            let colour = if hit.is_some() { ORANGE } else { GREY };
            panel.disc(&mut canvas, (disc.x, disc.y), outlined(GREY, 1.0).dashed());
            canvas.line(panel.at((disc.x, disc.y)), panel.at(bend), outlined(colour, 1.5));
            canvas.line(panel.at(bend), panel.at((end.x, end.y)), outlined(colour, 1.5));
            canvas.circle(panel.at(bend), if hit.is_some() { 3.0 } else { 0.0 }, filled(ORANGE));
        }
        for (number, disc) in step.after.iter().enumerate() {
            let hit = step.taken.iter().any(|c| discs_of(c).any(|other| other == number));
            let (line, area) = if hit { (ORANGE, PALE_ORANGE) } else { START };
            panel.named(&mut canvas, number, disc, outlined(line, 1.5).on(area));
        }
    }
    Ok(canvas.svg())
}
