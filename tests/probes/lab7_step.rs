//! A step of lab 7's engine.
//!
//! The engine is given a finder by the probe, one that computes its pairs itself. Rivals for a disc
//! fall into different windows, no disc meets a corner, a disc that ends beyond a wall flies straight at it,
//! and collisions are not counted: what is asked is the step, and not the order of candidates in a window.

use common::hard::{Disc, Scene, Simulation};
use hard_discs::{Candidate, Choice, Engine, Find, Found, Hit, Square, Window, Workers};
use lab7::Lab7;

use super::model::first_touch;
use crate::{Answers, Random};

/// Looks at all pairs, and says in how many windows it wants the step.
struct Finder {
    windows: usize,
    /// What it was asked: the windows, and how many discs were free in each.
    asked: Vec<[f64; 3]>,
}

impl Find for &mut Finder {
    fn windows(&mut self, _discs: &[Disc], _square: Square) -> usize {
        self.windows
    }

    fn find(
        &mut self,
        discs: &[Disc],
        free: &[bool],
        square: Square,
        window: Window,
        found: &mut Found,
    ) {
        let count = free.iter().filter(|free| **free).count();
        self.asked.push([window.from, window.to.min(9.0), count as f64]);
        found.clear(1);
        for b in 0..discs.len() {
            for a in (0..b).filter(|a| free[*a] && free[b]) {
                let d = discs[b].position() - discs[a].position();
                let v = discs[b].velocity() - discs[a].velocity();
                let time = first_touch([d.x, d.y], [v.x, v.y], square.radius);
                if let Some(time) = time.filter(|time| window.contains(*time)) {
                    let hit = Hit::Pair(a as u32, b as u32);
                    found.lists[0].push(Candidate { time, hit });
                }
            }
        }
    }
}

/// Side of the part of the square that each event has for itself.
const ROOM: f64 = 40.0;
const ROOMS: usize = 8;

/// Discs of radius 1, some in each of 8 × 8 rooms.
fn scene(random: &mut Random) -> Scene {
    let side = ROOM * ROOMS as f64;
    let mut discs = Vec::new();
    for room in 0..ROOMS * ROOMS {
        let (column, row) = (room % ROOMS, room / ROOMS);
        let (x, y) = ((column as f64 + 0.5) * ROOM, (row as f64 + 0.5) * ROOM);
        let jitter = random.between(-0.5, 0.5);
        let mut add = |x: f64, y: f64, vx: f64, vy: f64| discs.push(Disc::new(x, y, vx, vy));
        match (column, row) {
            // Beside the left wall: it is hit at λ = 0.52 to 0.9.
            (0, 1..7) => {
                let v = random.between(4.0, 8.0);
                let x = 1.0 + v * random.between(0.52, 0.9);
                add(x, y, -v, 0.0);
                if row % 2 == 0 {
                    // Another runs straight into it from behind, and is first.
                    add(x + 2.0 + 5.0 * random.between(0.05, 0.4), y, -v - 5.0, 0.0);
                }
            }
            // Below the upper wall: it is hit early.
            (1..7, 7) => add(x, side - 1.0 - random.between(0.1, 1.5), jitter, 5.0),
            // Two run into each other.
            _ if (2..6).contains(&column) && (1..6).contains(&row) => {
                add(x - 5.0, y + jitter, 5.0, 0.3);
                add(x + 5.0, y - jitter, -random.between(3.5, 6.0), -0.2);
            }
            // Two run into each other at exactly λ = 0.5, where a window begins.
            (6, 1..7) => {
                add(x - 5.0, y, 8.0, 0.0);
                add(x + 5.0, y, -8.0, 0.0);
            }
            _ => add(x, y, jitter, random.between(-3.0, 3.0)),
        }
    }
    random.shuffle(&mut discs);
    Scene::new(side, 1.0, discs).expect("all are inside")
}

/// Several steps of a disc alone, and of two that meet far from all walls.
fn several(random: &mut Random, answers: &mut Answers) {
    let speed = random.between(2.5, 3.5);
    let two = vec![Disc::new(495.0, 500.0, speed, 0.0), Disc::new(505.0, 500.0, -speed, 0.0)];
    for (name, side, discs) in [
        ("a disc alone in a square of 10", 10.0, vec![Disc::new(4.0, 5.0, speed, 0.0)]),
        ("two discs in a square of 1000", 1000.0, two),
    ] {
        let scene = Scene::new(side, 1.0, discs).expect("all are inside");
        let mut finder = Finder { windows: 2, asked: Vec::new() };
        let mut engine = Engine::<Lab7, _>::new(&mut finder, Choice::Sort, Workers::One);
        engine.load(&scene);
        let mut discs = vec![Disc::default(); scene.len()];
        for step in 1..=6 {
            engine.step();
            engine.read(0, &mut discs);
            let state: Vec<f64> = discs.iter().flat_map(|d| [d.x, d.y, d.vx, d.vy]).collect();
            answers.close(&format!("{name}, step {step}: x y vx vy of each"), &state);
        }
    }
}

/// Asks for steps in one to five windows.
pub fn steps(random: &mut Random, answers: &mut Answers) {
    several(random, answers);
    for round in 0..20 {
        let scene = scene(random);
        let windows = 2 + 2 * random.below(5);
        let mut finder = Finder { windows, asked: Vec::new() };
        let mut engine = Engine::<Lab7, _>::new(&mut finder, Choice::Sort, Workers::One);
        engine.load(&scene);
        engine.step();
        let mut discs = vec![Disc::default(); scene.len()];
        engine.read(0, &mut discs);
        let mut hits: Vec<[f64; 3]> =
            engine.taken.iter().map(|c| super::hard::hit(c.hit)).collect();
        hits.sort_by(|a, b| a.partial_cmp(b).expect("they are numbers"));
        drop(engine);
        let name = format!("scene {round}, {windows} windows");
        let question = format!("{name}: begin and end of each, and how many discs were free");
        answers.exact(&question, finder.asked.as_flattened());
        let question = format!("{name}: what was hit (1 x wall, 2 y wall, 3 pair) and by whom");
        answers.exact(&question, hits.as_flattened());
        for (number, d) in discs.iter().enumerate() {
            let question = format!("{name}: x y vx vy of disc {number} after the step");
            answers.close(&question, &[d.x, d.y, d.vx, d.vy]);
        }
    }
}
