//! The greedy-step model, written from its rules and not from the labs.

use common::hard::Disc;

/// The obstacle of a collision.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum What {
    /// Two walls at once.
    Corner,
    /// The left or right wall.
    WallX,
    /// The lower or upper wall.
    WallY,
    /// Another disc, with this number.
    Disc(usize),
}

/// A collision of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Time of the collision, 0 to 1.
    pub time: f64,
    /// Number of the disc, the lower of two.
    pub disc: usize,
    /// The obstacle.
    pub what: What,
}

impl Event {
    /// Returns whether disc number `i` takes part.
    pub fn involves(&self, i: usize) -> bool {
        self.disc == i || self.what == What::Disc(i)
    }
}

/// Returns the earliest λ in 0 .. 1 at which two discs touch. `apart` is the position of b relative
/// to a, `closing` the velocity of b relative to a.
pub fn first_touch(apart: [f64; 2], closing: [f64; 2], radius: f64) -> Option<f64> {
    let [px, py] = apart;
    let [ux, uy] = closing;
    let rate = px * ux + py * uy;
    if rate >= 0.0 {
        return None;
    }
    let gap = (px * px + py * py) - 4.0 * radius * radius;
    let same_position = px == 0.0 && py == 0.0;
    if gap <= 0.0 && !same_position {
        return Some(0.0);
    }
    let turn = px * uy - py * ux;
    let under_root = 4.0 * radius * radius * (ux * ux + uy * uy) - turn * turn;
    if under_root > 0.0 {
        let time = gap / (under_root.sqrt() - rate);
        if time < 1.0 {
            return Some(time);
        }
    }
    None
}

/// Returns the time at which a coordinate that moves by `v` in the step would go beyond `low` or
/// `high`.
fn reaches_wall(x: f64, v: f64, low: f64, high: f64) -> Option<f64> {
    let bound = match x + v {
        end if end < low => low,
        end if end > high => high,
        _ => return None,
    };
    Some(((bound - x) / v).clamp(0.0, 1.0))
}

/// Returns all collisions that could happen in the step, in the order in which they are considered.
pub fn possible(discs: &[Disc], side: f64, radius: f64) -> Vec<Event> {
    let (low, high) = (radius, side - radius);
    let mut events = Vec::new();
    for (i, a) in discs.iter().enumerate() {
        let x = reaches_wall(a.x, a.vx, low, high).map(|time| (time, What::WallX));
        let y = reaches_wall(a.y, a.vy, low, high).map(|time| (time, What::WallY));
        let wall = match (x, y) {
            (Some(x), Some(y)) if x.0 == y.0 => Some((x.0, What::Corner)),
            (Some(x), Some(y)) => Some(if x.0 < y.0 { x } else { y }),
            (x, y) => x.or(y),
        };
        events.extend(wall.map(|(time, what)| Event { time, disc: i, what }));
        for (j, b) in discs.iter().enumerate().skip(i + 1) {
            let touch = first_touch([b.x - a.x, b.y - a.y], [b.vx - a.vx, b.vy - a.vy], radius);
            events.extend(touch.map(|time| Event { time, disc: i, what: What::Disc(j) }));
        }
    }
    let rank = |e: &Event| match e.what {
        What::Corner => (0, e.disc, 0),
        What::WallX => (1, e.disc, 0),
        What::WallY => (2, e.disc, 0),
        What::Disc(j) => (3, e.disc, j),
    };
    events.sort_by(|a, b| {
        a.time.partial_cmp(&b.time).expect("times are numbers").then_with(|| rank(a).cmp(&rank(b)))
    });
    events
}

/// Takes one step. Returns the discs at its end, and the collisions that happened, in order.
pub fn step(discs: &[Disc], side: f64, radius: f64) -> (Vec<Disc>, Vec<Event>) {
    let mut busy = vec![false; discs.len()];
    let mut happened = Vec::new();
    for event in possible(discs, side, radius) {
        let other = if let What::Disc(j) = event.what { j } else { event.disc };
        if !busy[event.disc] && !busy[other] {
            busy[event.disc] = true;
            busy[other] = true;
            happened.push(event);
        }
    }

    let mut after = discs.to_vec();
    for (disc, busy) in after.iter_mut().zip(&busy) {
        if !busy {
            fly(disc, 1.0);
        }
    }
    for event in &happened {
        let (i, rest) = (event.disc, 1.0 - event.time);
        fly(&mut after[i], event.time);
        match event.what {
            What::Disc(j) => {
                fly(&mut after[j], event.time);
                let (mut a, mut b) = (after[i], after[j]);
                swap_normal_components(&mut a, &mut b);
                for disc in [&mut a, &mut b] {
                    disc.pair_collisions += 1;
                    fly(disc, rest);
                    wait_at_wall(disc, radius, side - radius);
                }
                (after[i], after[j]) = (a, b);
            }
            wall => {
                let disc = &mut after[i];
                if wall != What::WallY {
                    disc.vx *= -1.0;
                }
                if wall != What::WallX {
                    disc.vy *= -1.0;
                }
                disc.wall_collisions += 1;
                fly(disc, rest);
                wait_at_wall(disc, radius, side - radius);
            }
        }
    }
    (after, happened)
}

fn fly(disc: &mut Disc, time: f64) {
    disc.x += disc.vx * time;
    disc.y += disc.vy * time;
}

/// Exchanges the velocity components along the line of centres of two discs of equal mass.
pub(super) fn swap_normal_components(a: &mut Disc, b: &mut Disc) {
    let (nx, ny) = (b.x - a.x, b.y - a.y);
    let n2 = nx * nx + ny * ny;
    if n2 == 0.0 {
        return;
    }
    let share = ((b.vx - a.vx) * nx + (b.vy - a.vy) * ny) / n2;
    a.vx += share * nx;
    a.vy += share * ny;
    b.vx -= share * nx;
    b.vy -= share * ny;
}

/// Moves a disc that is beyond a wall back along its path.
pub fn wait_at_wall(disc: &mut Disc, low: f64, high: f64) {
    let mut back: f64 = 0.0;
    for (x, v) in [(disc.x, disc.vx), (disc.y, disc.vy)] {
        let bound = if x < low { low } else { high };
        if x < low || x > high {
            let time = (x - bound) / v;
            // A longer time means that the disc is beyond the wall only by rounding.
            if time <= 2.0 {
                back = back.max(time);
            }
        }
    }
    disc.x -= back * disc.vx;
    disc.y -= back * disc.vy;
}
