//! Swept boxes of hard discs, in a whole step and in the windows that it is cut into.

use anyhow::Result;
use common::hard::{Disc, RandomScene};

use super::canvas::{
    BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, Point, filled, outlined,
};

const DISCS: u64 = 14;
const SIDE: f64 = 30.0;
const RADIUS: f64 = 0.8;
const SPEEDS: (f64, f64) = (3.0, 10.0);
const SEED: u32 = 3;
const WINDOWS: usize = 4;

const PANEL: f64 = 246.0;
const GAP: f64 = 12.0;
const TOP: f64 = 36.0;

/// The lower left and the upper right corner.
type Box = (Point, Point);

/// What a disc can touch from one moment to another. Without the graders' margin for rounding,
/// which nobody would see.
fn swept(disc: &Disc, (from, to): (f64, f64)) -> Box {
    let along = |x: f64, v: f64| {
        let (start, end) = (x + from * v, x + to * v);
        (start.min(end) - RADIUS, start.max(end) + RADIUS)
    };
    let ((left, right), (low, high)) = (along(disc.x, disc.vx), along(disc.y, disc.vy));
    ((left, low), (right, high))
}

fn overlap(((left, low), (right, high)): Box, ((l, b), (r, t)): Box) -> bool {
    left <= r && l <= right && low <= t && b <= high
}

/// The pairs whose boxes overlap.
fn pairs(boxes: &[Box]) -> Vec<(usize, usize)> {
    let all = (0..boxes.len()).flat_map(|a| (a + 1..boxes.len()).map(move |b| (a, b)));
    all.filter(|&(a, b)| overlap(boxes[a], boxes[b])).collect()
}

/// The boxes of a step, and those of the first of its windows.
pub(super) fn boxes() -> Result<String> {
    let (least, greatest) = SPEEDS;
    let scene = RandomScene::new(DISCS, SIDE, RADIUS, SEED).with_speeds(least, greatest).draw()?;
    let discs = scene.discs();
    let part = |window: usize| {
        let end = |number: usize| number as f64 / WINDOWS as f64;
        (end(window), end(window + 1))
    };
    let boxes = |times| discs.iter().map(|disc| swept(disc, times)).collect::<Vec<_>>();
    let found: Vec<_> = (0..WINDOWS).map(|window| pairs(&boxes(part(window))).len()).collect();
    let sum: usize = found.iter().sum();
    let found: Vec<_> = found.iter().map(usize::to_string).collect();
    let whole = pairs(&boxes((0.0, 1.0))).len();

    let title = format!(
        "Boxes that {DISCS} discs sweep: {whole} pairs of boxes overlap in the whole step, {sum} in its {WINDOWS} windows together"
    );
    let mut canvas = Canvas::new(&title, 2.0 * PANEL + 3.0 * GAP, TOP + PANEL + 40.0);
    let under = [
        format!("{whole} pairs to look at"),
        format!("in all four: {} = {sum}", found.join(" + ")),
    ];
    let names = ["the whole step", "one of four windows"];
    let times = [(0.0, 1.0), part(0)];
    for (panel, (name, times)) in names.into_iter().zip(times).enumerate() {
        let left = GAP + panel as f64 * (PANEL + GAP);
        let at = |(x, y): Point| (left + x * PANEL / SIDE, TOP + PANEL - y * PANEL / SIDE);
        canvas.text((left + PANEL / 2.0, TOP - 12.0), 17.0, INK, name);
        canvas.text((left + PANEL / 2.0, TOP + PANEL + 25.0), 15.0, INK, &under[panel]);
        let boxes = boxes(times);
        let pairs = pairs(&boxes);
        for (number, &((low_x, low_y), (high_x, high_y))) in boxes.iter().enumerate() {
            let is_near = pairs.iter().any(|&(a, b)| a == number || b == number);
            let (line, area) = if is_near { (ORANGE, PALE_ORANGE) } else { (BLUE, PALE_BLUE) };
            // Nothing flies out of the square.
            let inside = |p: f64| p.clamp(0.0, SIDE);
            let corner = at((inside(low_x), inside(high_y)));
            let scale = PANEL / SIDE;
            let width = (inside(high_x) - inside(low_x)) * scale;
            let height = (inside(high_y) - inside(low_y)) * scale;
            canvas.rectangle(corner, width, height, filled(area).faint(0.5));
            canvas.rectangle(corner, width, height, outlined(line, 1.2));
        }
        for disc in discs {
            let (start, end) = (at(moved(disc, times.0)), at(moved(disc, times.1)));
            canvas.line(start, end, outlined(GREY, 1.5));
            canvas.circle(start, RADIUS * PANEL / SIDE, outlined(INK, 1.2).on("#ffffff"));
        }
        canvas.rectangle((left, TOP), PANEL, PANEL, outlined(INK, 1.5));
    }
    Ok(canvas.svg())
}

/// The centre after a part of the step, held in the square so that no path leaves the sheet.
fn moved(disc: &Disc, time: f64) -> Point {
    let along = |x: f64, v: f64| (x + time * v).clamp(0.0, SIDE);
    (along(disc.x, disc.vx), along(disc.y, disc.vy))
}
