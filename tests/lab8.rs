use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::ExitCode;

use common::hard::{Disc, Scene, Simulation};
use common::{Config, Variant};
use common_mpi::as_rank;
use lab8::{
    CandidateWire, Crew, Deal, DiscWire, Docket, Job, Part, Reach, Strips, UNKNOWN, VARIANTS,
    collect, collided, distance, ghosts_for, hand_out, look_at, looks_at, move_on, offsets, update,
};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::hard::{difference, scenes};
use oracle::mpiexec::{self, ends_when_a_rank_is_killed};
use oracle::{Random, within};
use solution5::Cut;
use solution6::Cuts;
use solution7::{Candidate, Hit, Square, pair_hit, take_in_order};

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
    config: &Config,
    scene: &Scene,
    steps: usize,
) -> Vec<Vec<Disc>> {
    let mut simulation = (variant.build)(config).expect("the variant can be built");
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
    let mut config = variant.config();
    for (parameter, value) in set {
        variant.set(&mut config, parameter, *value).expect("the variant has the parameter");
    }
    for (scene_name, scene) in scenes {
        let found = run(variant, &config, scene, 6);
        if world.rank() > 0 {
            continue;
        }
        let sequential = &solution7::VARIANTS[0];
        let expected = run(sequential, &sequential.config(), scene, 6);
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
fn task_8_2_the_job_and_send_matrices_of_the_report() {
    // Its tables 12 and 13, above the diagonal and without their padding.
    let published =
        [[0, 0, 4, 2, 4], [0, 1, 1, 0, 3], [0, 0, 2, 2, 1], [0, 0, 0, 3, 3], [0, 0, 0, 0, 4]];
    let deal = Deal { workers: 5, offsets: vec![0, 1, 3] };
    let mut found = [[0; 5]; 5];
    for worker in 0..5 {
        for Job { row, column, .. } in deal.jobs(worker) {
            found[row][column] = worker;
        }
    }
    assert_eq!(found, published, "worker of each pair of blocks");
    let send: Vec<_> = (0..5).map(|worker| deal.blocks(worker)).collect();
    let published = [[0, 1, 3], [1, 2, 4], [2, 3, 0], [3, 4, 1], [4, 0, 2]];
    assert_eq!(send, published, "blocks of each worker");
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
            assert_eq!(found, expected, "{job:?}: the candidates, in order of their discs");
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
        for (master_works, factor) in
            [(true, 0), (false, 0), (false, 1), (true, 1), (false, 1), (true, 1), (true, 20_000)]
        {
            let crew = Crew::new(world.size() as usize, master_works);
            let own = crew.worker(rank).map_or_else(Vec::new, |_| list_for(rank, factor));
            // Of short lists the highest rank's comes first, and each other one when the master has
            // had time to take it: who takes what arrives first gets another order.
            if factor == 1 && (1..world.size() - 1).contains(&rank) {
                let _: (u8, _) = world.process_at_rank(rank + 1).receive_with_tag(85);
                std::thread::sleep(std::time::Duration::from_millis(50));
            }
            let found = collect(world, crew, &own);
            if factor == 1 && rank > 1 {
                world.process_at_rank(rank - 1).send_with_tag(&1_u8, 85);
            }
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
        assert_eq!(Candidate::from(&wire), candidate, "a candidate after its way in a message");
        assert!(!wire.is_taken(), "{hit:?} is only a candidate, and arrives as taken");
        assert!(CandidateWire::taken(&candidate).is_taken(), "{hit:?} is taken, and arrives open");
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
    let names = ["pair tests", "candidates", "pair collisions", "wall collisions"];
    on_this_rank(|world| counts_of_sequential(world, "master-workers", &names));
}

/// What a variant counts in three steps, on the root.
fn counters(variant: &Variant<dyn Simulation>, scene: &Scene) -> Vec<(&'static str, f64)> {
    let mut simulation = (variant.build)(&variant.config()).expect("the variant can be built");
    simulation.load(scene);
    (0..3).for_each(|_| simulation.step());
    simulation.counters()
}

fn value(counters: &[(&str, f64)], name: &str) -> f64 {
    counters.iter().find(|c| c.0 == name).unwrap_or_else(|| panic!("nobody counts {name}")).1
}

/// All ranks of the variant together count what lab 7's `sequential` does.
fn counts_of_sequential(world: &SimpleCommunicator, name: &str, names: &[&str]) {
    let scene = scenes::random(400, 0.3, 2.0, 1);
    let found = counters(variant(name), &scene);
    if world.rank() > 0 {
        return;
    }
    let expected = counters(&solution7::VARIANTS[0], &scene);
    for name in names {
        let (found, expected) = (value(&found, name), value(&expected, name));
        assert_eq!(found, expected, "{name} of three steps on {} ranks", world.size());
    }
}

#[test]
fn task_8_7_a_killed_rank_ends_the_job() {
    killed_rank_ends_the_job("8.7", "master-workers");
}

/// Ten rows of height 2 from y = 10 on, cut into strips of the rows that start there.
fn strips(starts: &[usize]) -> Strips {
    Strips { bottom: 10.0, height: 2.0, cuts: Cuts { starts: starts.to_vec() } }
}

/// Disc `number` at height y.
fn at(number: u64, y: f64, vy: f64) -> DiscWire {
    DiscWire { x: 50.0, y, vx: 3.0, vy, number, ..DiscWire::default() }
}

#[test]
fn task_8_8_strips_that_a_box_reaches() {
    // The strips are 10 … 16, 16 … 22 and 22 … 30.
    let strips = strips(&[0, 3, 6, 10]);
    for (y, vy, reach, expected) in [
        (13.0, 0.0, 1.0, (0, 0)),
        (15.5, 0.0, 1.0, (0, 1)),
        (16.5, 0.0, 1.0, (0, 1)),
        (19.0, 2.0, 0.5, (1, 1)),
        (19.0, 2.6, 0.5, (1, 2)),
        (19.0, -2.6, 0.5, (0, 1)),
        (29.0, -14.0, 0.5, (0, 2)),
        (11.0, 50.0, 0.5, (0, 2)),
        (11.0, -50.0, 0.5, (0, 0)),
        (35.0, 1.0, 0.5, (2, 2)),
        (20.0, 0.0, 100.0, (0, 2)),
    ] {
        let found = strips.reached(&at(0, y, vy), reach);
        assert_eq!(
            (found.first, found.last),
            expected,
            "a disc at y = {y} with vy = {vy}, whose box goes {reach} beyond"
        );
    }
}

#[test]
fn task_8_8_an_empty_strip_is_never_reached_first_or_last() {
    let strips = strips(&[0, 0, 5, 5, 10]);
    let found = strips.reached(&at(0, 12.0, 1.0), 1.0);
    assert_eq!((found.first, found.last), (1, 1), "rank 0 has no rows");
    let found = strips.reached(&at(0, 19.0, 2.0), 1.0);
    assert_eq!((found.first, found.last), (1, 3), "rank 2 has no rows");
}

#[test]
fn task_8_8_one_rank_looks_at_a_pair() {
    let all = || (0..5).flat_map(|first| (first..5).map(move |last| Reach { first, last }));
    for a in all() {
        for b in all() {
            let looking: Vec<_> = (0..5).filter(|&rank| looks_at(rank, a, b)).collect();
            let both: Vec<_> =
                (0..5).filter(|&rank| a.contains(rank) && b.contains(rank)).collect();
            assert_eq!(
                looking,
                both[..both.len().min(1)],
                "who looks at a pair that reaches {a:?} and {b:?}, both seen by {both:?}"
            );
        }
    }
}

#[test]
fn task_8_9_ghosts_go_where_their_boxes_reach() {
    let strips = strips(&[0, 3, 6, 10]);
    // The discs of rank 1, between y = 16 and 22.
    let own = [
        at(3, 19.0, 0.0),
        at(4, 21.5, 0.0),
        at(8, 16.2, 0.1),
        at(9, 19.0, 4.0),
        at(12, 19.0, -4.0),
        at(15, 16.1, 5.5),
    ];
    for (partners, expected) in [
        (vec![0, 2], vec![vec![8, 12, 15], vec![4, 9, 15]]),
        (vec![2], vec![vec![4, 9, 15]]),
        (vec![], vec![]),
    ] {
        let lists = ghosts_for(&partners, &own, &strips, 1.0);
        let numbers: Vec<Vec<u64>> =
            lists.iter().map(|list| list.iter().map(|disc| disc.number).collect()).collect();
        assert_eq!(numbers, expected, "the ghosts of rank 1 for {partners:?}");
        for ghost in lists.iter().flatten() {
            assert!(own.contains(ghost), "disc {} is another on the way", ghost.number);
        }
    }
}

/// The dockets of `ranks` ranks for the same candidates among `discs` discs: random ones, many of
/// them at exactly the same time. Each is known to the one rank that looks at its pair, or to the
/// owner of the disc.
fn dockets(seed: u64, ranks: usize, discs: u32) -> (Vec<Docket>, Vec<Candidate>) {
    let mut random = Random::new(seed);
    let mut below = |n: usize| (random.bits() % n as u64) as usize;
    let reach: Vec<Reach> = (0..discs)
        .map(|_| {
            let first = below(ranks);
            Reach { first, last: (first + [0, 0, 1, 2][below(4)]).min(ranks - 1) }
        })
        .collect();
    let mut all = BTreeMap::new();
    for _ in 0..2 * discs {
        let (a, b) = (below(discs as usize), below(discs as usize));
        let (low, high) = (reach[a.min(b)], reach[a.max(b)]);
        let owner = low.first.max(high.first);
        if owner > low.last.min(high.last) {
            continue;
        }
        let hit = match a == b {
            true => Hit::WallX(a as u32),
            false => Hit::Pair(a.min(b) as u32, a.max(b) as u32),
        };
        all.insert(hit, (owner, below(8) as f64 / 8.0));
    }
    let dockets = (0..ranks)
        .map(|rank| {
            let here: Vec<_> = (0..discs).filter(|&d| reach[d as usize].contains(rank)).collect();
            let reach: Vec<_> = here.iter().map(|&d| reach[d as usize]).collect();
            let own = all.iter().filter(|(_, (owner, _))| *owner == rank);
            let open: Vec<_> =
                own.map(|(hit, (_, time))| Candidate { time: *time, hit: *hit }).collect();
            let mut docket = Docket::default();
            docket.start(&here, &reach, &open);
            docket
        })
        .collect();
    let all = all.iter().map(|(hit, (_, time))| Candidate { time: *time, hit: *hit }).collect();
    (dockets, all)
}

/// What happens of `candidates`, by lab 7.
fn decided(mut candidates: Vec<Candidate>, discs: u32) -> BTreeSet<Hit> {
    let (mut free, mut taken) = (vec![true; discs as usize], Vec::new());
    take_in_order(&mut candidates, &mut free, &mut taken);
    taken.iter().map(|candidate| candidate.hit).collect()
}

/// Compares what was taken with what happens, and names the first difference.
fn same_hits(when: &str, taken: &BTreeSet<Hit>, expected: &BTreeSet<Hit>) {
    if let Some(hit) = expected.difference(taken).next() {
        panic!("{when}: {hit:?} happens, and nobody has taken it");
    }
    if let Some(hit) = taken.difference(expected).next() {
        panic!("{when}: {hit:?} was taken; something earlier has one of its discs");
    }
}

#[test]
fn task_8_10_a_rank_alone_is_certain_of_everything() {
    within("8.10", 30, || {
        for seed in 0..100 {
            let (mut dockets, all) = dockets(seed, 1, 40);
            let docket = &mut dockets[0];
            docket.take_certain();
            let taken: BTreeSet<_> = docket.taken.iter().map(|c| c.hit).collect();
            same_hits(&format!("seed {seed}"), &taken, &decided(all, 40));
            assert!(docket.front.is_empty(), "seed {seed}: open at the end: {:?}", docket.front);
            assert!(docket.waits.iter().all(|waits| !waits), "somebody waits at the end");
        }
    });
}

#[test]
fn task_8_10_nothing_is_taken_that_others_could_prevent() {
    within("8.10", 30, || {
        let (here, shared) = (Reach { first: 0, last: 0 }, Reach { first: 0, last: 1 });
        let pair = |time: f64, a: u32, b: u32| Candidate { time, hit: Hit::Pair(a, b) };
        let mut docket = Docket::default();
        // Rank 1 has discs 12 and 15 as well.
        let open = vec![pair(0.5, 10, 12), pair(0.25, 10, 11), pair(0.5, 15, 17)];
        docket.start(&[10, 11, 12, 15, 17], &[here, here, shared, shared, here], &open);
        docket.take_certain();
        assert_eq!(docket.taken, [pair(0.25, 10, 11)], "discs 10 and 11 are known to nobody else");
        assert_eq!(docket.front, [pair(0.5, 15, 17)], "disc 10 is taken; of disc 15 nobody knows");
        assert_eq!(
            docket.free,
            [false, false, true, true, true],
            "of 10, 11, 12, 15, 17: who is free"
        );

        // A rival at the same time, of lower numbers, then of higher ones, then of none.
        for (rival, happens) in [
            (Some(pair(0.5, 15, 16)), false),
            (Some(pair(0.5, 15, 18)), true),
            (Some(pair(0.5, 14, 15)), false),
            (Some(Candidate { time: 0.5, hit: Hit::WallY(15) }), false),
            (Some(pair(0.625, 3, 15)), true),
            (Some(UNKNOWN), false),
            (None, true),
        ] {
            let mut docket = docket.clone();
            docket.rivals[3] = rival;
            docket.take_certain();
            assert_eq!(
                docket.taken.len() == 2,
                happens,
                "discs 15 and 17 at 0.5, where another rank has {rival:?}"
            );
        }
    });
}

#[test]
fn task_8_10_later_candidates_wait_for_earlier_ones() {
    let (here, shared) = (Reach { first: 0, last: 0 }, Reach { first: 0, last: 1 });
    let pair = |time: f64, a: u32, b: u32| Candidate { time, hit: Hit::Pair(a, b) };
    let mut docket = Docket::default();
    // Rank 1 has disc 1 as well: about 1 and 2 nothing is certain, so about 2 and 3 neither.
    let chain = vec![pair(0.5, 3, 4), pair(0.375, 2, 3), pair(0.25, 1, 2), pair(0.75, 1, 3)];
    docket.start(&[1, 2, 3, 4], &[shared, here, here, here], &chain);
    docket.take_certain();
    assert_eq!(docket.taken, [], "the first link of the chain is not certain");
    let front = [pair(0.25, 1, 2), pair(0.375, 2, 3), pair(0.5, 3, 4)];
    assert_eq!(docket.front, front, "the earliest of discs 1 and 2, of 3, of 4");
    docket.rivals[0] = None;
    docket.take_certain();
    assert_eq!(docket.taken, [pair(0.25, 1, 2), pair(0.5, 3, 4)], "one after the other");
    assert_eq!(docket.front, [], "the others cannot happen");
}

#[test]
fn task_8_11_partners_hear_what_concerns_them() {
    let (here, shared) = (Reach { first: 1, last: 1 }, Reach { first: 1, last: 2 });
    let wide = Reach { first: 0, last: 2 };
    let pair = |time: f64, a: u32, b: u32| Candidate { time, hit: Hit::Pair(a, b) };
    let mut docket = Docket::default();
    let open = vec![pair(0.75, 1, 2), pair(0.5, 2, 3), Candidate { time: 0.5, hit: Hit::WallX(4) }];
    docket.start(&[1, 2, 3, 4, 5, 6], &[here, here, shared, wide, here, shared], &open);
    docket.front = open;
    docket.queues.enter(vec![pair(0.875, 3, 5)]); // by their places: discs 4 and 6
    docket.taken = vec![pair(0.0, 5, 6), pair(0.125, 3, 5), pair(0.25, 4, 6), pair(0.375, 1, 5)];
    docket.told = 1;
    let told = |rank: usize| -> Vec<(Hit, bool)> {
        let news = docket.news_for(rank);
        news.iter().map(|wire| (Candidate::from(wire).hit, wire.is_taken())).collect()
    };
    let expected = [(Hit::Pair(4, 6), true), (Hit::WallX(4), false)];
    assert_eq!(told(0), expected, "rank 0 has disc 4 (hit, taken)");
    let expected = [
        (Hit::Pair(3, 5), true),
        (Hit::Pair(4, 6), true),
        (Hit::Pair(2, 3), false),
        (Hit::WallX(4), false),
    ];
    assert_eq!(told(2), expected, "rank 2 has discs 3, 4 and 6 (hit, taken)");
}

#[test]
fn task_8_11_news_replace_what_was_known() {
    let shared = Reach { first: 0, last: 1 };
    let pair = |time: f64, a: u32, b: u32| Candidate { time, hit: Hit::Pair(a, b) };
    let mut docket = Docket::default();
    docket.start(&[2, 5, 7, 9], &[shared; 4], &[]);
    docket.hear(&[
        CandidateWire::from(&pair(0.5, 2, 8)),
        CandidateWire::from(&pair(0.25, 2, 5)),
        CandidateWire::from(&pair(0.75, 1, 5)),
        CandidateWire::taken(&pair(0.125, 3, 9)),
    ]);
    let first = Some(pair(0.25, 2, 5));
    assert_eq!(docket.rivals, [first, first, None, None], "the earliest of each disc");
    assert_eq!(docket.free, [true, true, true, false], "disc 9 was taken");
    docket.hear(&[CandidateWire::from(&pair(0.75, 1, 5))]);
    assert_eq!(docket.rivals, [None, Some(pair(0.75, 1, 5)), None, None], "old rivals are gone");
    assert_eq!(docket.free, [true, true, true, false], "a disc that was taken stays taken");
}

#[test]
fn task_8_11_ranks_together_take_what_one_would() {
    Docket::default().news_for(0);
    within("8.11", 60, || {
        for (seed, ranks) in (0..200).zip((2..6).cycle()) {
            let (mut dockets, all) = dockets(seed, ranks, 40);
            let expected = decided(all, 40);
            let mut rounds = 0;
            loop {
                dockets.iter_mut().for_each(Docket::take_certain);
                if dockets.iter().all(|d| d.front.is_empty() && d.told == d.taken.len()) {
                    break;
                }
                rounds += 1;
                assert!(rounds < 100, "seed {seed}, {ranks} ranks: they never come to an end");
                let news: Vec<Vec<CandidateWire>> = (0..ranks)
                    .map(|to| {
                        let others = (0..ranks).filter(|from| *from != to);
                        others.flat_map(|from| dockets[from].news_for(to)).collect()
                    })
                    .collect();
                for (docket, news) in dockets.iter_mut().zip(&news) {
                    docket.told = docket.taken.len();
                    docket.hear(news);
                }
            }
            let mut taken = BTreeSet::new();
            for (rank, docket) in dockets.iter().enumerate() {
                for candidate in &docket.taken {
                    assert!(
                        taken.insert(candidate.hit),
                        "seed {seed}, {ranks} ranks: {:?} is taken twice, once by rank {rank}",
                        candidate.hit
                    );
                }
            }
            same_hits(&format!("seed {seed}, {ranks} ranks"), &taken, &expected);
        }
    });
}

#[test]
fn task_8_12_each_disc_is_moved_once() {
    let square = Square { side: 100.0, radius: 1.0 };
    let (here, shared) = (Reach { first: 0, last: 0 }, Reach { first: 0, last: 1 });
    let disc = |x: f64, vx: f64| Disc::new(x, 50.0, vx, 0.5);
    // Discs 20 and 21 meet here; 21 is a ghost. Disc 30 was taken elsewhere, 31 is a free ghost.
    let mut discs =
        [disc(10.0, 2.0), disc(30.0, 2.0), disc(34.0, -2.0), disc(60.0, 1.0), disc(80.0, 1.0)];
    let owns = [true, true, false, true, false];
    let mut docket = Docket::default();
    docket.start(&[4, 20, 21, 30, 31], &[here, shared, shared, shared, shared], &[]);
    docket.taken = vec![Candidate { time: 0.5, hit: Hit::Pair(20, 21) }];
    docket.free = vec![true, false, false, false, true];
    let moved = move_on(&mut discs, &owns, &docket, square);
    let numbers: Vec<_> = moved.iter().map(|wire| wire.number).collect();
    assert_eq!(numbers, [4, 20, 21], "the own one that flies, and both of the pair taken here");
    let found: Vec<_> =
        moved.iter().map(|wire| (wire.x, wire.y, wire.vx, wire.pair_collisions)).collect();
    let expected = [(12.0, 50.5, 2.0, 0), (30.0, 50.5, -2.0, 1), (34.0, 50.5, 2.0, 1)];
    assert_eq!(found, expected, "(x, y, vx, pair collisions) of discs 4, 20 and 21");
}

#[test]
fn task_8_13_the_bits_of_one_rank() {
    for ranks in 1..=5 {
        play("8.13", "part_8_13", ranks);
    }
}

#[test]
#[ignore = "a part of task_8_13_the_bits_of_one_rank"]
fn part_8_13() {
    bits("spatial-cuts", &[], &all_scenes());
}

#[test]
fn task_8_13_cuts_that_move() {
    play("8.13", "part_8_13_recut", 4);
}

#[test]
#[ignore = "a part of task_8_13_cuts_that_move"]
fn part_8_13_recut() {
    bits("spatial-cuts", &[("recut", 1.0)], &all_scenes());
}

#[test]
fn task_8_13_counts_every_candidate_once() {
    for ranks in [1, 4] {
        play("8.13", "part_8_13_counts", ranks);
    }
}

#[test]
#[ignore = "a part of task_8_13_counts_every_candidate_once"]
fn part_8_13_counts() {
    let names = ["candidates", "pair collisions", "wall collisions"];
    on_this_rank(|world| counts_of_sequential(world, "spatial-cuts", &names));
}

#[test]
fn task_8_13_only_what_crosses_a_cut_travels() {
    play("8.13", "part_8_13_traffic", 4);
}

#[test]
#[ignore = "a part of task_8_13_only_what_crosses_a_cut_travels"]
fn part_8_13_traffic() {
    on_this_rank(|world| {
        let scene = scenes::random(4000, 0.1, 2.0, 813);
        let found = counters(variant("spatial-cuts"), &scene);
        if world.rank() > 0 {
            return;
        }
        // 40 discs to a unit of height, whose boxes reach less than a unit beyond each of three cuts.
        let ghosts = value(&found, "ghosts per step, all ranks");
        assert!((20.0..240.0).contains(&ghosts), "{ghosts} ghosts a step at three cuts");
        let bytes = value(&found, "bytes per step, busiest rank");
        let whole = 4000.0 * size_of::<DiscWire>() as f64;
        assert!(bytes < whole / 4.0, "a rank sends {bytes} bytes a step; all discs are {whole}");
    });
}

#[test]
fn task_8_13_a_killed_rank_ends_the_job() {
    killed_rank_ends_the_job("8.13", "spatial-cuts");
}
