//! What is asked about lab 11: each decision of the engine by itself.

use common::soft::{CUTOFF, DT};
use lab11::{closest_squared, fly, join, meets_wall, root, too_far_off, window_length};
use windows::Span;

use crate::{Answers, Random, truth};

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "11.1" => flights(random, answers),
        "11.2" => approaches(random, answers),
        "11.3" => groups(random, answers),
        "11.4" => margins(random, answers),
        "11.5" => walls(random, answers),
        "11.6" => lengths(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

fn flights(random: &mut Random, answers: &mut Answers) {
    for steps in [0, 1, 2, 7, 12, 64] {
        let mut x: Vec<f64> = (0..200).map(|_| random.between(0.0, 20.0)).collect();
        let v: Vec<f64> = (0..200).map(|_| random.between(-1.0, 1.0)).collect();
        fly(&mut x, &v, steps, DT);
        answers.exact(&format!("where 200 particles are after {steps} steps, to the bit"), &x);
    }
}

fn approaches(random: &mut Random, answers: &mut Answers) {
    let mut ask = |d: (f64, f64), w: (f64, f64), span: f64| {
        let found = closest_squared(d.0, d.1, w.0, w.1, span);
        let question = format!(
            "the least squared distance of two that are {d:?} apart and part with {w:?} for {span}"
        );
        answers.close(&question, &[found]);
    };
    for _ in 0..600 {
        let mut number = |limit: f64| random.between(-limit, limit);
        ask((number(5.0), number(5.0)), (number(4.0), number(4.0)), number(2.0).abs());
    }
    for (d, w, span) in [
        ((3.0, 4.0), (0.0, 0.0), 1.0),
        ((0.0, 0.0), (0.0, 0.0), 1.0),
        ((0.0, 0.0), (5.0, 5.0), 0.0),
        ((3.0, 1.0), (-1.0, 0.0), 2.0),
        ((3.0, 1.0), (1.0, 0.0), 9.0),
    ] {
        ask(d, w, span);
    }
}

fn groups(random: &mut Random, answers: &mut Answers) {
    let mut chain: Vec<u32> = (0..1000_u32).map(|k| k.saturating_sub(1)).collect();
    let found = root(&mut chain, 999);
    answers.exact("the root of a chain of 1000", &[f64::from(found)]);
    let (mut k, mut links) = (999, 0);
    while links < 1000 && chain.get(k).is_some_and(|&parent| parent as usize != k) {
        (k, links) = (chain[k] as usize, links + 1);
    }
    let question = "whether the path to it is at most half as long afterwards";
    answers.exact(question, &[truth(links <= 500)]);
    for round in 0..40 {
        let n = 2 + random.below(60);
        let mut parent: Vec<u32> = (0..n as u32).collect();
        for _ in 0..random.below(2 * n) {
            let [a, b] = [(); 2].map(|()| random.below(n) as u32);
            join(&mut parent, a, b);
        }
        let roots: Vec<f64> = (0..n as u32).map(|k| f64::from(root(&mut parent, k))).collect();
        answers.exact(&format!("round {round}: the roots of {n} particles"), &roots);
    }
}

fn margins(random: &mut Random, answers: &mut Answers) {
    for _ in 0..300 {
        let margin = random.between(0.1, 2.0) * CUTOFF;
        let bent = [0.5, 1.0, 0.25][random.below(3)] * margin * random.around_one();
        let question = format!(
            "whether one that is {:.6} cutoffs off its path may have met somebody, margin {:.4}",
            bent / CUTOFF,
            margin / CUTOFF
        );
        answers.exact(&question, &[truth(too_far_off(bent, margin))]);
    }
}

fn walls(random: &mut Random, answers: &mut Answers) {
    for _ in 0..600 {
        let steps = 1 + random.below(64) as u32;
        let span = Span { steps, dt: DT, size: random.between(0.5, 2.0) };
        let v = random.between(0.1, 5.0);
        // Where the window ends about at a wall, or the first step does, or neither.
        let reach = [f64::from(steps), 1.0, 500.0][random.below(3)] * v * DT;
        let from_wall = (reach * random.around_one()).min(span.size);
        let v = if random.below(4) == 0 { -v } else { v };
        let (x, v) =
            if random.below(2) == 0 { (from_wall, -v) } else { (span.size - from_wall, v) };
        let (middle, rest) = (span.size / 2.0, 0.0);
        let across = random.below(2) == 0;
        let meets = match across {
            true => meets_wall(&span, x, middle, v, rest),
            false => meets_wall(&span, middle, x, rest, v),
        };
        let axis = if across { "x" } else { "y" };
        let question = format!(
            "whether a particle at {axis} = {x} with velocity {v} meets a wall of a box of {} in \
             {steps} steps",
            span.size
        );
        answers.exact(&question, &[truth(meets)]);
    }
}

fn lengths(random: &mut Random, answers: &mut Answers) {
    let mut ask = |density: f64, speed: f64| {
        let question =
            format!("the window for a density of {density:.2} and a speed of {speed:.5}");
        answers.exact(&question, &[f64::from(window_length(density, speed))]);
    };
    for case in 0..300 {
        let density = [200.0, 2000.0, 50_000.0][case % 3] * random.between(0.5, 2.0);
        ask(density, [0.05, 0.7, 20.0][case % 3] * random.between(0.2, 3.0));
    }
    for (density, speed) in [(2000.0, 0.0), (0.0, 1.0), (0.0, 0.0), (2000.0, 900.0)] {
        ask(density, speed);
    }
}
