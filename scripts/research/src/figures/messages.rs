//! Two ranks in time: sends that wait for each other, work beside messages, and how seldom lists are made.
//! Not to scale.

use anyhow::Result;

use super::canvas::Canvas;
use super::lanes::{BAR, Span, WIDTH, heading, lane, x};
use super::rows::RANKS;

/// A message: the rank that sends, when it does, and when it arrives.
type Message = (usize, f64, f64);

/// Blocking sends that wait for each other for ever, and the same messages without.
pub(super) fn two_sends() -> Result<String> {
    let title = "Two ranks that both send first wait for each other for ever; receives and sends that are started and then waited for do not";
    let mut canvas = Canvas::new(title, WIDTH, 300.0);
    heading(&mut canvas, 26.0, "blocking: send, then receive");
    let waits = [(0.0, 10.0, "send: waits for the other's receive")];
    lanes(&mut canvas, 44.0, [&waits, &waits], &[]);
    heading(&mut canvas, 172.0, "non-blocking: start both, then wait");
    let starts = [(0.0, 2.2, "start both"), (2.2, 5.6, "wait"), (5.6, 10.0, "goes on")];
    lanes(&mut canvas, 190.0, [&starts, &starts], &[(0, 1.4, 5.4), (1, 1.4, 5.4)]);
    Ok(canvas.svg())
}

/// A step's ghosts: sent while the interior is computed, or before anything is.
pub(super) fn halo() -> Result<String> {
    let title = "Ghosts travel while the interior rows are computed, and the border rows follow; with one collective operation all rows wait for the ghosts";
    let mut canvas = Canvas::new(title, WIDTH, 300.0);
    heading(&mut canvas, 26.0, "halo: interior rows while ghosts travel");
    let first = [
        (0.0, 1.8, "lengths"),
        (1.8, 2.8, "start"),
        (2.8, 6.9, "interior rows"),
        (6.9, 8.9, "border"),
    ];
    let second = [
        (0.0, 1.8, "lengths"),
        (1.8, 2.8, "start"),
        (2.8, 6.5, "interior rows"),
        (6.5, 8.5, "border"),
    ];
    lanes(&mut canvas, 44.0, [&first, &second], &[(0, 2.4, 6.0), (1, 2.4, 6.0)]);
    heading(&mut canvas, 172.0, "alltoallv: ghosts first, then all rows");
    let first = [(0.0, 1.8, "lengths"), (1.8, 4.9, "ghosts"), (4.9, 10.0, "all rows")];
    lanes(&mut canvas, 190.0, [&first, &first], &[(0, 2.2, 4.7), (1, 2.2, 4.7)]);
    Ok(canvas.svg())
}

/// A new list, and a step of those that follow until it is worn out.
pub(super) fn steps_of_a_list() -> Result<String> {
    let title = "When a list is made, movers and ghosts are exchanged; in each step after it only places travel, while inner blocks move";
    let mut canvas = Canvas::new(title, WIDTH, 300.0);
    heading(&mut canvas, 26.0, "once in ten steps: new lists");
    let lists = [(0.0, 2.8, "movers"), (2.8, 6.6, "sort and list"), (6.6, 9.9, "ghosts")];
    lanes(
        &mut canvas,
        44.0,
        [&lists, &lists],
        &[(0, 0.6, 2.6), (1, 0.6, 2.6), (0, 7.2, 9.6), (1, 7.2, 9.6)],
    );
    heading(&mut canvas, 172.0, "each step: places, and no more");
    let first =
        [(0.0, 1.5, "agree"), (1.5, 2.7, "start"), (2.7, 7.4, "inner blocks"), (7.4, 9.4, "outer")];
    let second =
        [(0.0, 1.5, "agree"), (1.5, 2.7, "start"), (2.7, 7.0, "inner blocks"), (7.0, 9.0, "outer")];
    lanes(&mut canvas, 190.0, [&first, &second], &[(0, 2.3, 6.2), (1, 2.3, 6.2)]);
    Ok(canvas.svg())
}

/// A lane for each of two ranks, from `top` on, and the messages between them.
fn lanes(canvas: &mut Canvas, top: f64, spans: [&[Span]; 2], messages: &[Message]) {
    let y = |rank: usize| top + rank as f64 * (BAR + 24.0);
    for (rank, spans) in spans.into_iter().enumerate() {
        lane(canvas, ("rank", rank), y(rank), spans);
    }
    for &(from, sent, arrived) in messages {
        let edge = |rank: usize| if rank == 0 { y(0) + BAR } else { y(1) };
        canvas.arrow((x(sent), edge(from)), (x(arrived), edge(1 - from)), RANKS[from].0);
    }
}
