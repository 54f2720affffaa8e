//! Swept boxes of hard discs, in a whole step and in the windows that it is cut into.

use anyhow::Result;
use common::hard::{Disc, RandomScene};

use super::canvas::{
    BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, Panel, Point, Style, filled, outlined,
};

const DISCS: u64 = 14;
const SIDE: f64 = 30.0;
const RADIUS: f64 = 0.8;
const SPEEDS: (f64, f64) = (3.0, 10.0);
const SEED: u32 = 3;
const WINDOWS: usize = 4;

const PIXELS: f64 = 246.0;
const GAP: f64 = 12.0;
const TOP: f64 = 36.0;

/// The lower left and the upper right corner.
pub(super) type Corners = (Point, Point);

/// What a disc can touch from one moment to another. Without the graders' margin for rounding,
/// which nobody would see.
pub(super) fn swept(disc: &Disc, radius: f64, (from, to): (f64, f64)) -> Corners {
    let along = |x: f64, v: f64| {
        let (start, end) = (x + from * v, x + to * v);
        (start.min(end) - radius, start.max(end) + radius)
    };
    let ((left, right), (low, high)) = (along(disc.x, disc.vx), along(disc.y, disc.vy));
    ((left, low), (right, high))
}

fn overlap(((left, low), (right, high)): Corners, ((l, b), (r, t)): Corners) -> bool {
    left <= r && l <= right && low <= t && b <= high
}

/// The pairs whose boxes overlap.
fn pairs(boxes: &[Corners]) -> Vec<(usize, usize)> {
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
    let boxes = |times| discs.iter().map(|disc| swept(disc, RADIUS, times)).collect::<Vec<_>>();
    let found: Vec<_> = (0..WINDOWS).map(|window| pairs(&boxes(part(window))).len()).collect();
    let sum: usize = found.iter().sum();
    let found: Vec<_> = found.iter().map(usize::to_string).collect();
    let whole = pairs(&boxes((0.0, 1.0))).len();

    let title = format!(
        "Boxes that {DISCS} discs sweep: {whole} pairs of boxes overlap in the whole step, {sum} in its {WINDOWS} windows together"
    );
    let mut canvas = Canvas::new(&title, 2.0 * PIXELS + 3.0 * GAP, TOP + PIXELS + 40.0);
    let under = [
        format!("{whole} pairs to look at"),
        format!("in all four: {} = {sum}", found.join(" + ")),
    ];
    let names = ["the whole step", "one of four windows"];
    let times = [(0.0, 1.0), part(0)];
    for (number, (name, times)) in names.into_iter().zip(times).enumerate() {
        let left = GAP + number as f64 * (PIXELS + GAP);
        let panel = Panel { left, top: TOP, pixels: PIXELS, side: SIDE };
        panel.text(&mut canvas, -12.0, 17.0, name);
        panel.text(&mut canvas, PIXELS + 25.0, 15.0, &under[number]);
        let boxes = boxes(times);
        let pairs = pairs(&boxes);
        for (number, &swept) in boxes.iter().enumerate() {
            let is_near = pairs.iter().any(|&(a, b)| a == number || b == number);
            let (line, area) = if is_near { (ORANGE, PALE_ORANGE) } else { (BLUE, PALE_BLUE) };
            draw(&mut canvas, &panel, swept, filled(area).faint(0.5));
            draw(&mut canvas, &panel, swept, outlined(line, 1.2));
        }
        for disc in discs {
            let (start, end) = (panel.at(moved(disc, times.0)), panel.at(moved(disc, times.1)));
            canvas.line(start, end, outlined(GREY, 1.5));
            canvas.circle(start, panel.long(RADIUS), outlined(INK, 1.2).on("#ffffff"));
        }
        panel.frame(&mut canvas, outlined(INK, 1.5));
    }
    Ok(canvas.svg())
}

/// What of a box is in the square, which nothing leaves.
pub(super) fn draw(canvas: &mut Canvas, panel: &Panel, (low, high): Corners, style: Style) {
    let inside = |(x, y): Point| panel.at((x.clamp(0.0, panel.side), y.clamp(0.0, panel.side)));
    let ((x, bottom), (right, top)) = (inside(low), inside(high));
    canvas.rectangle((x, top), right - x, bottom - top, style);
}

/// The centre after a part of the step, held in the square so that no path leaves the sheet.
fn moved(disc: &Disc, time: f64) -> Point {
    let along = |x: f64, v: f64| (x + time * v).clamp(0.0, SIDE);
    (along(disc.x, disc.vx), along(disc.y, disc.vy))
}
