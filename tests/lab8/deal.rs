//! Questions about dealing all pairs to workers, and about a worker's search.

use std::collections::BTreeSet;

use common::hard::Disc;
use hard_disc_ranks::{Deal, Job, Part};
use lab8::{distance, jobs, offsets, search_job};
use oracle::{Ask, Random, integers};
use solution5::Cut;
use solution7::{Candidate, Hit, pair_hit};

use super::candidates::{CANDIDATE, sorted, value};

/// Asks for the blocks of few and many workers.
pub(crate) fn few_blocks(_: &mut Random, ask: &mut impl Ask) {
    for workers in (1..70).chain([100, 127, 128, 255, 256, 257, 300, 600]) {
        ask.judge(
            &format!("{workers} workers: the blocks of worker 0"),
            || integers(offsets(workers)),
            |found| {
                let found: Vec<usize> = found.iter().map(|&block| block as usize).collect();
                by_the_rule(&found, workers)
            },
        );
    }
}

/// Checks that each block is the block that the rule picks after the earlier blocks.
fn by_the_rule(found: &[usize], workers: usize) -> Result<(), String> {
    if found.first() != Some(&0) {
        return Err(format!("{found:?} must begin with 0"));
    }
    let mut missing: BTreeSet<usize> = (1..=workers / 2).collect();
    for count in 1..found.len() {
        let before = &found[..count];
        let new = found[count];
        let gained = gain(before, new, workers, &missing);
        if gained.is_empty() {
            return Err(format!(
                "the blocks {before:?} and then {new}: block {new} adds no missing distance"
            ));
        }
        for other in 1..workers {
            let most = gain(before, other, workers, &missing).len();
            if most > gained.len() || most == gained.len() && other < new {
                return Err(format!(
                    "the blocks {before:?} and then {new}: this block adds {} missing distances, but block {other} \
                     adds {most}",
                    gained.len()
                ));
            }
        }
        missing.retain(|distance| !gained.contains(distance));
    }
    match missing.first() {
        None => Ok(()),
        Some(distance) => Err(format!("no two of the blocks {found:?} are {distance} apart")),
    }
}

/// Returns the missing distances that a new block adds.
fn gain(
    before: &[usize],
    new: usize,
    workers: usize,
    missing: &BTreeSet<usize>,
) -> BTreeSet<usize> {
    let distances = before.iter().map(|&old| distance(old, new, workers));
    distances.filter(|distance| missing.contains(distance)).collect()
}

/// Asks for the jobs of each worker.
pub(crate) fn dealt(random: &mut Random, ask: &mut impl Ask) {
    let few = (1..40).flat_map(|workers| [workers; 3]);
    for workers in few.chain([255, 256, 257, 300]) {
        let deal = Deal { workers, offsets: offsets_for(random, workers) };
        for worker in 0..workers {
            let question = format!(
                "worker {worker} of {workers}, with blocks at the offsets {:?}: row, column and part (0 whole, 1 \
                 first half, 2 second half) of each of the worker's jobs",
                deal.offsets
            );
            let numbers = |job: Job| [job.row, job.column, job.part as usize];
            ask.judge(
                &question,
                || integers(jobs(&deal, worker).into_iter().flat_map(numbers)),
                |found| {
                    let found: Vec<usize> = found.iter().map(|&number| number as usize).collect();
                    one_of_each_distance(&deal, worker, &found)
                },
            );
        }
    }
}

/// Draws offsets that make every distance, in any order. Another task asks which offsets the rule
/// finds.
fn offsets_for(random: &mut Random, workers: usize) -> Vec<usize> {
    let mut rest: Vec<usize> = (1..workers).collect();
    random.shuffle(&mut rest);
    let mut found = vec![0];
    let makes =
        |found: &[usize], d: usize| found.iter().any(|p| found.contains(&((p + d) % workers)));
    while !(0..=workers / 2).all(|d| makes(&found, d)) {
        found.extend(rest.pop());
    }
    found
}

/// Checks that job d, for each distance d, is a job that the worker must do.
fn one_of_each_distance(deal: &Deal, worker: usize, found: &[usize]) -> Result<(), String> {
    let distances = 0..=deal.workers / 2;
    if found.len() != 3 * distances.clone().count() {
        return Err(format!(
            "there are {} jobs, but {} distances, and each distance needs one job",
            found.len() / 3,
            distances.count()
        ));
    }
    for (distance, job) in found.chunks(3).enumerate() {
        let words = is_its_job(deal, worker, distance, job);
        words.map_err(|words| format!("distance {distance}, {job:?}: {words}"))?;
    }
    Ok(())
}

/// Returns whether a job (row, column, part) is the worker's job at this distance.
fn is_its_job(deal: &Deal, worker: usize, d: usize, job: &[usize]) -> Result<(), &'static str> {
    let Deal { workers, offsets } = deal;
    let [row, column, part] = [job[0], job[1], job[2]];
    if row > column || column >= *workers {
        return Err(
            "row and column must be two block numbers below the number of workers, with row ≤ column",
        );
    }
    let is_opposite = d > 0 && 2 * d == *workers;
    if is_opposite != (part > 0) {
        return Err(
            "the part must be 1 or 2 (a half) for opposite blocks, and 0 (the whole) for every other pair of blocks",
        );
    }
    // The block `near` is at offset p of the worker. The block `far` is d steps further round the
    // ring.
    let from_row = if is_opposite { part == 1 } else { (row + d) % workers == column };
    let [near, far] = if from_row { [row, column] } else { [column, row] };
    if (near + d) % workers != far {
        return Err("the blocks of row and column are not at this distance from each other");
    }
    let offset = (near + workers - worker) % workers;
    let bridges = |p: &usize| offsets.contains(&((p + d) % workers));
    match offsets.iter().find(|p| **p == offset || bridges(p)) {
        Some(first) if *first == offset && bridges(first) => Ok(()),
        _ => Err(
            "the job must be made from the worker's first offset that is at this distance from another of the worker's \
             offsets. Either the worker does not have both blocks, or an earlier offset is at this distance too",
        ),
    }
}

/// Asks for the candidates in blocks of few and many discs, whole and half, appended to earlier
/// candidates.
pub(crate) fn searches(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(1025) {
        // The number of pairs of 1025 discs in one block exceeds 16 bits.
        let ranks = if n == 1025 { 1 } else { 1 + random.below(5) };
        let blocks = Cut { rows: n, ranks };
        let discs = crowd(random, n);
        let mut ends = [random.below(ranks), random.below(ranks)];
        ends.sort_unstable();
        let [row, column] = ends;
        let parts = [Part::Whole, Part::First, Part::Second];
        for part in &parts[..if row == column { 1 } else { 3 }] {
            search(&discs, &blocks, Job { row, column, part: *part }, ask);
        }
    }
}

fn crowd(random: &mut Random, n: usize) -> Vec<Disc> {
    let side = (n.max(1) as f64).sqrt() * 3.0;
    let mut along = || random.between(0.0, side);
    (0..n).map(|_| Disc::new(along(), along(), along() - side / 2.0, 0.1 * along())).collect()
}

fn search(discs: &[Disc], blocks: &Cut, job: Job, ask: &mut impl Ask) {
    let name = format!("{} discs in {} blocks, {job:?}", discs.len(), blocks.ranks);
    let before = Candidate { time: -1.0, hit: Hit::WallX(7) };
    let mut found = vec![before];
    let tests = search_job(discs, blocks, &job, 1.0, &mut found) as usize;
    ask.exact(
        &format!("{name}: number of pair tests"),
        || integers([tests]),
        || integers([pairs_of(&job, blocks).len()]),
    );
    ask.exact(
        &format!("{name}: {CANDIDATE} of each candidate in the list, which contained one candidate before the search"),
        || flat(found),
        || {
            let pairs = pairs_of(&job, blocks).into_iter();
            let hits = pairs.filter_map(|[a, b]| pair_hit(discs, a, b, 1.0));
            flat(hits.chain([before]).collect())
        },
    );
}

/// Returns the pairs of discs that belong to a job.
fn pairs_of(job: &Job, blocks: &Cut) -> Vec<[u32; 2]> {
    let rows = job.part.of(blocks.block(job.row));
    let columns = blocks.block(job.column);
    let all = rows.flat_map(|a| columns.clone().map(move |b| [a as u32, b as u32]));
    all.filter(|[a, b]| a < b).collect()
}

fn flat(all: Vec<Candidate>) -> Vec<f64> {
    sorted(all).iter().flat_map(value).collect()
}
