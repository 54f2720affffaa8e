//! What tests and probe ask alike about the functions of lab 8, with drawn inputs and what a plain model says.

use std::collections::BTreeSet;

use common::hard::Disc;
use hard_disc_ranks::{
    CandidateWire, Deal, Decisions, DiscWire, Job, Part, Reach, Strips, UNKNOWN, slots_of,
};
use lab8::{
    collided, distance, ghosts_for, hear, jobs, looks_at, move_on, news_for, offsets, reached,
    search_job, take_certain, update,
};
use solution5::Cut;
use solution6::Cuts;
use solution7::{Candidate, Hit, Lab7, Square, order, pair_hit, resolve};

use super::ask::{Ask, beside, flags, truth, whole};
use crate::Random;

/// Time, kind (0 to 3 for a corner, an x wall, a y wall, a pair), discs.
fn value(c: &Candidate) -> [f64; 4] {
    let [kind, first] = match c.hit {
        Hit::Corner(a) => [0.0, f64::from(a)],
        Hit::WallX(a) => [1.0, f64::from(a)],
        Hit::WallY(a) => [2.0, f64::from(a)],
        Hit::Pair(a, _) => [3.0, f64::from(a)],
    };
    [c.time, kind, first, c.hit.second().map_or(-1.0, f64::from)]
}

/// Candidates in their order.
fn sorted(all: &[Candidate]) -> Vec<f64> {
    let mut all = all.to_vec();
    all.sort_by(order);
    all.iter().flat_map(value).collect()
}

fn wire(wire: &DiscWire) -> [f64; 7] {
    let counts = [wire.pair_collisions, wire.wall_collisions].map(f64::from);
    [wire.number as f64, wire.x, wire.y, wire.vx, wire.vy, counts[0], counts[1]]
}

fn wires(all: &[DiscWire]) -> Vec<f64> {
    all.iter().flat_map(wire).collect()
}

/// A disc that has collided before.
fn disc(random: &mut Random, unit: f64) -> Disc {
    let mut number = || unit * random.signed(1e-3, 1e3);
    let disc = Disc::new(number(), number(), number(), number());
    let mut count = || [0, 255, 65_535, 1 << 24][random.below(4)];
    Disc { pair_collisions: count(), wall_collisions: count(), ..disc }
}

/// The blocks of few and many workers, by the rule.
pub(super) fn blocks(_: &mut Random, ask: Ask<'_>) {
    for workers in (1..70).chain([100, 127, 128, 255, 256, 257, 300, 600]) {
        let mut missing: BTreeSet<usize> = (1..=workers / 2).collect();
        let mut right = vec![0];
        while !missing.is_empty() {
            let gains = |new: usize| -> BTreeSet<usize> {
                right
                    .iter()
                    .map(|&old| distance(old, new, workers))
                    .filter(|d| missing.contains(d))
                    .collect()
            };
            let most = (1..workers).map(|new| gains(new).len()).max().unwrap_or(0);
            let new = (1..workers).find(|&new| gains(new).len() == most).unwrap_or(1);
            let gained = gains(new);
            missing.retain(|d| !gained.contains(d));
            right.push(new);
        }
        ask(&format!("the blocks of worker 0 of {workers}"), whole(offsets(workers)), whole(right));
    }
}

/// Offsets that make every distance, in any order: which of them the rule finds is another task.
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

/// The jobs of each worker.
pub(super) fn dealt(random: &mut Random, ask: Ask<'_>) {
    let few = (1..40).flat_map(|workers| [workers; 3]);
    for workers in few.chain([255, 256, 257, 300]) {
        let offsets = offsets_for(random, workers);
        let deal = Deal { workers, offsets: offsets.clone() };
        for worker in 0..workers {
            let right = (0..=workers / 2).flat_map(|d| {
                let p = offsets.iter().find(|p| offsets.contains(&((*p + d) % workers)));
                let p = p.expect("every distance is there");
                let (i, j) = ((worker + p) % workers, (worker + p + d) % workers);
                let part = if 2 * d == workers && d > 0 { 1 + usize::from(i > j) } else { 0 };
                [i.min(j), i.max(j), part]
            });
            let found = jobs(&deal, worker)
                .into_iter()
                .flat_map(|job| [job.row, job.column, job.part as usize]);
            let question = format!(
                "worker {worker} of {workers}, blocks at {offsets:?}: row, column and part (0 whole, 1 first half, 2 \
                 second) of its jobs"
            );
            ask(&question, whole(found), whole(right));
        }
    }
}

/// Blocks of few and many discs, whole and by halves, with what was found before.
pub(super) fn searches(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(1025) {
        // Sixteen bits do not count the pairs of 1025 discs in one block.
        let ranks = if n == 1025 { 1 } else { 1 + random.below(5) };
        let blocks = Cut { rows: n, ranks };
        let side = (n.max(1) as f64).sqrt() * 3.0;
        let mut along = || random.between(0.0, side);
        let discs: Vec<Disc> = (0..n)
            .map(|_| Disc::new(along(), along(), along() - side / 2.0, 0.1 * along()))
            .collect();
        let (row, column) = (random.below(ranks), random.below(ranks));
        let (row, column) = (row.min(column), row.max(column));
        let parts = [Part::Whole, Part::First, Part::Second];
        for part in &parts[..if row == column { 1 } else { 3 }] {
            let job = Job { row, column, part: *part };
            let before = Candidate { time: -1.0, hit: Hit::WallX(7) };
            let (mut found, mut right, mut pairs) = (vec![before], vec![before], 0);
            for a in part.of(blocks.block(row)) {
                for b in blocks.block(column).filter(|&b| b > a) {
                    pairs += 1;
                    right.extend(pair_hit(&discs, a as u32, b as u32, 1.0));
                }
            }
            let tests = search_job(&discs, &blocks, &job, 1.0, &mut found) as usize;
            let name = format!("{n} discs in {ranks} blocks, {job:?}");
            ask(&format!("{name}: pairs looked at"), whole([tests]), whole([pairs]));
            ask(
                &format!("{name}: candidates, beside one from before"),
                sorted(&found),
                sorted(&right),
            );
        }
    }
}

/// Discs of held blocks that have collided: few and many, with walls and with discs of any block.
pub(super) fn told_discs(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(4097).into_iter().chain([70_000]).filter(|&n| n > 0) {
        let discs: Vec<Disc> = (0..n).map(|_| disc(random, 1.0)).collect();
        let ranks = 1 + random.below(9);
        let blocks = Cut { rows: n, ranks };
        let mut order: Vec<u32> = (0..n as u32).collect();
        random.shuffle(&mut order);
        order.truncate(random.below(n + 1).max(n / 2));
        let mut taken = Vec::new();
        while let Some(a) = order.pop() {
            let walls = [Hit::WallX(a), Hit::WallY(a), Hit::Corner(a)];
            let pair = order.pop().map(|b| Hit::Pair(a.min(b), a.max(b)));
            let hit = pair.filter(|_| random.below(4) > 0);
            order.extend(pair.filter(|_| hit.is_none()).and_then(Hit::second));
            taken.push(Candidate {
                time: random.between(0.0, 1.0),
                hit: hit.unwrap_or(walls[random.below(3)]),
            });
        }
        let held: Vec<usize> = (0..ranks).filter(|_| random.below(2) == 0).collect();
        let numbers = taken.iter().flat_map(|c| [Some(c.hit.first()), c.hit.second()]).flatten();
        let mut right: Vec<usize> = numbers.map(|number| number as usize).collect();
        right.retain(|&number| held.iter().any(|&block| blocks.block(block).contains(&number)));
        right.sort_unstable();
        let right: Vec<DiscWire> = right.iter().map(|&k| DiscWire::new(k, &discs[k])).collect();
        let mut found = collided(&discs, &blocks, &held, &taken);
        found.sort_by_key(|wire| wire.number);
        let question = format!(
            "{n} discs in {ranks} blocks, {} collisions: number, x y vx vy and counts of those that have collided in the \
             blocks {held:?}",
            taken.len()
        );
        ask(&question, wires(&found), wires(&right));
    }
}

/// Held blocks that move or not, and discs that arrive, also from blocks that are not held.
pub(super) fn updates(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(1025).into_iter().filter(|&n| n > 0).flat_map(|n| [n; 3]) {
        let before: Vec<Disc> = (0..n).map(|_| disc(random, 1.0)).collect();
        let cut = random.below(n + 1);
        let held =
            [[0..cut, n..n], [cut..cut, cut..n], [0..cut / 2, cut..n]][random.below(3)].clone();
        let mut arrived = Vec::new();
        for number in (0..n).filter(|_| random.below(4) == 0).collect::<Vec<_>>() {
            arrived.push(DiscWire::new(number, &disc(random, 1.0)));
        }
        let moves = random.below(3) > 0;
        let (mut found, mut right) = (before.clone(), before);
        for (number, disc) in right.iter_mut().enumerate() {
            if moves && held.iter().any(|block| block.contains(&number)) {
                (disc.x, disc.y) = (disc.x + disc.vx, disc.y + disc.vy);
            }
        }
        arrived.iter().for_each(|wire| right[wire.index()] = Disc::from(wire));
        update(&mut found, &held, moves, &arrived);
        let all = |discs: &[Disc]| {
            (0..)
                .zip(discs)
                .flat_map(|(k, disc)| wire(&DiscWire::new(k, disc)))
                .collect::<Vec<f64>>()
        };
        let question = format!(
            "a worker of discs {held:?} of {n}, moves: {moves}, {} arrive: number, x y vx vy and counts of all",
            arrived.len()
        );
        ask(&question, all(&found), all(&right));
    }
}

/// Rows from some height on, cut into strips for `ranks` ranks, some of them empty.
fn strips(random: &mut Random, ranks: usize, rows: usize) -> Strips {
    let mut starts: Vec<usize> = (1..ranks).map(|_| random.below(rows + 1)).collect();
    starts.extend([0, rows]);
    starts.sort_unstable();
    let height = random.magnitude(1e-9, 1e9).log2().round().exp2();
    Strips { bottom: random.below(100) as f64 * height, height, cuts: Cuts { starts } }
}

/// The rank of a height: the edges at or below it are counted.
fn rank_of(strips: &Strips, y: f64) -> usize {
    let Strips { bottom, height, cuts: Cuts { starts } } = strips;
    let rows = starts[starts.len() - 1];
    let row = (1..rows).rev().find(|&row| y >= bottom + row as f64 * height).unwrap_or(0);
    (0..starts.len() - 1).find(|&rank| (starts[rank]..starts[rank + 1]).contains(&row)).unwrap_or(0)
}

/// Discs in few and many strips whose boxes end within one, on an edge, a hair beside it, or beyond all.
fn flying(random: &mut Random, strips: &Strips, reach: f64, number: u64) -> DiscWire {
    let rows = *strips.cuts.starts.last().expect("there are rows");
    let edge = |random: &mut Random| strips.bottom + random.below(rows + 1) as f64 * strips.height;
    let y = edge(random) + [0.25, 0.5][random.below(2)] * strips.height;
    let to = edge(random) + [reach, -reach, 0.25 * strips.height][random.below(3)];
    let vy = [0.0, beside(to - y)[random.below(3)], random.signed(1e-3, 30.0) * strips.height]
        [random.below(3)];
    DiscWire { y, vy, number, x: random.between(0.0, 1.0), vx: 0.5, ..DiscWire::default() }
}

fn box_of(strips: &Strips, disc: &DiscWire, reach: f64) -> (usize, usize) {
    let (start, end) = (disc.y, disc.y + disc.vy);
    (rank_of(strips, start.min(end) - reach), rank_of(strips, start.max(end) + reach))
}

/// Which strips a box reaches, and which rank looks at a pair.
pub(super) fn reaches(random: &mut Random, ask: Ask<'_>) {
    for case in 0..1500 {
        let (ranks, rows) = [(1 + case % 5, 10), (300, 700)][usize::from(case % 50 == 0)];
        let strips = strips(random, ranks, rows);
        let reach = [0.125, 1.0, 2.5, 40.0][random.below(4)] * strips.height;
        let disc = flying(random, &strips, reach, 0);
        let found = reached(&strips, &disc, reach);
        let right = box_of(&strips, &disc, reach);
        let question = format!(
            "the first and last rank whose strip a disc at y = {:?} with vy = {:?}, {reach:?} wide, reaches; {strips:?}",
            disc.y, disc.vy
        );
        ask(&question, whole([found.first, found.last]), whole([right.0, right.1]));
    }
    let all = || (0..5).flat_map(|first| (first..5).map(move |last| Reach { first, last }));
    for (a, b) in all().flat_map(|a| all().map(move |b| (a, b))) {
        let found = (0..5).filter(|&rank| looks_at(rank, a, b));
        let both = (0..5).filter(|&rank| a.contains(rank) && b.contains(rank));
        ask(
            &format!("which ranks look at a pair that reaches {a:?} and {b:?}"),
            whole(found),
            whole(both.take(1)),
        );
    }
}

/// None, few and many discs for partners in any order, some of which get none.
pub(super) fn ghosts(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(4097).into_iter().flat_map(|n| [n, n]).chain([70_000]) {
        let ranks = 2 + random.below(6);
        let strips = strips(random, ranks, 12);
        let reach = [0.125, 1.0][random.below(2)] * strips.height;
        let own: Vec<DiscWire> =
            (0..n as u64).map(|k| flying(random, &strips, reach, 3 * k)).collect();
        let mut partners: Vec<usize> = (0..ranks).filter(|_| random.below(3) > 0).collect();
        random.shuffle(&mut partners);
        let boxes: Vec<_> = own.iter().map(|disc| box_of(&strips, disc, reach)).collect();
        let lists = ghosts_for(&partners, &own, &strips, reach);
        let name = format!("{n} discs, {ranks} strips");
        ask(
            &format!("{name}: lists for partners {partners:?}"),
            whole([lists.len()]),
            whole([partners.len()]),
        );
        for (partner, list) in partners.iter().zip(&lists) {
            let right: Vec<DiscWire> = own
                .iter()
                .zip(&boxes)
                .filter(|(_, (first, last))| (first..=last).contains(&partner))
                .map(|(disc, _)| *disc)
                .collect();
            let question = format!(
                "{name}, one of {partners:?}: number, x y vx vy, counts of the ghosts for {partner}"
            );
            ask(&question, wires(list), wires(&right));
        }
    }
}

/// What rank 1 of three may know in the middle of deciding.
fn decisions(random: &mut Random, discs: u32) -> Decisions {
    let (mut numbers, mut reach) = (Vec::new(), Vec::new());
    for number in (0..discs).filter(|_| random.below(4) > 0).collect::<Vec<_>>() {
        numbers.push(2 * number + random.below(2) as u32);
        let (first, last) = [(1, 1), (0, 1), (1, 2), (0, 2), (1, 1)][random.below(5)];
        reach.push(Reach { first, last });
    }
    let found = candidates(random, &numbers);
    let mut decisions = Decisions::default();
    decisions.start::<Lab7>(&numbers, &reach, &found);
    decisions
}

/// Candidates among these discs, no two of the same discs, many of them at exactly the same time.
fn candidates(random: &mut Random, numbers: &[u32]) -> Vec<Candidate> {
    let mut hits = BTreeSet::new();
    for _ in 0..(3 * numbers.len()) / 2 {
        let (a, b) = (numbers[random.below(numbers.len())], numbers[random.below(numbers.len())]);
        hits.insert(if a == b { Hit::WallX(a) } else { Hit::Pair(a.min(b), a.max(b)) });
    }
    let mut all: Vec<Candidate> =
        hits.into_iter().map(|hit| Candidate { time: random.below(8) as f64 / 8.0, hit }).collect();
    random.shuffle(&mut all);
    all
}

/// What other ranks have told of a disc: another candidate of it, that they have none, or nothing yet.
fn rival(random: &mut Random, number: u32, discs: u32) -> Option<Candidate> {
    let other = random.below(2 * discs as usize + 2) as u32;
    let pair = Hit::Pair(other.min(number), other.max(number));
    let hit = if other == number { Hit::WallY(number) } else { pair };
    let candidate = Candidate { time: random.below(8) as f64 / 8.0, hit };
    [Some(candidate), Some(candidate), None, Some(UNKNOWN)][random.below(4)]
}

/// The same decisions by going through all candidates.
fn model_of_certain(decisions: &Decisions) -> Decisions {
    let mut model = decisions.clone();
    model.front.clear();
    for local in decisions.queues.all() {
        let (candidate, slots) = (decisions.named(local), slots_of(local));
        if slots.clone().any(|slot| !model.free[slot]) {
            continue;
        }
        let earlier = |rival: Candidate| order(&candidate, &rival).is_lt();
        let certain = |slot: usize| !model.waits[slot] && model.rivals[slot].is_none_or(earlier);
        if slots.clone().all(certain) {
            slots.for_each(|slot| model.free[slot] = false);
            model.taken.push(candidate);
        } else {
            model.front.extend(slots.clone().any(|slot| !model.waits[slot]).then_some(candidate));
            slots.for_each(|slot| model.waits[slot] = true);
        }
    }
    model.waits.fill(false);
    model
}

/// In rounds: between them other ranks tell of less, and of discs that they have taken.
pub(super) fn certain(random: &mut Random, ask: Ask<'_>) {
    for discs in [1, 2, 3, 9, 33, 300].into_iter().flat_map(|discs| [discs; 20]) {
        let mut decisions = decisions(random, discs + 2);
        for round in 0..4 {
            for slot in 0..decisions.numbers.len() {
                if decisions.reach[slot].is_shared() && random.below(3) > 0 {
                    let rival = rival(random, decisions.numbers[slot], discs);
                    decisions.rivals[slot] = rival.filter(|_| round < 2);
                }
                decisions.free[slot] &= random.below(20) > 0;
            }
            let right = model_of_certain(&decisions);
            take_certain(&mut decisions);
            let name = format!("{discs} discs, round {round}");
            ask(&format!("{name}: what is taken"), sorted(&decisions.taken), sorted(&right.taken));
            ask(&format!("{name}: the front"), sorted(&decisions.front), sorted(&right.front));
            ask(&format!("{name}: which are free"), flags(&decisions.free), flags(&right.free));
            ask(&format!("{name}: which discs wait"), flags(&decisions.waits), flags(&right.waits));
        }
    }
    // Who goes through all of them in every round does not come to an end.
    let found = vec![Candidate { time: 0.5, hit: Hit::Pair(0, 1) }; 1_000_000];
    let mut decisions = Decisions::default();
    decisions.start::<Lab7>(&[0, 1], &[Reach { first: 0, last: 1 }; 2], &found);
    (0..100_000).for_each(|_| take_certain(&mut decisions));
    let question =
        "a million candidates of two discs behind one that stays open in 100000 rounds: the front";
    ask(question, sorted(&decisions.front), sorted(&found[..1]));
}

/// What a partner hears, and what is made of news, twice.
pub(super) fn news(random: &mut Random, ask: Ask<'_>) {
    for (case, discs) in [1, 3, 9, 33, 300].into_iter().cycle().take(200).enumerate() {
        let mut decisions = decisions(random, discs + 2);
        // Not all that are in a queue are open and the earliest of a disc.
        let all: Vec<Candidate> =
            decisions.queues.all().iter().map(|local| decisions.named(local)).collect();
        let (taken, open) = all.split_at(all.len() / 2);
        decisions.taken = taken.to_vec();
        decisions.front = open.iter().copied().filter(|_| random.below(3) > 0).collect();
        decisions.told = random.below(decisions.taken.len() + 1);
        let tell =
            |candidate: &Candidate, taken: f64| [value(candidate).as_slice(), &[taken]].concat();
        for partner in [0, 2] {
            let concerns = |candidate: &&Candidate| {
                let discs = [Some(candidate.hit.first()), candidate.hit.second()];
                let mut slots = decisions.numbers.iter().zip(&decisions.reach);
                slots.any(|(number, reach)| {
                    discs.contains(&Some(*number)) && reach.contains(partner)
                })
            };
            let taken =
                decisions.taken[decisions.told..].iter().filter(concerns).map(|c| tell(c, 1.0));
            let open = decisions.front.iter().filter(concerns).map(|c| tell(c, 0.0));
            let right: Vec<f64> = taken.chain(open).flatten().collect();
            let found = news_for(&decisions, partner);
            let found = found.iter().flat_map(|wire| tell(&wire.into(), truth(wire.is_taken())));
            let question = format!(
                "case {case}, news for rank {partner}: time, kind, discs and whether taken (1) of each"
            );
            ask(&question, found.collect(), right);
        }
        for hearing in 0..3 {
            let numbers: Vec<u32> = (0..2 * discs + 6).collect();
            let mut all = candidates(random, &numbers);
            all.truncate(if hearing == 2 { random.below(2) } else { all.len() });
            let taken: Vec<bool> = all.iter().map(|_| random.below(3) == 0).collect();
            let news: Vec<CandidateWire> = (all.iter().zip(&taken))
                .map(|(c, &is_taken)| if is_taken { CandidateWire::taken(c) } else { c.into() })
                .collect();
            let (mut free, mut rivals) = (decisions.free.clone(), Vec::new());
            for (slot, number) in decisions.numbers.iter().enumerate() {
                let has =
                    |c: &Candidate| [Some(c.hit.first()), c.hit.second()].contains(&Some(*number));
                let of = |is: bool| {
                    all.iter().zip(&taken).filter(move |(c, taken)| has(c) && **taken == is)
                };
                free[slot] &= of(true).next().is_none();
                rivals.push(of(false).map(|(c, _)| *c).min_by(order));
            }
            hear(&mut decisions, &news);
            let flat = |rivals: &[Option<Candidate>]| {
                rivals
                    .iter()
                    .flat_map(|rival| rival.map_or([-1.0; 4], |rival| value(&rival)))
                    .collect::<Vec<f64>>()
            };
            let name = format!("case {case}, news {hearing}, {} candidates", all.len());
            ask(
                &format!("{name}: time, kind, discs of the rival of each disc"),
                flat(&decisions.rivals),
                flat(&rivals),
            );
            ask(&format!("{name}: which discs are free"), flags(&decisions.free), flags(&free));
        }
    }
}

/// Which discs are moved here: own ones and ghosts that are free, that were taken here, or elsewhere.
pub(super) fn moves(random: &mut Random, ask: Ask<'_>) {
    for (case, discs) in [1, 2, 9, 33, 300, 4097].into_iter().cycle().take(90).enumerate() {
        let mut decisions = decisions(random, discs + 2);
        let count = decisions.numbers.len();
        let square = Square { side: 1e5, radius: 1.0 };
        let mut here = Vec::new();
        for slot in 0..count {
            // Two and two stand side by side, and may collide.
            let x = 20.0 + 12.0 * (slot / 2) as f64 + 4.0 * (slot % 2) as f64;
            let vx = if slot.is_multiple_of(2) { 2.5 } else { -2.5 };
            here.push(Disc::new(
                x,
                50.0 + random.between(-0.3, 0.3),
                vx,
                random.between(-1.0, 1.0),
            ));
        }
        let owns: Vec<bool> = (0..count).map(|_| random.below(2) == 0).collect();
        let mut local = Vec::new();
        for slot in (0..count.saturating_sub(1)).step_by(2) {
            let (a, b) = (slot as u32, slot as u32 + 1);
            let pair = Hit::Pair(a, b);
            let hit = [Some(pair), Some(pair), Some(Hit::WallY(a)), None, None][random.below(5)];
            // None: it is free, or was taken elsewhere.
            decisions.free[slot] = hit.is_none() && random.below(2) == 0;
            decisions.free[slot + 1] = hit != Some(pair);
            local.extend(hit.map(|hit| Candidate { time: 0.4, hit }));
        }
        decisions.taken = local.iter().map(|candidate| decisions.named(candidate)).collect();
        let mut right = here.clone();
        let mut moved = vec![false; count];
        for (slot, disc) in
            right.iter_mut().enumerate().filter(|(slot, _)| decisions.free[*slot] && owns[*slot])
        {
            moved[slot] = true;
            (disc.x, disc.y) = (disc.x + disc.vx, disc.y + disc.vy);
        }
        resolve(&local, &mut right, square);
        local.iter().flat_map(slots_of).for_each(|slot| moved[slot] = true);
        let right: Vec<DiscWire> = (0..count)
            .filter(|&slot| moved[slot])
            .map(|slot| DiscWire::new(decisions.numbers[slot] as usize, &right[slot]))
            .collect();
        let found = move_on(&mut here, &owns, &decisions, square);
        let question = format!(
            "case {case}, {count} discs: number, x y vx vy and counts of those that are moved here"
        );
        ask(&question, wires(&found), wires(&right));
    }
}
