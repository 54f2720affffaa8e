//! Regions of bins under locks, and a pair across the cut between two threads.

use anyhow::Result;

use super::canvas::{Canvas, GREY, INK, Point, filled, outlined};
use super::rows::RANKS;

const WIDTH: f64 = 520.0;
const BIN: f64 = 38.0;
const LEFT: f64 = (WIDTH - 12.0 * BIN) / 2.0;

/// Twelve bins in regions of five: three threads, two of them at one lock.
pub(super) fn locks() -> Result<String> {
    const TOP: f64 = 150.0;
    let title = "Twelve bins in three regions, a lock each: thread 0 is in region 1, thread 1 waits for it, thread 2 is in region 2";
    let mut canvas = Canvas::new(title, WIDTH, 262.0);
    // Which thread has the lock of each.
    let regions = [(0, 5, None), (5, 5, Some(0)), (10, 2, Some(2))];
    for (region, (first, bins, holder)) in regions.into_iter().enumerate() {
        let (left, width) = (LEFT + f64::from(first) * BIN, f64::from(bins) * BIN);
        let (line, fill) = holder.map_or((INK, "#ffffff"), |thread: usize| RANKS[thread]);
        for bin in first..first + bins {
            let corner = (LEFT + f64::from(bin) * BIN, TOP);
            canvas.rectangle(corner, BIN, BIN, outlined(GREY, 1.0).on(fill));
            canvas.text((corner.0 + BIN / 2.0, TOP + 24.0), 15.0, INK, &bin.to_string());
        }
        canvas.rectangle((left, TOP), width, BIN, outlined(line, 2.5));
        let middle = left + width / 2.0;
        lock(&mut canvas, (middle, TOP + BIN + 26.0), line, holder.is_some());
        canvas.text((middle, TOP + BIN + 58.0), 14.0, INK, &format!("region {region}"));
    }
    for (thread, bin, says, waits) in
        [(0, 6, "writes", false), (1, 8, "waits", true), (2, 10, "writes", false)]
    {
        let (colour, tint) = RANKS[thread];
        let to = (LEFT + (f64::from(bin) + 0.5) * BIN, TOP - 4.0);
        let from = (90.0 + 170.0 * thread as f64, 62.0);
        canvas.rectangle((from.0 - 60.0, 16.0), 120.0, 46.0, outlined(colour, 1.5).on(tint));
        canvas.text((from.0, 35.0), 15.0, INK, &format!("thread {thread}"));
        canvas.text((from.0, 54.0), 15.0, INK, says);
        if waits {
            let short = (from.0 + 0.7 * (to.0 - from.0), from.1 + 0.7 * (to.1 - from.1));
            canvas.line(from, short, outlined(colour, 2.5).dashed());
            canvas.line((short.0 - 12.0, short.1), (short.0 + 12.0, short.1), outlined(INK, 3.0));
        } else {
            canvas.arrow(from, to, colour);
        }
    }
    Ok(canvas.svg())
}

/// A padlock, shut or open.
fn lock(canvas: &mut Canvas, (x, y): Point, colour: &'static str, is_held: bool) {
    let lift = if is_held { 0.0 } else { 5.0 };
    canvas.circle((x, y - 6.0 - lift), 6.0, outlined(colour, 2.0));
    canvas.rectangle((x - 9.0, y - 6.0), 18.0, 14.0, filled(colour));
}
