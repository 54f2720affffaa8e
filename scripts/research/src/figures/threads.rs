//! Two threads: a step with change buffers and barriers, and counters on cache lines.

use anyhow::Result;

use super::canvas::{Canvas, GREY, INK, ORANGE, Point, outlined};
use super::lanes::{BAR, WIDTH, heading, lane, x};
use super::rows::RANKS;

/// A place in a buffer or on a cache line.
const CELL: f64 = 26.0;

/// A step of two threads: each fills a buffer of its own, and empties both when all have come.
pub(super) fn step_with_buffers() -> Result<String> {
    const LANES: [f64; 2] = [64.0, 206.0];
    let title = "A step of two threads: forces, a barrier, moves that fill a buffer of each thread, a barrier, and each thread takes what is its own from both buffers";
    let mut canvas = Canvas::new(title, WIDTH, 270.0);
    heading(&mut canvas, 22.0, "noted before a barrier, taken after it");
    let spans = [
        [(0.0, 2.6, "forces"), (2.7, 5.4, "move, note"), (6.3, 8.7, "take")],
        [(0.0, 2.2, "forces"), (2.7, 6.1, "move, note"), (6.3, 9.3, "take")],
    ];
    for barrier in [2.65, 6.2, 9.4] {
        let (above, below) = (LANES[0] - 8.0, LANES[1] + BAR + 8.0);
        canvas.line((x(barrier), above), (x(barrier), below), outlined(INK, 2.0).dashed());
        canvas.text((x(barrier), above - 6.0), 14.0, INK, "barrier");
    }
    for thread in 0..2 {
        lane(&mut canvas, ("thread", thread), LANES[thread], &spans[thread]);
    }
    let buffers: [(&[u32], f64); 2] =
        [(&[7, 12], LANES[0] + BAR + 14.0), (&[3], LANES[1] - CELL - 14.0)];
    for (thread, (noted, y)) in buffers.into_iter().enumerate() {
        let left = x(3.7);
        buffer(&mut canvas, (left, y), thread, noted);
        let from = (left + 4.0 * CELL, y + CELL / 2.0);
        let to = if thread == 0 { [7.0, 7.6] } else { [7.6, 7.0] };
        canvas.arrow(from, (x(to[0]), LANES[0] + BAR + 2.0), RANKS[0].0);
        canvas.arrow(from, (x(to[1]), LANES[1] - 2.0), RANKS[1].0);
    }
    Ok(canvas.svg())
}

/// A buffer of four places, from its upper left corner on, with the particles that are noted down in it.
fn buffer(canvas: &mut Canvas, (left, y): Point, thread: usize, noted: &[u32]) {
    let (colour, tint) = RANKS[thread];
    for at in 0..4 {
        let corner = (left + f64::from(at) * CELL, y);
        let fill = if (at as usize) < noted.len() { tint } else { "#ffffff" };
        canvas.rectangle(corner, CELL, CELL, outlined(colour, 1.0).on(fill));
    }
    for (at, particle) in noted.iter().enumerate() {
        let middle = (left + (at as f64 + 0.5) * CELL, y + 18.0);
        canvas.text(middle, 14.0, INK, &particle.to_string());
    }
}

/// Two counters on one cache line, and with a line for each.
pub(super) fn cache_lines() -> Result<String> {
    const LINE: f64 = 8.0 * CELL;
    let title = "Two counters on one cache line: each write takes the line from the other core. With a line for each counter no line travels";
    let mut canvas = Canvas::new(title, WIDTH, 250.0);
    let panels = [("packed: the line travels", [0, 1], 1), ("padded: a line each", [0, 8], 2)];
    for (panel, (name, slots, lines)) in panels.into_iter().enumerate() {
        let left = 20.0 + panel as f64 * (WIDTH / 2.0);
        let middle = left + LINE / 2.0 + 6.0;
        canvas.text((middle, 24.0), 17.0, INK, name);
        for (thread, slot) in slots.into_iter().enumerate() {
            let (colour, tint) = RANKS[thread];
            let core = (middle - 50.0 + 100.0 * thread as f64, 66.0);
            canvas.rectangle((core.0 - 40.0, 42.0), 80.0, 30.0, outlined(colour, 1.5).on(tint));
            canvas.text((core.0, core.1 - 3.0), 15.0, INK, &format!("thread {thread}"));
            let (line, at) = (slot / 8, slot % 8);
            let top = 150.0 + 44.0 * f64::from(line);
            let place = (left + f64::from(at) * CELL, top);
            canvas.rectangle(place, CELL, CELL, outlined(colour, 1.5).on(tint));
            canvas.arrow((core.0, 74.0), (place.0 + CELL / 2.0, top - 3.0), colour);
        }
        for line in 0..lines {
            let top = 150.0 + 44.0 * f64::from(line);
            for at in 0..8 {
                let corner = (left + f64::from(at) * CELL, top);
                canvas.rectangle(corner, CELL, CELL, outlined(GREY, 0.8));
            }
            let edge = if lines == 1 { outlined(ORANGE, 3.0) } else { outlined(INK, 2.0) };
            canvas.rectangle((left, top), LINE, CELL, edge);
        }
    }
    canvas.text((WIDTH / 2.0, 238.0), 15.0, INK, "a row: one line of 64 bytes, eight numbers");
    Ok(canvas.svg())
}
