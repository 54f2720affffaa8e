//! The worked examples of master and workers.

use std::ops::Range;

use common::hard::{Disc, Scene};
use hard_disc_ranks::{Deal, DiscWire, Job, Part, Team};
use lab8::{VARIANTS, collect, collided, distance, hand_out, jobs, offsets, search_job, update};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::{Ask, Random, Table, ascending, spaced};
use oracle_mpi::{DiscsOnRanks, on_each};
use solution5::Cut;
use solution7::{Candidate, Hit};

use super::candidates::{pair, sorted, words};

pub(crate) fn table_of_offsets(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table =
            Table::new(["workers", "blocks of worker 0", "blocks that are 1, 2, … apart"]);
        for workers in 1..=9 {
            let blocks = offsets(workers);
            let apart = (1..=workers / 2).map(|d| some_apart(&blocks, d, workers));
            table.row([&workers, &spaced(&blocks), &spaced(apart)]);
        }
        table.to_string()
    });
}

/// Returns the first two of these blocks with a distance of `apart`.
fn some_apart(blocks: &[usize], apart: usize, workers: usize) -> String {
    let pairs = blocks.iter().flat_map(|i| blocks.iter().map(move |j| (i, j)));
    let mut there = pairs.filter(|(i, j)| i < j && distance(**i, **j, workers) == apart);
    there.next().map_or("none".into(), |(i, j)| format!("{i}+{j}"))
}

pub(crate) fn table_of_jobs(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["workers", "worker", "its blocks", "its jobs: row+column"]);
        for (workers, offsets) in [(5, vec![0, 1, 3]), (4, vec![0, 1, 2])] {
            let deal = Deal { workers, offsets };
            for worker in 0..workers {
                let jobs = jobs(&deal, worker).into_iter().map(job_words).collect::<Vec<_>>();
                table.row([&workers, &worker, &spaced(deal.blocks(worker)), &jobs.join(", ")]);
            }
        }
        table.to_string()
    });
}

fn job_words(job: Job) -> String {
    let part = match job.part {
        Part::Whole => "",
        Part::First => " first half",
        Part::Second => " second half",
    };
    format!("{}+{}{part}", job.row, job.column)
}

pub(crate) fn table_of_searches(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        // Discs of radius 1 in a row, all at the same height.
        let discs: Vec<Disc> =
            [(10.0, 4.0), (14.0, 0.0), (18.0, -4.0), (22.0, 4.0), (26.0, 0.0), (30.0, -4.0)]
                .map(|(x, vx)| Disc::new(x, 5.0, vx, 0.0))
                .to_vec();
        let mut scene = Table::new(["disc", "x", "vx", "block"]);
        for (number, disc) in discs.iter().enumerate() {
            scene.row([&number, &disc.x, &disc.vx, &(number / 2)]);
        }
        let mut table = Table::new(["job: row+column", "pair tests", "candidates"]);
        let jobs =
            [(0, 0, Part::Whole), (0, 1, Part::Whole), (1, 2, Part::First), (1, 2, Part::Second)];
        for (row, column, part) in jobs {
            let job = Job { row, column, part };
            let mut list = Vec::new();
            let tests = search_job(&discs, &Cut { rows: 6, ranks: 3 }, &job, 1.0, &mut list);
            table.row([&job_words(job), &tests, &candidates(list)]);
        }
        format!("{scene}\n{table}")
    });
}

fn candidates(list: Vec<Candidate>) -> String {
    let words: Vec<String> = sorted(list).iter().map(words).collect();
    if words.is_empty() { "-".into() } else { words.join(", ") }
}

/// Returns discs with these numbers, all at the same position.
fn numbered(numbers: &[usize]) -> Vec<DiscWire> {
    numbers.iter().map(|&number| DiscWire::new(number, &Disc::default())).collect()
}

/// Lists the disc numbers of each list, with a bar between lists.
fn lists_of(lists: &[Vec<DiscWire>]) -> String {
    lists.iter().map(|list| numbers(list)).collect::<Vec<_>>().join("|")
}

fn numbers(list: &[DiscWire]) -> String {
    spaced(list.iter().map(|wire| wire.number))
}

/// Rows of a table about one rank, by name.
type Rows = Vec<(&'static str, String)>;

pub(crate) fn handed_out(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "8.4", &[3], random, |rank, _, ask| {
        let rows = rank.call("hand_out", |world| {
            let mut rows = to_workers(world, false, "master does not work: its lists");
            rows.extend(to_workers(world, true, "master works too: its lists"));
            rows
        });
        let table = rank.columns(&rows);
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

fn to_workers(world: &SimpleCommunicator, master_works: bool, name: &'static str) -> Rows {
    let team = Team::new(3, master_works);
    let all = [&[0, 1, 2][..], &[], &[3, 4]].map(numbered);
    let lists = if world.rank() == 0 { &all[..team.workers] } else { &[] };
    let list = hand_out(world, team, lists);
    vec![(name, lists_of(lists)), ("  arrives", numbers(&list))]
}

pub(crate) fn collected(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "8.5", &[3], random, |rank, _, ask| {
        let rows = rank.call("collect", |world| {
            let mut rows = from_workers(world, false, "master does not work: own list");
            rows.extend(from_workers(world, true, "master works too: own list"));
            rows
        });
        let table = rank.columns(&rows);
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

fn from_workers(world: &SimpleCommunicator, master_works: bool, name: &'static str) -> Rows {
    let team = Team::new(3, master_works);
    let worker = team.worker(world.rank());
    let own = worker.map(|worker| numbered([&[6, 7][..], &[3], &[0, 1]][worker]));
    let own = own.unwrap_or_default();
    let all = collect(world, team, &own);
    vec![(name, numbers(&own)), ("  returned", numbers(&all))]
}

pub(crate) fn after_a_step(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let blocks = Cut { rows: 10, ranks: 5 };
        let deal = Deal { workers: 5, offsets: vec![0, 1, 3] };
        let taken = [pair(0.25, 0, 7), Candidate { time: 0.5, hit: Hit::WallX(4) }];
        // The discs after the step.
        let after: Vec<Disc> =
            (0..10).map(|k| Disc::new(10.0 * f64::from(k) + 5.0, 5.0, -1.0, 0.0)).collect();
        let mut received =
            Table::new(["worker", "its blocks", "its discs", "receives after 0+7 and 4+wall"]);
        for worker in 0..5 {
            let held = deal.blocks(worker);
            let discs = held.iter().flat_map(|&block| blocks.block(block));
            let list = collided(&after, &blocks, &held, &taken);
            let list = ascending(list.iter().map(|wire| wire.number));
            received.row([&worker, &spaced(&held), &spaced(discs), &list]);
        }
        let held: Vec<_> = deal.blocks(0).into_iter().map(|block| blocks.block(block)).collect();
        let arrived = [0, 7].map(|number| DiscWire::new(number, &after[number]));
        format!("{received}\n{}", of_worker_0(&held, &arrived))
    });
}

/// Shows the discs of worker 0 before and after it receives the results of the step.
fn of_worker_0(held: &[Range<usize>], arrived: &[DiscWire]) -> Table {
    let before: Vec<Disc> =
        (0..10).map(|k| Disc::new(10.0 * f64::from(k), 5.0, 2.0, 0.0)).collect();
    let mut discs = before.clone();
    update(&mut discs, held, true, arrived);
    let mut table =
        Table::new(["disc of worker 0", "x, vx before", "x, vx that arrive", "x, vx after"]);
    for number in held.iter().cloned().flatten() {
        let wire = arrived.iter().find(|wire| wire.index() == number);
        let arrives = wire.map_or("-".into(), |wire| format!("{} {}", wire.x, wire.vx));
        let of = |disc: &Disc| format!("{} {}", disc.x, disc.vx);
        table.row([&number, &of(&before[number]), &arrives, &of(&discs[number])]);
    }
    table
}

pub(crate) fn three_steps(random: &mut Random, ask: &mut impl Ask) {
    let runs = DiscsOnRanks::new("8.7", VARIANTS, "master-workers", &[]);
    on_each(ask, "8.7", &[3], random, |rank, _, ask| {
        let table = rank.call("three steps", |world| {
            let discs = [(4.0, 2.0), (8.0, -2.0), (16.0, -2.0), (18.0, 0.0)];
            let discs = discs.map(|(x, vx)| Disc::new(x, 10.0, vx, 0.0));
            let scene =
                Scene::new(20.0, 1.0, discs.to_vec()).expect("all discs are inside the square");
            let mut engine = runs.engine(world);
            engine.load(&scene);
            let mut table = Table::new([
                "step",
                "disc 0: x, vx",
                "disc 1: x, vx",
                "disc 2: x, vx",
                "disc 3: x, vx",
                "pair collisions",
                "wall collisions",
            ]);
            let mut discs = discs.to_vec();
            table.row(row_of(0, &discs).each_ref().map(|cell| cell as _));
            for step in 1..=3 {
                engine.step();
                engine.read(0, &mut discs);
                table.row(row_of(step, &discs).each_ref().map(|cell| cell as _));
            }
            table.to_string()
        });
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

/// Returns a row: the step, x and vx of each of four discs, and the numbers of collisions with
/// discs and with walls.
fn row_of(step: usize, discs: &[Disc]) -> [String; 7] {
    let of = |k: usize| format!("{} {}", discs[k].x + 0.0, discs[k].vx + 0.0);
    let pairs: u32 = discs.iter().map(|disc| disc.pair_collisions).sum();
    let walls: u32 = discs.iter().map(|disc| disc.wall_collisions).sum();
    [step.to_string(), of(0), of(1), of(2), of(3), (pairs / 2).to_string(), walls.to_string()]
}
