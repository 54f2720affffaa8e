//! The long list of lab 10, and the short one that is copied from it.

use anyhow::Result;
use oracle::Random;

use super::canvas::{
    BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, Point, filled, outlined,
};

/// How far both lists look, in cutoffs: chosen to be seen, as the places are; not from a run.
const LONG: f64 = 2.8;
const SHORT: f64 = 1.5;

/// Where others are, in cutoffs along each axis.
const FURTHEST: f64 = 3.05;
const OTHERS: usize = 34;
const SEED: u64 = 146;

const SIDE: f64 = 420.0;
/// Pixels of a cutoff.
const SCALE: f64 = 66.0;

/// What the lists of one particle of a crowd hold of what is around it.
pub(super) fn short_in_long() -> Result<String> {
    let title = "Around a particle three circles: the long list reaches furthest, the short list a little beyond the cutoff; few particles are within the cutoff";
    let mut canvas = Canvas::new(title, SIDE, SIDE + 84.0);
    let mut random = Random::new(SEED);
    let mut at_random = || random.between(-FURTHEST, FURTHEST);
    // Its neighbours' places, in cutoffs as seen from it.
    let mut others: Vec<Point> = (0..OTHERS).map(|_| (at_random(), at_random())).collect();
    // What is near is drawn last, over the lines of what is far.
    others.sort_by(|(ax, ay), (bx, by)| bx.hypot(*by).total_cmp(&ax.hypot(*ay)));
    let middle = SIDE / 2.0;
    canvas.circle((middle, middle), LONG * SCALE, outlined(GREY, 1.5).dashed());
    canvas.circle((middle, middle), SHORT * SCALE, outlined(BLUE, 1.5).on(PALE_BLUE).dashed());
    canvas.circle((middle, middle), SCALE, outlined(ORANGE, 1.5).on(PALE_ORANGE));
    let mut counts = [0; 3];
    for (dx, dy) in others {
        let distance = dx.hypot(dy);
        let at = (middle + dx * SCALE, middle - dy * SCALE);
        for (count, reach) in counts.iter_mut().zip([LONG, SHORT, 1.0]) {
            *count += usize::from(distance <= reach);
        }
        let colour = match distance {
            d if d <= 1.0 => ORANGE,
            d if d <= SHORT => BLUE,
            _ => GREY,
        };
        if distance <= LONG {
            canvas.line((middle, middle), at, outlined(colour, 1.5));
        }
        let style = if distance <= LONG { filled(colour) } else { outlined(GREY, 1.5) };
        canvas.circle(at, 5.0, style);
    }
    canvas.circle((middle, middle), 7.0, filled(INK));
    let [long, short, touch] = counts;
    let lines = [
        (GREY, format!("long list, c + s: {long}, kept for several steps")),
        (BLUE, format!("short list, copied from it: {short}")),
        (ORANGE, format!("within c, pushed in this step: {touch}")),
    ];
    for (line, (colour, text)) in lines.into_iter().enumerate() {
        let y = SIDE + 20.0 + 23.0 * line as f64;
        canvas.circle((28.0, y - 5.0), 5.0, filled(colour));
        canvas.text((SIDE / 2.0 + 10.0, y), 15.0, INK, &text);
    }
    Ok(canvas.svg())
}
