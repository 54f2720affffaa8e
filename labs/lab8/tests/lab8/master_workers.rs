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
                "{workers} workers: no two of the blocks {offsets:?} are {d} apart, so no worker \
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
    let deal = |(workers, offsets): (usize, &[usize])| Deal { workers, offsets: offsets.to_vec() };
    OFFSETS.map(deal).to_vec()
}

#[test]
fn task_8_2_every_pair_of_blocks_is_dealt_once() {
    for deal in deals() {
        let workers = deal.workers;
        let mut seen: BTreeMap<(usize, usize), Vec<(usize, Part)>> = BTreeMap::new();
        for worker in 0..workers {
            for Job { row, column, part } in jobs(&deal, worker) {
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
        for Job { row, column, .. } in jobs(&deal, worker) {
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
            for job in jobs(&deal, worker) {
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
fn task_8_2_workers_have_equally_many_pairs() {
    for deal in deals() {
        let blocks = Cut { rows: 120 * deal.workers, ranks: deal.workers };
        let pairs = |worker: usize| -> usize {
            let jobs = jobs(&deal, worker);
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
        let tests = search_job(discs, &blocks, &job, radius, &mut found);
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
    on_each("8.4", &[1, 2, 4], |world| {
        // Nothing at all, then a few items, then more than fits into a packet.
        for (master_works, factor) in [(false, 0), (false, 1), (true, 1), (false, 20_000)] {
            handed_out(world, master_works, factor);
        }
    });
}

#[test]
fn task_8_4_a_long_list_of_the_masters_own() {
    on_each("8.4", &[1, 3], |world| {
        handed_out(world, true, 20_000);
    });
}

fn handed_out(world: &SimpleCommunicator, master_works: bool, factor: u64) {
    let team = Team::new(world.size() as usize, master_works);
    let (rank, root) = (world.rank(), world.rank() == 0);
    let lists: Vec<_> = if root {
        (0..team.workers).map(|worker| list_for(team.rank(worker), factor)).collect()
    } else {
        Vec::new()
    };
    let found = together("hand_out", || hand_out(world, team, &lists));
    let expected = team.worker(rank).map_or_else(Vec::new, |_| list_for(rank, factor));
    let who = team.worker(rank).map_or("no worker".into(), |worker| format!("worker {worker}"));
    assert_eq!(found.len(), expected.len(), "how many items rank {rank} got, which is {who}");
    assert!(found == expected, "rank {rank} got what is not its own");
}

#[test]
fn task_8_5_the_master_gets_all_lists_in_the_order_of_workers() {
    on_each("8.5", &[1, 2, 4], |world| {
        let rank = world.rank();
        for (master_works, factor) in
            [(true, 0), (false, 0), (false, 1), (true, 1), (false, 1), (true, 1), (true, 20_000)]
        {
            let team = Team::new(world.size() as usize, master_works);
            let own = team.worker(rank).map_or_else(Vec::new, |_| list_for(rank, factor));
            let found = together("collect", || match factor {
                1 => collected_from_above(world, team, &own),
                _ => collect(world, team, &own),
            });
            let expected: Vec<DiscWire> = if rank == 0 {
                (0..team.workers).flat_map(|w| list_for(team.rank(w), factor)).collect()
            } else {
                Vec::new()
            };
            let worker = if team.master_works { "a worker" } else { "no worker" };
            assert_eq!(
                found.len(),
                expected.len(),
                "how many items rank {rank} has in the end; the master is {worker}"
            );
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
fn task_8_6_workers_are_told_which_discs_collided() {
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
        assert_eq!(numbers, expected, "the discs of the blocks {held:?} that have collided");
        for wire in told {
            let disc = &discs[wire.index()];
            assert_eq!(wire, DiscWire::new(wire.index(), disc), "disc {} as it is", wire.number);
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
            let arrives = arrived.iter().find(|wire| wire.index() == number);
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

fn crowd() -> (&'static str, Scene) {
    ("crowded", scenes::random(100, 0.3, 2.0, 1))
}

#[test]
fn task_8_7_six_steps_of_a_crowd() {
    on_each("8.7", &[2], |world| {
        bits_of_sequential(world, "master-workers", &[], &[crowd()]);
    });
}

#[test]
fn task_8_7_a_candidate_survives_its_message() {
    // Not a task of its own, but what the step stands on.
    on_each("8.7", &[2], |world| {
        bits_of_sequential(world, "master-workers", &[], &[crowd()]);
    });
    for hit in [Hit::Corner(3), Hit::WallX(0), Hit::WallY(7), Hit::Pair(4, 2_147_483_646)] {
        let candidate = Candidate { time: 0.1 + 0.2, hit };
        let wire = CandidateWire::from(&candidate);
        assert_eq!(Candidate::from(&wire), candidate, "a candidate after its way in a message");
        assert!(!wire.is_taken(), "{hit:?} is only a candidate, and arrives as taken");
        assert!(CandidateWire::taken(&candidate).is_taken(), "{hit:?} is taken, and arrives open");
    }
}

#[test]
fn task_8_7_the_bits_of_one_rank() {
    on_each("8.7", &[1, 2, 3, 4, 5], |world| {
        bits_of_sequential(world, "master-workers", &[], &all_scenes());
    });
}

#[test]
fn task_8_7_a_master_that_works() {
    on_each("8.7", &[2, 4], |world| {
        bits_of_sequential(world, "master-workers", &[("master-works", 1.0)], &all_scenes());
    });
}

#[test]
fn task_8_7_blocks_again_in_every_step() {
    on_each("8.7", &[3], |world| {
        bits_of_sequential(world, "master-workers", &[("keep", 0.0)], &all_scenes());
    });
}

#[test]
fn task_8_7_the_report_s_program_has_the_same_bits() {
    // It is given, but stands on tasks 8.1 to 8.5.
    let names = ["pair tests", "candidates", "pair collisions", "wall collisions"];
    on_each("8.7", &[1, 2, 3, 4, 5], |world| {
        bits_of_sequential(world, "master-workers", &[], &[crowd()]);
        bits_of_sequential(world, "as-reported", &[], &all_scenes());
        counts_of_sequential(world, "as-reported", &names);
    });
}

#[test]
fn task_8_7_blocks_travel_once() {
    on_each("8.7", &[3], |world| {
        let scene = scenes::random(2000, 0.01, 1.0, 87);
        let found = counters(variant("master-workers"), &scene);
        if world.rank() > 0 {
            return;
        }
        // Each of two workers has all discs.
        let bytes = value(&found, "bytes per step, busiest rank");
        let whole = 2.0 * 2000.0 * size_of::<DiscWire>() as f64;
        assert!(bytes > 0.0, "no step comes after the first: the deal is made again in each");
        assert!(
            bytes < whole / 4.0,
            "after the first step a rank sends {bytes} bytes a step; {whole} are all discs for two \
             workers, which have them"
        );
    });
}

#[test]
fn task_8_7_counts_every_pair_once() {
    let names = ["pair tests", "candidates", "pair collisions", "wall collisions"];
    on_each("8.7", &[1, 3], |world| counts_of_sequential(world, "master-workers", &names));
}

#[test]
fn task_8_7_a_killed_rank_ends_the_job() {
    killed_rank_ends_the_job("8.7", "master-workers");
}
