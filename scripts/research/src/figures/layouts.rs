//! The same bins in memory twice: lists that run through the particles' numbers, and one sorted array.

use anyhow::Result;

use super::canvas::{Canvas, GREY, INK, Point, outlined};
use super::rows::RANKS;

const WIDTH: f64 = 520.0;
const CELL: f64 = 44.0;
/// Where arrays begin, right of their names.
const LEFT: f64 = 140.0;

/// The bin of each particle.
const BINS: [usize; 7] = [1, 3, 0, 1, 3, 3, 1];
const COUNT: usize = 4;

/// Where particles lie in their bin, in shares of its side.
const PLACES: [Point; 7] =
    [(0.3, 0.3), (0.25, 0.7), (0.5, 0.5), (0.7, 0.45), (0.7, 0.72), (0.55, 0.28), (0.35, 0.75)];

/// Seven particles in four bins, as a linked list and as a counting sort.
pub(super) fn layouts() -> Result<String> {
    let title = "Seven particles in four bins, in memory: as lists with heads and next, and sorted by counting: count, sum, place";
    let mut canvas = Canvas::new(title, WIDTH, 520.0);
    boxes(&mut canvas, 14.0);
    lists(&mut canvas, 158.0);
    sorted(&mut canvas, 340.0);
    Ok(canvas.svg())
}

fn boxes(canvas: &mut Canvas, top: f64) {
    const SIDE: f64 = 96.0;
    let left = (WIDTH - COUNT as f64 * SIDE) / 2.0;
    for (bin, (colour, tint)) in RANKS.into_iter().enumerate() {
        let corner = (left + bin as f64 * SIDE, top);
        canvas.rectangle(corner, SIDE, SIDE, outlined(colour, 1.5).on(tint));
        canvas.text((corner.0 + SIDE / 2.0, top + SIDE + 18.0), 15.0, INK, &format!("bin {bin}"));
    }
    for (particle, (bin, (x, y))) in BINS.into_iter().zip(PLACES).enumerate() {
        let place = (left + (bin as f64 + x) * SIDE, top + y * SIDE);
        canvas.circle(place, 11.0, outlined(RANKS[bin].0, 1.5).on("#ffffff"));
        canvas.text((place.0, place.1 + 5.0), 14.0, INK, &particle.to_string());
    }
}

/// Each particle goes in front of the others of its bin.
fn lists(canvas: &mut Canvas, top: f64) {
    let (mut head, mut next) = ([None; COUNT], [None; BINS.len()]);
    for (particle, bin) in BINS.into_iter().enumerate() {
        next[particle] = head[bin].replace(particle);
    }
    canvas.text(
        (WIDTH / 2.0, top),
        17.0,
        INK,
        "lists: the first of each bin, the next of each particle",
    );
    let shown = |item: &Option<usize>| item.map_or("–".into(), |particle| particle.to_string());
    array(canvas, top + 34.0, "head of bin", head.iter().map(shown).enumerate().collect(), true);
    let next = BINS.into_iter().zip(next.iter().map(shown)).collect();
    array(canvas, top + 102.0, "next of particle", next, true);
}

/// Count, sum, place.
fn sorted(canvas: &mut Canvas, top: f64) {
    let mut count = [0; COUNT];
    BINS.into_iter().for_each(|bin| count[bin] += 1);
    let start: [usize; COUNT] = std::array::from_fn(|bin| count[..bin].iter().sum());
    let mut order: Vec<usize> = (0..BINS.len()).collect();
    order.sort_by_key(|&particle| BINS[particle]);
    canvas.text((WIDTH / 2.0, top), 17.0, INK, "sorted: count, sum, place");
    let numbers = |of: [usize; COUNT]| of.iter().map(ToString::to_string).enumerate().collect();
    array(canvas, top + 18.0, "count of bin", numbers(count), false);
    array(canvas, top + 70.0, "start of bin", numbers(start), false);
    let placed = order.iter().map(|&particle| (BINS[particle], particle.to_string())).collect();
    array(canvas, top + 122.0, "particles", placed, false);
}

/// Cells beside each other in the colours of their bins, with their numbers above if they are asked for.
fn array(canvas: &mut Canvas, top: f64, name: &str, cells: Vec<(usize, String)>, numbered: bool) {
    canvas.text((LEFT / 2.0, top + 28.0), 15.0, INK, name);
    for (at, (bin, text)) in cells.iter().enumerate() {
        let (colour, tint) = RANKS[*bin];
        let x = LEFT + at as f64 * CELL;
        if numbered {
            canvas.text((x + CELL / 2.0, top - 5.0), 12.0, GREY_TEXT, &at.to_string());
        }
        canvas.rectangle((x, top), CELL, CELL, outlined(colour, 1.5).on(tint));
        canvas.text((x + CELL / 2.0, top + 28.0), 17.0, INK, text);
    }
    let end = LEFT + cells.len() as f64 * CELL;
    canvas.line((LEFT, top + CELL), (end, top + CELL), outlined(GREY, 1.0));
}

/// Dark enough to be read on white.
const GREY_TEXT: &str = "#636b74";
