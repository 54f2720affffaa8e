#[test]
fn task_8_1_few_blocks_make_every_distance() {
    within("8.1", 60, || questions::blocks(&mut Random::new(1), &mut right::<f64>));
}

#[test]
fn task_8_2_a_job_on_each_diagonal() {
    questions::dealt(&mut Random::new(2), &mut right::<f64>);
}

/// Deals whose offsets are given, so that task 8.2 can be tested alone.
fn deals() -> Vec<Deal> {
    let deal = |(workers, offsets): (usize, &[usize])| Deal { workers, offsets: offsets.to_vec() };
    OFFSETS.map(deal).to_vec()
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
fn task_8_3_a_job_is_all_pairs_of_its_blocks() {
    questions::searches(&mut Random::new(3), &mut right::<f64>);
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
        for (master_works, factor) in [(false, 0), (false, 1), (true, 1), (false, 22_000)] {
            handed_out(world, master_works, factor);
        }
    });
}

#[test]
fn task_8_4_a_long_list_of_the_masters_own() {
    on_each("8.4", &[1, 3], |world| {
        handed_out(world, true, 22_000);
    });
}

/// Rank 1 asks for its list when rank 2 has its own: who waits for one worker after the other waits for ever.
#[test]
fn task_8_4_no_worker_waits_for_another() {
    on_each("8.4", &[3], |world| {
        if world.rank() == 1 {
            let _: (i32, _) = world.process_at_rank(2).receive_with_tag(84);
        }
        handed_out(world, false, 22_000);
        if world.rank() == 2 {
            world.process_at_rank(1).send_with_tag(&1, 84);
        }
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
            [(true, 0), (false, 0), (false, 1), (true, 1), (false, 1), (true, 1), (true, 22_000)]
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

#[test]
fn task_8_6_workers_are_told_which_discs_collided() {
    questions::told_discs(&mut Random::new(6), &mut right::<f64>);
}

#[test]
fn task_8_6_workers_move_their_own_discs() {
    questions::updates(&mut Random::new(60), &mut right::<f64>);
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
        let found = counters(variant("master-workers"), &scene, 3);
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
fn task_8_7_messages_do_not_grow() {
    on_each("8.7", &[3], |world| {
        let bytes = |steps| {
            let found = counters(variant("master-workers"), &crowd().1, steps);
            if world.rank() > 0 { 0.0 } else { value(&found, "bytes per step, busiest rank") }
        };
        let (few, many) = (bytes(3), bytes(30));
        assert!(
            many <= 2.0 * few,
            "a rank sends {few} bytes in each of the first steps, and {many} in the mean of 30: what was taken \
             before is told again"
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
