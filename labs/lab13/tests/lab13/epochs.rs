//! Questions about the number of correct steps of an epoch, on one rank and on all ranks.

use common::soft::CUTOFF;
use lab13::{confirm, right_steps};
use oracle::{Ask, Random};
use oracle_mpi::on_each;

use super::messages::one_reduction;

/// Returns the depth of ghosts that `steps` steps with these moves need.
fn needed(moves: &[f64], steps: usize) -> f64 {
    CUTOFF * steps as f64 + 2.0 * moves[..steps - 1].iter().sum::<f64>()
}

/// Asks for the correct steps among few and many. The depth of the ghosts suffices for some of the
/// steps, narrowly or not quite.
pub(crate) fn right_steps_of_epochs(random: &mut Random, ask: &mut impl Ask) {
    let sizes = random.sizes(257).into_iter().filter(|&taken| taken > 0);
    for taken in sizes.flat_map(|taken| [taken; 20]) {
        let moves: Vec<f64> = (0..taken).map(|_| CUTOFF * random.magnitude(1e-6, 1e3)).collect();
        let moves = if random.below(5) == 0 { vec![0.0; taken] } else { moves };
        let width = some_depth(random, &moves);
        let shown = if taken < 9 {
            format!(", in which particles move at most {moves:?}")
        } else {
            String::new()
        };
        let question = format!(
            "{taken} steps{shown}, ghosts {width:?} deep: number of steps that are correct"
        );
        let found = || vec![right_steps(&moves, width) as f64];
        ask.exact(&question, found, || vec![right_of(&moves, width) as f64]);
    }
    ask.exact(
        "2 steps in which no particle moves, ghosts exactly two cutoffs deep: number of steps that are correct",
        || vec![right_steps(&[0.0, 0.0], 2.0 * CUTOFF) as f64],
        || vec![2.0],
    );
}

/// Draws a depth slightly more than some steps need, slightly less than one more step needs, or
/// between the two.
fn some_depth(random: &mut Random, moves: &[f64]) -> f64 {
    let steps = 1 + random.below(moves.len());
    let hair = 1.0 + 3e-13;
    let least = needed(moves, steps);
    let next = if steps < moves.len() { needed(moves, steps + 1) } else { 2.0 * least };
    let more = random.between(0.0, 0.9);
    [least * hair, next / hair, least + more * (next - least)][random.below(3)]
}

/// Returns the number of correct steps. The first step is always correct.
fn right_of(moves: &[f64], width: f64) -> usize {
    (1..=moves.len()).take_while(|&k| k == 1 || needed(moves, k) <= width).count()
}

/// Asks for the agreement of all ranks: the number of steps that are correct on all ranks, and the
/// maximum of each number.
pub(crate) fn confirmations(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "13.8", &[1, 2, 3, 5], random, |rank, random, ask| {
        for _ in 0..60 {
            let steps = 1 + random.below(12);
            let numbers = steps + random.below(4);
            let sent: Vec<Vec<f64>> = (0..rank.ranks)
                .map(|_| (0..numbers).map(|_| CUTOFF * random.magnitude(1e-3, 10.0)).collect())
                .collect();
            let width = CUTOFF * random.magnitude(1.0, 100.0);
            let mut all = sent[rank.number].clone();
            let right = rank.call("confirm", |world| confirm(world, &mut all, steps, width));
            let name = format!(
                "{}, {steps} steps, ghosts {width:?} deep. The ranks sent the numbers {sent:?}",
                rank.name()
            );
            ask.exact(
                &format!(
                    "{name}: (1) number of steps that are correct on all ranks, (2) the numbers on which the ranks \
                     agree"
                ),
                || [vec![right as f64], all].concat(),
                || agreed(&sent, steps, width),
            );
            one_reduction(&name, ask);
        }
    });
}

fn agreed(sent: &[Vec<f64>], steps: usize, width: f64) -> Vec<f64> {
    let greatest = |k: usize| sent.iter().map(|sent| sent[k]).fold(0.0, f64::max);
    let all: Vec<f64> = (0..sent[0].len()).map(greatest).collect();
    let right = right_of(&all[..steps], width);
    [vec![right as f64], all].concat()
}
