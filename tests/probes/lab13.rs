//! What is asked about lab 13.

use common::soft::CUTOFF;
use lab13::{
    VARIANTS, best_depth, best_steps, choose, confirm, deep_width, exchange_places, ghost_width,
    load, must_renew, pairs_across, partners, right_steps, weigh_rows,
};
use mpi::Rank;
use mpi::traits::*;
use neighbour_list::kernels::Positions;
use strips::{Outlook, Scenery, Strips};

use self::ranks::tell_all;
use self::soft::Engine;
use crate::{Answers, Random, truth, weighed};

#[path = "ranks.rs"]
mod ranks;
#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "13.1" => widths(random, answers),
        "13.2" => neighbours(random, answers),
        "13.3" => ghosts(random, answers),
        "13.4" => exchanges(random, answers),
        "13.5" => loads(random, answers),
        "13.6" => steps(random, answers),
        "13.7" => depths(random, answers),
        "13.8" => epochs(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

fn widths(random: &mut Random, answers: &mut Answers) {
    for _ in 0..100 {
        let fastest = CUTOFF * 10_f64.powf(random.between(-3.0, 1.5));
        let steps = 1 + random.below(40) as u32;
        let question = format!("ghosts for {steps} steps of {} cutoffs", fastest / CUTOFF);
        answers.close(&question, &[ghost_width(fastest, steps)]);
        let scenery = Scenery {
            fastest,
            density: 10_f64.powf(random.between(-2.0, 1.0)) / (CUTOFF * CUTOFF),
            height: CUTOFF * 10_f64.powf(random.between(0.3, 3.5)),
            most: steps,
        };
        answers
            .exact(&format!("for how many steps: {scenery:?}"), &[f64::from(best_steps(scenery))]);
    }
}

/// Strips for so many ranks, some of them empty, in a box of side 1.
fn some_strips(random: &mut Random, ranks: usize) -> Strips {
    let mut edges: Vec<f64> = (1..ranks).map(|_| random.below(12) as f64 / 12.0).collect();
    let wall = |edge: f64| if edge == 0.0 { f64::NEG_INFINITY } else { edge };
    edges.sort_by(f64::total_cmp);
    edges = edges.into_iter().map(wall).collect();
    edges.insert(0, f64::NEG_INFINITY);
    edges.push(f64::INFINITY);
    Strips { edges }
}

fn neighbours(random: &mut Random, answers: &mut Answers) {
    for _ in 0..100 {
        let ranks = 1 + random.below(7);
        let (strips, width) = (some_strips(random, ranks), random.between(0.01, 0.4));
        for rank in 0..ranks {
            let found: Vec<f64> =
                partners(&strips, rank, width).into_iter().map(f64::from).collect();
            let question = format!(
                "partners of rank {rank}, ghosts {width} wide, strips at {:?}",
                strips.edges
            );
            answers.exact(&question, &found);
        }
    }
}

fn ghosts(random: &mut Random, answers: &mut Answers) {
    for _ in 0..40 {
        let y: Vec<f64> = (0..random.below(60)).map(|_| random.between(1.0, 2.0)).collect();
        let width = random.between(0.0, 0.7);
        for strip in [2.0..3.0, 2.25..f64::INFINITY, 0.0..1.0, f64::NEG_INFINITY..0.75] {
            let found: Vec<f64> = choose(&y, &strip, width).into_iter().map(f64::from).collect();
            let question = format!("of {} particles those within {width} of {strip:?}", y.len());
            answers.exact(&question, &found);
        }
    }
    for _ in 0..40 {
        let mut axis =
            |n: usize| -> Vec<f64> { (0..n).map(|_| random.between(0.0, 1.0)).collect() };
        let [x, y, ghost_x, ghost_y] = [axis(30), axis(30), axis(40), axis(40)];
        let reach = random.between(0.01, 0.8);
        let [own, ghosts] =
            [(&x, &y), (&ghost_x, &ghost_y)].map(|(x, y)| Positions { x, y, first: 0 });
        let mut pairs = pairs_across(own, ghosts, reach);
        let sorted = pairs.is_sorted_by_key(|pair| pair[0]);
        pairs.sort_unstable();
        let numbers: Vec<f64> = pairs.as_flattened().iter().map(|k| f64::from(*k)).collect();
        answers.exact(&format!("pairs of 30 particles and 40 ghosts within {reach}"), &numbers);
        answers.exact("whether they ascend", &[truth(sorted)]);
    }
}

/// In rows of ranks: nothing, a few, and more than the library keeps aside for ranks that send before
/// they receive. Rank 0 lets rank 1 begin only when its inner particles have moved.
fn exchanges(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 3, 4], |world| {
        let (rank, ranks) = (world.rank(), world.size());
        for (round, most) in [0, 7, 1000, 200_000].into_iter().enumerate() {
            let lengths: Vec<usize> = (0..2 * ranks).map(|_| random.below(most + 1)).collect();
            let beside: Vec<Rank> = [rank - 1, rank + 1]
                .into_iter()
                .filter(|other| (0..ranks).contains(other))
                .collect();
            // Upwards and downwards from a rank.
            let length = |from: Rank, to: Rank| lengths[2 * from as usize + usize::from(to > from)];
            let letter = |from: Rank, to: Rank| -> Vec<f64> {
                (0..length(from, to)).map(|k| f64::from(10 * from + to) + k as f64).collect()
            };
            let sent: Vec<_> = beside.iter().map(|to| letter(rank, *to)).collect();
            let mut received: Vec<_> =
                beside.iter().map(|from| vec![0.0; length(*from, rank)]).collect();
            let token = round == 1 && ranks == 2;
            if token && rank == 1 {
                let _: (i32, _) = world.process_at_rank(0).receive_with_tag(7);
            }
            let mut worked = 0.0;
            exchange_places(world, &beside, &sent, &mut received, || {
                worked += 1.0;
                if token && rank == 0 {
                    world.process_at_rank(1).send_with_tag(&1, 7);
                }
            });
            let mut told = vec![worked];
            for places in &received {
                told.extend([places.len() as f64, weighed(places.iter().copied())]);
            }
            told.resize(5, 0.0);
            let question = format!(
                "{ranks} ranks, lists of up to {most}: for each rank how often it worked, numbers \
                 received and their weighed sum"
            );
            tell_all(world, answers, &question, &told);
        }
    });
}

fn loads(random: &mut Random, answers: &mut Answers) {
    for _ in 0..50 {
        let (particles, pairs) = (random.below(1_000_000), random.below(3_000_000));
        let question = format!("load of {particles} particles and {pairs} pairs");
        answers.exact(&question, &[load(particles, pairs) as f64]);
        let counts: Vec<u64> =
            (0..20).map(|_| (random.below(4) * random.below(5000)) as u64).collect();
        let load = 1 + random.below(1 << 40) as u64;
        let rows: Vec<f64> = weigh_rows(&counts, load).iter().map(|row| *row as f64).collect();
        answers.exact(&format!("a load of {load} in rows of {counts:?}"), &rows);
    }
    let rows: Vec<f64> = weigh_rows(&[0, 0, 0], 0).iter().map(|row| *row as f64).collect();
    answers.exact("the rows of a rank without particles", &rows);
}

/// First what the ranks say to worn lists, then whole steps, which take all other tasks.
fn steps(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 4], |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        for round in 0..6 {
            let width = CUTOFF * random.between(1.0, 4.0);
            let spare = 0.5 * (width - CUTOFF);
            let moved: Vec<f64> = (0..ranks).map(|_| spare * random.between(0.0, 1.1)).collect();
            let worn: Vec<bool> = (0..ranks).map(|_| random.below(8) == 0).collect();
            let anew = must_renew(world, worn[rank], moved[rank], width);
            let question =
                format!("{ranks} ranks, round {round}: whether each makes its list anew");
            tell_all(world, answers, &question, &[truth(anew)]);
        }
        let dense = soft::spread(random, 200, 12.5 * CUTOFF, 1.0);
        let crowd = soft::crowd(random, 250, 12.5 * CUTOFF, 1.0);
        for (variant, threads) in [("strips", 1), ("strips-threads", 2)] {
            let mut engine = Engine::new(VARIANTS, variant, threads, &[]);
            for (name, scene, steps) in [("200 in 12.5 cutoffs", &dense, 6), ("250", &crowd, 1)] {
                let run = engine.run(scene, steps);
                if rank == 0 {
                    answers.steps(&format!("{variant} on {ranks} ranks, {name}"), &run);
                }
            }
        }
    });
}

fn depths(random: &mut Random, answers: &mut Answers) {
    for _ in 0..100 {
        let fastest = CUTOFF * 10_f64.powf(random.between(-3.0, 1.5));
        let steps = 1 + random.below(40) as u32;
        let question = format!("depth for {steps} steps of {} cutoffs", fastest / CUTOFF);
        answers.close(&question, &[deep_width(fastest, steps)]);
        let outlook = Outlook {
            fastest,
            height: CUTOFF * 10_f64.powf(random.between(0.3, 3.5)),
            particles: 10_f64.powf(random.between(0.0, 6.0)),
            most: steps,
        };
        let question = format!("how long an epoch: {outlook:?}");
        answers.exact(&question, &[f64::from(best_depth(outlook))]);
    }
}

/// First how many steps are right, by one rank and by all, then whole steps, which take tasks 13.2, 13.5 and
/// 13.7.
fn epochs(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 4], |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        for _ in 0..50 {
            let moves: Vec<f64> =
                (0..1 + random.below(12)).map(|_| CUTOFF * random.between(0.0, 1.5)).collect();
            let width = CUTOFF * random.between(1.0, 20.0);
            let question =
                format!("{ranks} ranks, right steps of {moves:?} with ghosts {width} deep");
            tell_all(world, answers, &question, &[right_steps(&moves, width) as f64]);
        }
        for round in 0..8 {
            let width = CUTOFF * random.between(2.0, 12.0);
            let said: Vec<[f64; 7]> = (0..ranks)
                .map(|_| std::array::from_fn(|_| CUTOFF * random.between(0.0, 1.0)))
                .collect();
            let mut own = said[rank];
            let right = confirm(world, &mut own, 5, width);
            let question = format!("{ranks} ranks, round {round}: right steps and what all say");
            let told: Vec<f64> = [right as f64].into_iter().chain(own).collect();
            tell_all(world, answers, &question, &told);
        }
        let dense = soft::spread(random, 200, 12.5 * CUTOFF, 1.0);
        let mut engine = Engine::new(VARIANTS, "strips-deep", 1, &[]);
        let run = engine.run(&dense, 8);
        if rank == 0 {
            answers.steps(&format!("strips-deep on {ranks} ranks, 200 in 12.5 cutoffs"), &run);
        }
    });
}
