//! Comparisons of discs: up to rounding after one step, and bitwise.

use common::hard::{Disc, Scene};

use super::model::{Event, What, step};

/// Returns the greatest difference between two correct programs after one step from the same state.
fn limit(before: &[Disc], scene: &Scene) -> f64 {
    let fastest = before.iter().map(|d| d.vx.abs().max(d.vy.abs())).fold(0.0, f64::max);
    1e-14 * scene.side() * (1.0 + fastest / scene.radius())
}

/// Describes the error in `found`, the discs after a step of `scene` from `before`. `None` if there
/// is no error.
pub fn one_step(before: &[Disc], found: &[Disc], scene: &Scene) -> Option<String> {
    let (expected, events) = step(before, scene.side(), scene.radius());
    let limit = limit(before, scene);
    let wrong = |(e, f): (&Disc, &Disc)| {
        let near = |a: f64, b: f64| (a - b).abs() <= limit;
        !(near(e.x, f.x) && near(e.y, f.y) && near(e.vx, f.vx) && near(e.vy, f.vy))
            || (e.pair_collisions, e.wall_collisions) != (f.pair_collisions, f.wall_collisions)
    };
    // If several discs are wrong, the disc with the earliest collision is the most informative.
    let i = (0..expected.len())
        .filter(|&i| wrong((&expected[i], &found[i])))
        .min_by(|&i, &j| time_of(&events, i).total_cmp(&time_of(&events, j)))?;
    let (e, f) = (&expected[i], &found[i]);
    Some(format!(
        "disc {i} {}. It must end at {}, but ends at {}",
        happening(&events, i),
        describe(e),
        describe(f)
    ))
}

fn time_of(events: &[Event], i: usize) -> f64 {
    events.iter().find(|e| e.involves(i)).map_or(2.0, |e| e.time)
}

fn happening(events: &[Event], i: usize) -> String {
    let Some(event) = events.iter().find(|e| e.involves(i)) else {
        return "collides with nothing, so it flies straight on".into();
    };
    let time = event.time;
    match event.what {
        What::Corner => format!("hits a corner at λ = {time:?}"),
        What::WallX => format!("hits the left or right wall at λ = {time:?}"),
        What::WallY => format!("hits the lower or upper wall at λ = {time:?}"),
        What::Disc(j) => {
            let other = if event.disc == i { j } else { event.disc };
            format!("collides with disc {other} at λ = {time:?}")
        }
    }
}

fn describe(d: &Disc) -> String {
    format!(
        "({:?}, {:?}) with velocity ({:?}, {:?}), {} pair and {} wall collisions",
        d.x, d.y, d.vx, d.vy, d.pair_collisions, d.wall_collisions
    )
}

/// Describes the first disc whose bits differ in two runs. `None` if all bits agree.
pub fn difference(expected: &[Disc], found: &[Disc]) -> Option<String> {
    let bits =
        |d: &Disc| ([d.x, d.y, d.vx, d.vy].map(f64::to_bits), d.pair_collisions, d.wall_collisions);
    let i = expected.iter().zip(found).position(|(e, f)| bits(e) != bits(f))?;
    Some(format!(
        "disc {i} is at {}, but must be at {}",
        describe(&found[i]),
        describe(&expected[i])
    ))
}
