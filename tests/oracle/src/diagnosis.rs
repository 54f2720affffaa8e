//! Explanations of mistakes, in the domain's words.

use std::fmt::{self, Display, Formatter};

use common::Vec2;
use common::soft::{CUTOFF, DT, Particle};

use crate::{Model, acceleration_of_pair};

/// A particle with a wrong position or velocity.
#[derive(Debug)]
pub(crate) struct Mistake {
    id: usize,
    bin: (i64, i64),
    found: Particle,
    expected: Particle,
    cause: Cause,
}

#[derive(Debug)]
enum Cause {
    /// The particle was not written into the buffer.
    Lost,
    /// The particle at this index has a different id.
    WrongId(u32),
    /// The particle left the box, or has NaN coordinates.
    Outside,
    /// One pair explains the difference exactly.
    Pair { other: usize, distance: f64, direction: &'static str, what: &'static str },
    /// No force acted on the particle.
    NoForce { neighbours: usize },
    /// The particle did not move.
    DidNotMove,
    /// The velocity is correct and the position is wrong.
    Position,
    /// The particle reached a wall, and its velocity is correct except for the sign.
    Sign,
    /// The force is correct except for the sign.
    Attracted { expected: Vec2 },
    /// The force is wrong in a different way.
    Force { expected: Vec2, found: Vec2, neighbours: usize },
}

impl Mistake {
    pub(crate) fn explain(model: &Model, before: &[Particle], found: Particle, id: usize) -> Self {
        let bin = |x: f64| (x / CUTOFF).floor() as i64;
        Self {
            id,
            bin: (bin(before[id].x), bin(before[id].y)),
            found,
            expected: model.particles[id],
            cause: Cause::of(model, before, found, id),
        }
    }
}

impl Cause {
    fn of(model: &Model, before: &[Particle], found: Particle, id: usize) -> Self {
        let (start, expected) = (before[id], model.particles[id]);
        if found.x.is_nan() && found.id == u32::MAX {
            return Self::Lost;
        }
        if found.id as usize != id {
            return Self::WrongId(found.id);
        }
        let inside = |x: f64| (0.0..=model.size).contains(&x);
        if !inside(found.x) || !inside(found.y) || !(found.vx + found.vy).is_finite() {
            return Self::Outside;
        }
        let a = model.accelerations[id];
        let scale = model.magnitudes[id];
        let near = |p: f64, q: f64| (p - q).abs() <= 1e-9 * (1.0 + DT * scale);
        if near(found.vx.abs(), expected.vx.abs()) && near(found.vy.abs(), expected.vy.abs()) {
            let right = near(found.vx, expected.vx) && near(found.vy, expected.vy);
            let (vx, vy) = (start.vx + a.x * DT, start.vy + a.y * DT);
            let at_wall = !inside(start.x + vx * DT) || !inside(start.y + vy * DT);
            if (found.x, found.y) == (start.x, start.y) {
                return Self::DidNotMove;
            } else if right {
                return Self::Position;
            } else if at_wall {
                return Self::Sign;
            }
        }
        // Undoing reflections shows the acceleration that the program must have used.
        let undone = |expected: f64, start: f64, a: f64, found: f64| {
            let free = start + a * DT;
            let sign = if (expected - free).abs() <= (expected + free).abs() { 1.0 } else { -1.0 };
            (sign * found - start) / DT
        };
        let used = Vec2::new(
            undone(expected.vx, start.vx, a.x, found.vx),
            undone(expected.vy, start.vy, a.y, found.vy),
        );
        let same = |p: Vec2, q: Vec2, size: f64| {
            (p - q).norm_squared().sqrt() <= 1e-6 * size + 1e-9 * scale
        };
        let mut neighbours = 0;
        let mut pair = None;
        for (other, neighbour) in before.iter().enumerate().filter(|&(other, _)| other != id) {
            let d = start.to(neighbour);
            let distance = d.norm_squared().sqrt();
            if distance > CUTOFF {
                continue;
            }
            neighbours += 1;
            let part = acceleration_of_pair(d.x, d.y);
            let size = part.norm_squared().sqrt();
            let what = if same(used, a - part, size) {
                "was missed"
            } else if same(used, a + part, size) {
                "was counted twice"
            } else {
                continue;
            };
            pair = Some(Self::Pair { other, distance, direction: direction(d), what });
        }
        match pair {
            Some(pair)
                if neighbours > 1 || matches!(pair, Self::Pair { what: "was missed", .. }) =>
            {
                pair
            }
            _ if neighbours > 0 && same(used, Vec2::ZERO, scale) => Self::NoForce { neighbours },
            None if same(used, -a, a.norm_squared().sqrt()) => Self::Attracted { expected: a },
            Some(pair) => pair,
            None => Self::Force { expected: a, found: used, neighbours },
        }
    }
}

impl Display for Mistake {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { id, bin, found, expected, .. } = self;
        write!(f, "particle {id}, bin ({}, {}): ", bin.0, bin.1)?;
        match &self.cause {
            Cause::Lost => write!(f, "it is lost; no particle with its id was read back"),
            Cause::WrongId(other) => write!(f, "particle {other} is at its index"),
            Cause::Outside => write!(
                f,
                "it left the box, or one of its numbers is NaN or infinite: x = {}, y = {}, vx = {}, vy = {}",
                found.x, found.y, found.vx, found.vy
            ),
            Cause::Pair { other, distance, direction, what } => write!(
                f,
                "the pair with particle {other}, {:.4} cutoffs away {direction}, {what}",
                distance / CUTOFF
            ),
            Cause::NoForce { neighbours } => {
                write!(f, "no force acted on it, but it has {}", counted(*neighbours))
            }
            Cause::DidNotMove => write!(f, "its velocity changed and it did not move"),
            Cause::Position => write!(
                f,
                "its velocity is right but it is at ({}, {}), not at ({}, {})",
                found.x, found.y, expected.x, expected.y
            ),
            Cause::Sign => write!(
                f,
                "its velocity is ({}, {}), not ({}, {}): look at the walls and at the force's sign",
                found.vx, found.vy, expected.vx, expected.vy
            ),
            Cause::Attracted { expected } => write!(
                f,
                "it was accelerated towards its neighbours; it must be accelerated away from them, by ({:.9e}, \
                 {:.9e})",
                expected.x, expected.y
            ),
            Cause::Force { expected, found, neighbours } => write!(
                f,
                "it was accelerated by ({:.9e}, {:.9e}), not by ({:.9e}, {:.9e}): it has {}",
                found.x,
                found.y,
                expected.x,
                expected.y,
                counted(*neighbours)
            ),
        }
    }
}

fn counted(neighbours: usize) -> String {
    match neighbours {
        1 => "one neighbour".into(),
        _ => format!("{neighbours} neighbours"),
    }
}

/// Names the direction of a neighbour, with x to the right and y upwards.
fn direction(d: Vec2) -> &'static str {
    let side = |v: f64, other: f64| match v {
        _ if v.abs() < 0.4 * other.abs() || v == 0.0 => 0,
        _ if v > 0.0 => 1,
        _ => -1,
    };
    match (side(d.x, d.y), side(d.y, d.x)) {
        (1, 0) => "to the right",
        (-1, 0) => "to the left",
        (0, 1) => "above",
        (0, -1) => "below",
        (1, 1) => "to the upper right",
        (1, -1) => "to the lower right",
        (-1, 1) => "to the upper left",
        (-1, -1) => "to the lower left",
        _ => "at the same position",
    }
}
