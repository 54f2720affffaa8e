//! What is asked about lab 10: each decision of the engine by itself.

use common::soft::{CUTOFF, DT, Particle};
use lab10::kernels::{Pair, Places, ROOM};
use lab10::{AnyProcessor, Bodies, best_skin, collect, drift, filter, worn_out};

use crate::{Answers, Random, truth};

#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "10.1" => moves(random, answers),
        "10.2" => lists(random, answers),
        "10.3" => worn(random, answers),
        "10.4" => skins(random, answers),
        "10.5" => near(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

fn moves(random: &mut Random, answers: &mut Answers) {
    for case in 0..200 {
        let n = [1, 7, 8, 64, 100][case % 5];
        let mut x: Vec<f64> = (0..n).map(|_| random.between(0.1, 0.9)).collect();
        let mut v: Vec<f64> = (0..n).map(|_| random.between(-1.0, 1.0)).collect();
        let a: Vec<f64> = (0..n).map(|_| random.between(-1e3, 1e3)).collect();
        match case % 4 {
            0 => (x[case % n], v[case % n]) = (1e-5, -3.0),
            1 => (x[case % n], v[case % n]) = (1.0 - 1e-5, 3.0),
            _ => {}
        }
        let left = drift(&mut x, &mut v, &a, DT, 1.0);
        let name = format!("case {case}, {n} particles");
        answers.exact(&format!("{name}: the places after the move"), &x);
        answers.exact(&format!("{name}: the velocities after the move"), &v);
        answers.exact(&format!("{name}: whether somebody is outside the walls"), &[truth(left)]);
    }
}

fn lists(random: &mut Random, answers: &mut Answers) {
    for round in 0..10 {
        let bodies = Bodies::of(&soft::crowd(random, 200, 6.0 * CUTOFF, 0.0));
        let reach = random.between(1.0, 2.0) * CUTOFF;
        for _ in 0..40 {
            // A particle is not among those that it is compared with.
            let from = random.below(100);
            let i = (from + 100 + random.below(100)) % 200;
            let to = from + [0, 1, 5, 8, 12, 100][random.below(6)];
            let mut list = [[77; 2]; 109];
            let len = collect(&mut list, 1, &bodies, i, from..to, reach, AnyProcessor);
            let pairs = list.get(..len).unwrap_or(&list);
            let found: Vec<f64> = pairs.iter().flatten().map(|k| f64::from(*k)).collect();
            let question = format!(
                "scene {round}: a pair of 77 and 77, and those of particle {i} with all from {from} on and \
                 before {to} within {:.3} cutoffs",
                reach / CUTOFF
            );
            answers.exact(&question, &found);
        }
        // One stands exactly at the reach, the others a billionth before and behind it.
        let mut row = Bodies::default();
        for (k, share) in (0..).zip([0.0, 1.0, 1.0 + 1e-9, 1.0 - 1e-9]) {
            row.push(Particle { x: reach * share, id: k, ..Particle::default() });
        }
        let mut list = [[77; 2]; 12];
        let len = collect(&mut list, 0, &row, 0, 1..4, reach, AnyProcessor);
        let pairs = list.get(..len).unwrap_or(&list);
        let found: Vec<f64> = pairs.iter().flatten().map(|k| f64::from(*k)).collect();
        let question = format!(
            "scene {round}: the pairs of particle 0 at x = 0 with three at 1, 1 + 1e-9 and 1 - 1e-9 times \
             the reach of {reach:e}"
        );
        answers.exact(&question, &found);
    }
}

fn worn(random: &mut Random, answers: &mut Answers) {
    for _ in 0..300 {
        let skin = random.between(0.05, 3.0) * CUTOFF;
        let unit = [0.5, 1.0, 0.25][random.below(3)];
        let way = unit * skin * random.around_one();
        let question = format!(
            "whether a list with a skin of {:.4} cutoffs is worn when the longest way is {:.6}",
            skin / CUTOFF,
            way / CUTOFF
        );
        answers.exact(&question, &[truth(worn_out(way * way, skin))]);
    }
    answers.exact("whether no list is worn", &[truth(worn_out(f64::INFINITY, 0.0))]);
}

fn skins(random: &mut Random, answers: &mut Answers) {
    for case in 0..300 {
        let density = [0.0, 1.0, 20.0][case % 3] * random.between(0.1, 5.0) * 2000.0;
        let speed = [0.0, 0.01, 0.1, 1.0][case % 4] * random.between(0.1, 5.0) * CUTOFF;
        let question = format!(
            "the skin, in cutoffs, for a density of {density:.3} and a speed of {speed:.3e}"
        );
        answers.close(&question, &[best_skin(density, speed) / CUTOFF]);
    }
}

fn near(random: &mut Random, answers: &mut Answers) {
    for round in 0..60 {
        let all = Bodies::of(&soft::crowd(random, 120, 6.0 * CUTOFF, 0.0));
        let first = random.below(20);
        let places = Places { x: &all.x[first..], y: &all.y[first..], first };
        let within = random.between(0.5, 2.0) * CUTOFF;
        let len = [0, 1, 7, 100, ROOM][round % 5];
        let mut pick = || (first + random.below(120 - first)) as u32;
        let pairs: Vec<Pair> = (0..len).map(|_| [pick(), pick()]).collect();
        let mut list = [[77; 2]; ROOM];
        let found = filter(&pairs, places, within * within, &mut list);
        let found = list.get(..found).unwrap_or(&list);
        let found: Vec<f64> = found.iter().flatten().map(|k| f64::from(*k)).collect();
        let question = format!(
            "scene {round}: which of {len} pairs of the particles from {first} on are within {:.3} cutoffs",
            within / CUTOFF
        );
        answers.exact(&question, &found);
    }
    let mut row = Bodies::default();
    for (id, x) in (0..).zip([0.0, 3.0, 4.0, 8.0]) {
        row.push(Particle { x, id, ..Particle::default() });
    }
    let mut list = [[77; 2]; ROOM];
    let found = filter(&[[0, 1], [0, 2], [1, 3], [2, 3]], row.places(), 16.0, &mut list);
    let found = list.get(..found).unwrap_or(&list);
    let found: Vec<f64> = found.iter().flatten().map(|k| f64::from(*k)).collect();
    answers.exact("which of four pairs, 3, 4, 5 and 4 apart, are within 4", &found);
}
