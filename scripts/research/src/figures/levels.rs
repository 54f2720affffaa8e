//! Lab 7's grid of three levels, and which level the discs of a small scene are in.

use anyhow::Result;
use common::hard::RandomScene;

use super::canvas::{
    BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, Panel, Point, filled, outlined,
};
use super::swept::{Corners, draw, swept};

const DISCS: u64 = 24;
const SIDE: f64 = 40.0;
const RADIUS: f64 = 0.7;
const SPEEDS: (f64, f64) = (1.0, 6.0);
const SEED: u32 = 5;

/// Blocks along a side, and the caption.
const LEVELS: [(f64, &str); 3] =
    [(4.0, "small blocks"), (2.0, "medium blocks"), (1.0, "the whole square")];

const PIXELS: f64 = 270.0;
const GAP: f64 = 24.0;
const CAPTION: f64 = 40.0;

/// The finest level with a block that a box fits into. What lies beyond the square counts to the
/// outermost blocks.
fn level((low, high): Corners) -> usize {
    let fits = |blocks: f64| {
        let block = |at: f64| (at / SIDE * blocks).floor().clamp(0.0, blocks - 1.0);
        block(low.0) == block(high.0) && block(low.1) == block(high.1)
    };
    LEVELS.iter().position(|(blocks, _)| fits(*blocks)).expect("all fit into the whole square")
}

/// A panel for each level: the boxes that belong there, and faintly those of the other levels.
pub(super) fn levels() -> Result<String> {
    let (least, greatest) = SPEEDS;
    let scene = RandomScene::new(DISCS, SIDE, RADIUS, SEED).with_speeds(least, greatest).draw()?;
    let title = "The grid of three levels: 24 discs and the blocks that their swept boxes fit into";
    let width = GAP + LEVELS.len() as f64 * (PIXELS + GAP);
    let mut canvas = Canvas::new(title, width, CAPTION + PIXELS + GAP);
    for (index, (blocks, caption)) in LEVELS.iter().enumerate() {
        let left = GAP + index as f64 * (PIXELS + GAP);
        let panel = Panel { left, top: CAPTION, pixels: PIXELS, side: SIDE };
        let at = |(x, y): Point| panel.at((x.clamp(0.0, SIDE), y.clamp(0.0, SIDE)));
        panel.text(&mut canvas, -13.0, 22.0, caption);
        for disc in scene.discs() {
            let swept = swept(disc, RADIUS, (0.0, 1.0));
            if level(swept) != index {
                draw(&mut canvas, &panel, swept, outlined(GREY, 0.8));
                continue;
            }
            draw(&mut canvas, &panel, swept, outlined(ORANGE, 1.5).on(PALE_ORANGE));
            let (from, to) = ((disc.x, disc.y), (disc.x + disc.vx, disc.y + disc.vy));
            canvas.line(at(from), at(to), outlined(BLUE, 1.2));
            canvas.circle(at(from), panel.long(RADIUS), outlined(BLUE, 1.2).on(PALE_BLUE));
            canvas.circle(at(to), 2.0, filled(BLUE));
        }
        for k in 1..*blocks as usize {
            let middle = k as f64 * SIDE / blocks;
            canvas.line(at((middle, 0.0)), at((middle, SIDE)), outlined(INK, 1.2));
            canvas.line(at((0.0, middle)), at((SIDE, middle)), outlined(INK, 1.2));
        }
        panel.frame(&mut canvas, outlined(INK, 1.5));
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
