use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

use common::hard::{Disc, Scene, Simulation};
use common::{Settings, Variant};
use common_mpi::as_rank;
use lab8::{
    CandidateWire, Crew, Deal, DiscWire, Job, Part, VARIANTS, collect, collided, distance,
    hand_out, look_at, offsets, update,
};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::hard::{difference, scenes};
use oracle::mpiexec::{self, ends_when_a_rank_is_killed};
use oracle::within;
use solution5::Cut;
use solution7::{Candidate, Hit, pair_hit};

/// The lab's own program: the student's or the solution's.
const PROGRAM: &str =
    match (option_env!("CARGO_BIN_EXE_lab8"), option_env!("CARGO_BIN_EXE_solution8")) {
        (Some(program), _) | (None, Some(program)) => program,
        (None, None) => panic!("the lab has no program"),
    };

/// Plays one of the ignored tests below on ranks; they test functions that all ranks call together.
fn play(task: &str, part: &str, ranks: usize) {
    mpiexec::Job::part(task, part, ranks).within(20).succeed();
}

fn on_this_rank(check: impl FnOnce(&SimpleCommunicator)) {
    as_rank(|world| {
        check(world);
        ExitCode::SUCCESS
    });
}

fn variant(name: &str) -> &'static Variant<dyn Simulation> {
    VARIANTS.iter().find(|v| v.name == name).expect("the variant is there")
}

/// The discs after each of `steps` steps of a variant, as far as this rank sees them.
fn run(
    variant: &Variant<dyn Simulation>,
    settings: &Settings,
    scene: &Scene,
    steps: usize,
) -> Vec<Vec<Disc>> {
    let mut simulation = (variant.build)(settings).expect("the variant can be built");
    simulation.load(scene);
    (0..steps)
        .map(|_| {
            simulation.step();
            let mut discs = scene.discs().to_vec();
            simulation.read(0, &mut discs);
            discs
        })
        .collect()
}

/// The variant, on all ranks of this job, has the bits of lab 7's `sequential` after every step.
fn bits_of_sequential(
    world: &SimpleCommunicator,
    name: &str,
    set: &[(&str, f64)],
    scenes: &[(&str, Scene)],
) {
    let variant = variant(name);
    let mut settings = variant.settings();
    for (knob, value) in set {
        variant.set(&mut settings, knob, *value).expect("the variant has the knob");
    }
    for (scene_name, scene) in scenes {
        let found = run(variant, &settings, scene, 6);
        if world.rank() > 0 {
            continue;
        }
        let sequential = &solution7::VARIANTS[0];
        let expected = run(sequential, &sequential.settings(), scene, 6);
        for (step, (expected, found)) in (1..).zip(expected.iter().zip(&found)) {
            if let Some(wrong) = difference(expected, found) {
                panic!(
                    "variant {name} {set:?}, {} ranks, scene {scene_name}, step {step}: {wrong}",
                    world.size()
                );
            }
        }
    }
}

/// The oracle's scenes and some that are hard on ranks.
fn all_scenes() -> Vec<(&'static str, Scene)> {
    let mut all = scenes::all();
    // Everybody in the lowest hundredth of the square, and on one line that is no strip at all.
    let low: Vec<_> = (0..40).map(|k| (2.0 * f64::from(k) + 5.0, 1.0, 1.5, 0.2)).collect();
    all.push(("all in one strip", scenes::of(100.0, 1.0, &low)));
    let line: Vec<_> =
        (0..30).map(|k| (3.0 * f64::from(k) + 5.0, 50.0, f64::from(k % 3) - 1.0, 0.0)).collect();
    all.push(("all on one line", scenes::of(100.0, 1.0, &line)));
    // A tower: each disc flies into the one above, across every cut.
    let tower: Vec<_> =
        (0..45).map(|k| (50.0, 2.2 * f64::from(k) + 1.0, 0.0, f64::from(44 - k) / 8.0)).collect();
    all.push(("a tower", scenes::of(100.0, 1.0, &tower)));
    all.push(("two discs", scenes::of(10.0, 1.0, &[(3.0, 3.0, 2.0, 2.0), (7.0, 7.0, -2.0, -2.0)])));
    all
}

fn bits(name: &str, set: &[(&str, f64)], scenes: &[(&str, Scene)]) {
    on_this_rank(|world| bits_of_sequential(world, name, set, scenes));
}

/// A job that simulates `input` by a variant, written to a file in `folder`.
fn job(task: &str, folder: &Path, name: &str, ranks: usize, input: &str) -> mpiexec::Job {
    let path = folder.join("input.txt");
    fs::write(&path, input).expect("the temporary folder is writable");
    mpiexec::Job::new(task, PROGRAM, ranks).args(["--variant", name]).arg(path)
}

fn killed_rank_ends_the_job(task: &str, name: &str) {
    let folder = tempfile::tempdir().expect("the temporary folder is writable");
    let long = |steps: u64| format!("40 30 1 {steps} perf");
    // Only a program that works has a middle to be killed in.
    job(task, folder.path(), name, 3, &long(3)).arg("--json").succeed();
    let out = folder.path().join("never-complete.txt");
    let job = job(task, folder.path(), name, 3, &long(1_000_000_000)).arg("-o").arg(&out);
    let title = format!("task {task}, variant {name}, 3 ranks");
    ends_when_a_rank_is_killed(&title, Path::new(PROGRAM), &job, &out);
}

#[test]
fn bad_input_ends_the_job_with_one_line() {
    let folder = tempfile::tempdir().expect("the temporary folder is writable");
    let input = "3 10 1 5 perf\n0 5 5 0 0\n1 2 2 1 inf\n";
    let ended = job("8.7", folder.path(), "master-workers", 3, input).run();
    assert!(!ended.status.success(), "an input that is no scene was simulated");
    let lines: Vec<_> = ended.stderr.lines().filter(|l| l.starts_with("error")).collect();
    let expected = "input.txt: line 3: vy of disc 1: expected a finite number, found 'inf'";
    assert!(lines.len() == 1 && lines[0].ends_with(expected), "{}", ended.stderr);
}

#[test]
fn task_8_1_every_distance_is_there() {
    for workers in 1..=70 {
        let offsets = within("8.1", 10, move || offsets(workers));
        assert!(
            offsets.iter().all(|&offset| offset < workers),
            "{workers} workers: block {offsets:?} is not there"
        );
        for d in 0..=workers / 2 {
            let there =
                offsets.iter().any(|&p| offsets.iter().any(|&q| distance(p, q, workers) == d));
            assert!(
                there,
                "{workers} workers: no two of the blocks {offsets:?} are {d} apart, so nobody \
                 looks at the pairs of blocks 0 and {d}"
            );
        }
    }
}

#[test]
fn task_8_1_blocks_are_few() {
    for (workers, expected) in [
        (1, vec![0]),
        (2, vec![0, 1]),
        (4, vec![0, 1, 2]),
        (5, vec![0, 1, 2]),
        (6, vec![0, 1, 3]),
        (7, vec![0, 1, 3]),
        (13, vec![0, 1, 3, 9]),
        (16, vec![0, 1, 3, 7, 8]),
    ] {
        let found = within("8.1", 10, move || offsets(workers));
        assert_eq!(found, expected, "the blocks of worker 0 of {workers}");
    }
    let many = within("8.1", 10, || offsets(128));
    assert!(many.len() <= 15, "{} blocks for each of 128 workers; 15 will do", many.len());
}

/// Deals whose offsets are given, so that task 8.2 can be tested alone.
fn deals() -> Vec<Deal> {
    let deal = |workers: usize, offsets: &[usize]| Deal { workers, offsets: offsets.to_vec() };
    vec![
        deal(1, &[0]),
        deal(2, &[0, 1]),
        deal(3, &[0, 1]),
        deal(4, &[0, 1, 2]),
        deal(5, &[0, 1, 3]),
        deal(6, &[0, 1, 3]),
        deal(7, &[0, 1, 3]),
        deal(8, &[0, 1, 3, 4]),
        deal(13, &[0, 1, 3, 9]),
    ]
}

#[test]
fn task_8_2_every_pair_of_blocks_is_dealt_once() {
    for deal in deals() {
        let workers = deal.workers;
        let mut seen: BTreeMap<(usize, usize), Vec<(usize, Part)>> = BTreeMap::new();
        for worker in 0..workers {
            for Job { row, column, part } in deal.jobs(worker) {
                assert!(
                    row <= column && column < workers,
                    "{workers} workers: worker {worker} has a job of blocks ({row}, {column})"
                );
                seen.entry((row, column)).or_default().push((worker, part));
            }
        }
        for row in 0..workers {
            for column in row..workers {
                let dealt = seen.remove(&(row, column)).unwrap_or_default();
                let mut parts: Vec<_> = dealt.iter().map(|(_, part)| *part).collect();
                parts.sort();
                assert!(
                    parts == [Part::Whole] || parts == [Part::First, Part::Second],
                    "{workers} workers: the pairs of blocks {row} and {column} are looked at by \
                     {dealt:?} (worker, part), not once"
                );
            }
        }
    }
}

#[test]
fn task_8_2_a_worker_has_the_blocks_of_its_jobs() {
    for deal in deals() {
        for worker in 0..deal.workers {
            let blocks = deal.blocks(worker);
            for job in deal.jobs(worker) {
                assert!(
                    blocks.contains(&job.row) && blocks.contains(&job.column),
                    "{} workers: worker {worker} has the blocks {blocks:?}, but a job of blocks \
                     ({}, {})",
                    deal.workers,
                    job.row,
                    job.column
                );
            }
        }
    }
}

#[test]
fn task_8_2_everybody_has_as_many_pairs() {
    for deal in deals() {
        let blocks = Cut { rows: 120 * deal.workers, ranks: deal.workers };
        let pairs = |worker: usize| -> usize {
            let jobs = deal.jobs(worker);
            let of = |job: &Job| match (job.row == job.column, job.part) {
                (true, _) => 120 * 119 / 2,
                (_, part) => part.of(blocks.block(job.row)).len() * 120,
            };
            jobs.iter().map(of).sum()
        };
        let all: Vec<_> = (0..deal.workers).map(pairs).collect();
        let n = blocks.rows;
        assert_eq!(
            all,
            vec![n * (n - 1) / 2 / deal.workers; deal.workers],
            "pairs of each of {} workers",
            deal.workers
        );
    }
}

#[test]
fn task_8_3_a_job_is_all_pairs_of_its_blocks() {
    let scene = scenes::random(101, 0.6, 3.0, 83);
    let blocks = Cut { rows: 101, ranks: 4 };
    let (discs, radius) = (scene.discs(), scene.radius());
    for (row, column, part) in [
        (0, 0, Part::Whole),
        (3, 3, Part::Whole),
        (0, 3, Part::Whole),
        (1, 2, Part::First),
        (1, 2, Part::Second),
    ] {
        let job = Job { row, column, part };
        let mut found = Vec::new();
        let tests = look_at(discs, &blocks, &job, radius, &mut found);
        let (mut expected, mut pairs) = (Vec::new(), 0);
        for a in part.of(blocks.block(row)) {
            for b in blocks.block(column).filter(|&b| b > a) {
                pairs += 1;
                expected.extend(pair_hit(discs, a as u32, b as u32, radius));
            }
        }
        assert_eq!(tests, pairs, "{job:?}: pairs looked at");
        let key = |c: &Candidate| c.hit;
        found.sort_by_key(key);
        expected.sort_by_key(key);
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!(found, expected, "{job:?}");
        }
        assert_eq!(found.len(), expected.len(), "{job:?}: number of candidates");
    }
}

/// A list that tells its receiver: `factor` times a number of items that depends on the rank.
fn list_for(rank: i32, factor: u64) -> Vec<DiscWire> {
    let items = 0..(rank as u64 * 7 + 4) % 5 * factor;
    items.map(|number| DiscWire { x: f64::from(rank), number, ..DiscWire::default() }).collect()
}

#[test]
fn task_8_4_every_worker_gets_its_list() {
    for ranks in [1, 2, 4] {
        play("8.4", "part_8_4", ranks);
    }
}

#[test]
#[ignore = "a part of task_8_4_every_worker_gets_its_list"]
fn part_8_4() {
    on_this_rank(|world| {
        // Nothing at all, then a few items, then more than fits into a packet.
        for (master_works, factor) in [(false, 0), (false, 1), (true, 1), (false, 20_000)] {
            handed_out(world, master_works, factor);
        }
    });
}

#[test]
fn task_8_4_a_long_list_of_the_masters_own() {
    play("8.4", "part_8_4_own", 1);
    play("8.4", "part_8_4_own", 3);
}

#[test]
#[ignore = "a part of task_8_4_a_long_list_of_the_masters_own"]
fn part_8_4_own() {
    on_this_rank(|world| handed_out(world, true, 20_000));
}

fn handed_out(world: &SimpleCommunicator, master_works: bool, factor: u64) {
    let crew = Crew::new(world.size() as usize, master_works);
    let (rank, root) = (world.rank(), world.rank() == 0);
    let lists: Vec<_> = if root {
        (0..crew.workers).map(|worker| list_for(crew.rank(worker), factor)).collect()
    } else {
        Vec::new()
    };
    let found = hand_out(world, crew, &lists);
    let expected = crew.worker(rank).map_or_else(Vec::new, |_| list_for(rank, factor));
    assert_eq!(found.len(), expected.len(), "how many items rank {rank} got");
    assert!(found == expected, "rank {rank} got what is not its own");
}

#[test]
fn task_8_5_the_master_gets_all_lists_in_the_order_of_workers() {
    for ranks in [1, 2, 4] {
        play("8.5", "part_8_5", ranks);
    }
}

#[test]
#[ignore = "a part of task_8_5_the_master_gets_all_lists_in_the_order_of_workers"]
fn part_8_5() {
    on_this_rank(|world| {
        let rank = world.rank();
        for (master_works, factor) in [(true, 0), (false, 0), (false, 1), (true, 1), (true, 20_000)]
        {
            let crew = Crew::new(world.size() as usize, master_works);
            let own = crew.worker(rank).map_or_else(Vec::new, |_| list_for(rank, factor));
            // Low ranks come late: who takes what arrives first gets another order.
            std::thread::sleep(std::time::Duration::from_millis(60 / (rank as u64 + 1)));
            let found = collect(world, crew, &own);
            let expected: Vec<DiscWire> = if rank == 0 {
                (0..crew.workers).flat_map(|w| list_for(crew.rank(w), factor)).collect()
            } else {
                Vec::new()
            };
            assert_eq!(found.len(), expected.len(), "how many items rank {rank} has in the end");
            let wrong = found.iter().zip(&expected).find(|(found, expected)| found != expected);
            if let Some((found, expected)) = wrong {
                panic!(
                    "item {} of rank {} stands where item {} of rank {} should",
                    found.number, found.x, expected.number, expected.x
                );
            }
        }
    });
}

fn some_discs(n: usize) -> Vec<Disc> {
    (0..n).map(|k| Disc::new(k as f64, 0.5, 0.25, -1.0 / 3.0)).collect()
}

#[test]
fn task_8_6_workers_are_told_who_has_collided() {
    let discs = some_discs(40);
    let blocks = Cut { rows: 40, ranks: 4 };
    let taken: Vec<Candidate> = [
        Hit::Pair(2, 7),   // both of block 0
        Hit::Pair(5, 14),  // blocks 0 and 1
        Hit::Pair(18, 33), // blocks 1 and 3
        Hit::WallX(9),
        Hit::Corner(20),
        Hit::WallY(39),
    ]
    .map(|hit| Candidate { time: 0.5, hit })
    .to_vec();
    for (held, expected) in [
        (vec![0, 1], vec![2, 5, 7, 9, 14, 18]),
        (vec![1, 2], vec![14, 18, 20]),
        (vec![2, 3], vec![20, 33, 39]),
        (vec![3, 0], vec![2, 5, 7, 9, 33, 39]),
        (vec![], vec![]),
    ] {
        let mut told = collided(&discs, &blocks, &held, &taken);
        told.sort_by_key(|wire| wire.number);
        let numbers: Vec<_> = told.iter().map(|wire| wire.number).collect();
        assert_eq!(numbers, expected, "who has collided of the blocks {held:?}");
        for wire in told {
            let disc = &discs[wire.place()];
            assert_eq!(wire, DiscWire::new(wire.place(), disc), "disc {} as it is", wire.number);
        }
    }
}

#[test]
fn task_8_6_workers_move_their_own_discs() {
    let before = some_discs(30);
    let arrived = [4, 27].map(|number| DiscWire::new(number, &Disc::new(99.0, 98.0, 1.0, 2.0)));
    for moves in [true, false] {
        let mut discs = before.clone();
        update(&mut discs, &[0..10, 20..30], moves, &arrived);
        for (number, (disc, old)) in discs.iter().zip(&before).enumerate() {
            let arrives = arrived.iter().find(|wire| wire.place() == number);
            let expected = match arrives {
                Some(wire) => Disc::from(wire),
                None if moves && !(10..20).contains(&number) => {
                    Disc { x: old.x + old.vx, y: old.y + old.vy, ..*old }
                }
                None => *old,
            };
            assert_eq!(*disc, expected, "disc {number}, moves: {moves}");
        }
    }
}

#[test]
fn task_8_7_a_candidate_survives_its_message() {
    // Not a task of its own, but what the step stands on.
    play("8.7", "part_8_7_one_step", 2);
    for hit in [Hit::Corner(3), Hit::WallX(0), Hit::WallY(7), Hit::Pair(4, 2_147_483_646)] {
        let candidate = Candidate { time: 0.1 + 0.2, hit };
        let wire = CandidateWire::from(&candidate);
        assert_eq!(Candidate::from(&wire), candidate);
        assert!(!wire.is_taken() && CandidateWire::taken(&candidate).is_taken());
    }
}

#[test]
#[ignore = "a part of other tests"]
fn part_8_7_one_step() {
    bits("master-workers", &[], &[("crowded", scenes::random(100, 0.3, 2.0, 1))]);
}

#[test]
fn task_8_7_the_bits_of_one_rank() {
    for ranks in 1..=5 {
        play("8.7", "part_8_7", ranks);
    }
}

#[test]
#[ignore = "a part of task_8_7_the_bits_of_one_rank"]
fn part_8_7() {
    bits("master-workers", &[], &all_scenes());
}

#[test]
fn task_8_7_a_master_who_works() {
    for ranks in [2, 4] {
        play("8.7", "part_8_7_works", ranks);
    }
}

#[test]
#[ignore = "a part of task_8_7_a_master_who_works"]
fn part_8_7_works() {
    bits("master-workers", &[("master-works", 1.0)], &all_scenes());
}

#[test]
fn task_8_7_blocks_anew_in_every_step() {
    play("8.7", "part_8_7_anew", 3);
}

#[test]
#[ignore = "a part of task_8_7_blocks_anew_in_every_step"]
fn part_8_7_anew() {
    bits("master-workers", &[("keep", 0.0)], &all_scenes());
}

#[test]
fn task_8_7_counts_every_pair_once() {
    for ranks in [1, 3] {
        play("8.7", "part_8_7_counts", ranks);
    }
}

#[test]
#[ignore = "a part of task_8_7_counts_every_pair_once"]
fn part_8_7_counts() {
    on_this_rank(|world| {
        let variant = variant("master-workers");
        let scene = scenes::random(400, 0.3, 2.0, 1);
        let mut simulation = (variant.build)(&variant.settings()).expect("it can be built");
        simulation.load(&scene);
        (0..3).for_each(|_| simulation.step());
        let counters = simulation.counters();
        if world.rank() > 0 {
            return;
        }
        let sequential = &solution7::VARIANTS[0];
        let mut expected = (sequential.build)(&sequential.settings()).expect("it can be built");
        expected.load(&scene);
        (0..3).for_each(|_| expected.step());
        for name in ["pair tests", "candidates", "pair collisions", "wall collisions"] {
            let value = |counters: &[(&str, f64)]| counters.iter().find(|c| c.0 == name).unwrap().1;
            let (found, expected) = (value(&counters), value(&expected.counters()));
            assert_eq!(found, expected, "{name} of three steps on {} ranks", world.size());
        }
    });
}

#[test]
fn task_8_7_a_killed_rank_ends_the_job() {
    killed_rank_ends_the_job("8.7", "master-workers");
}
