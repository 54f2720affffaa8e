//! Lab 7's grid of three levels, and which level the discs of a small scene are in.

use anyhow::Result;
use common::hard::{Disc, RandomScene};

use super::canvas::{
    BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, Point, filled, outlined,
};

const DISCS: u64 = 24;
const SIDE: f64 = 40.0;
const RADIUS: f64 = 0.7;
const SPEEDS: (f64, f64) = (1.0, 6.0);
const SEED: u32 = 5;

/// Blocks along a side, and the caption.
const LEVELS: [(f64, &str); 3] =
    [(4.0, "small blocks"), (2.0, "medium blocks"), (1.0, "the whole square")];

const PANEL: f64 = 270.0;
const GAP: f64 = 24.0;
const CAPTION: f64 = 40.0;

/// What a disc can touch in the step: the lower left and the upper right corner of its box.
fn swept(disc: &Disc) -> (Point, Point) {
    let span = |x: f64, v: f64| (x.min(x + v) - RADIUS, x.max(x + v) + RADIUS);
    let ((left, right), (low, high)) = (span(disc.x, disc.vx), span(disc.y, disc.vy));
    ((left, low), (right, high))
}

/// The finest level with a block that a box fits into. What lies beyond the square counts to the
/// outermost blocks.
fn level((low, high): (Point, Point)) -> usize {
    let fits = |blocks: f64| {
        let place = |at: f64| (at / SIDE * blocks).floor().clamp(0.0, blocks - 1.0);
        place(low.0) == place(high.0) && place(low.1) == place(high.1)
    };
    LEVELS.iter().position(|(blocks, _)| fits(*blocks)).expect("all fit into the whole square")
}

/// A panel for each level: the boxes that belong there, and faintly those of the other levels.
pub(super) fn levels() -> Result<String> {
    let (least, greatest) = SPEEDS;
    let scene = RandomScene::new(DISCS, SIDE, RADIUS, SEED).with_speeds(least, greatest).draw()?;
    let title = "The grid of three levels: 24 discs and the blocks that their swept boxes fit into";
    let width = GAP + LEVELS.len() as f64 * (PANEL + GAP);
    let mut canvas = Canvas::new(title, width, CAPTION + PANEL + GAP);
    for (index, (blocks, caption)) in LEVELS.iter().enumerate() {
        let left = GAP + index as f64 * (PANEL + GAP);
        let at = |(x, y): Point| {
            let inside = |p: f64| p.clamp(0.0, SIDE) * PANEL / SIDE;
            (left + inside(x), CAPTION + PANEL - inside(y))
        };
        canvas.text((left + PANEL / 2.0, CAPTION - 13.0), 22.0, INK, caption);
        for disc in scene.discs() {
            let (low, high) = swept(disc);
            let here = level((low, high)) == index;
            let ((x, bottom), (right, top)) = (at(low), at(high));
            let style =
                if here { outlined(ORANGE, 1.5).on(PALE_ORANGE) } else { outlined(GREY, 0.8) };
            canvas.rectangle((x, top), right - x, bottom - top, style);
            if here {
                let (from, to) = ((disc.x, disc.y), (disc.x + disc.vx, disc.y + disc.vy));
                canvas.line(at(from), at(to), outlined(BLUE, 1.2));
                let radius = RADIUS * PANEL / SIDE;
                canvas.circle(at(from), radius, outlined(BLUE, 1.2).on(PALE_BLUE));
                canvas.circle(at(to), 2.0, filled(BLUE));
            }
        }
        for k in 1..*blocks as usize {
            let middle = k as f64 * SIDE / blocks;
            canvas.line(at((middle, 0.0)), at((middle, SIDE)), outlined(INK, 1.2));
            canvas.line(at((0.0, middle)), at((SIDE, middle)), outlined(INK, 1.2));
        }
        canvas.rectangle((left, CAPTION), PANEL, PANEL, outlined(INK, 1.5));
    }
    Ok(canvas.svg())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_is_in_the_finest_block_that_holds_it() {
        assert_eq!(level(((1.0, 1.0), (9.0, 9.0))), 0);
        assert_eq!(level(((9.0, 1.0), (11.0, 9.0))), 1, "across an edge of small blocks");
        assert_eq!(level(((1.0, 19.0), (9.0, 21.0))), 2, "across the middle");
        assert_eq!(level(((-3.0, 31.0), (1.0, 44.0))), 0, "beyond the square");
    }
}
