#[test]
fn task_8_1_few_blocks_make_every_distance() {
    within("8.1", 60, || questions::blocks(&mut Random::new(1), &mut right));
}

#[test]
fn task_8_2_a_job_on_each_diagonal() {
    questions::dealt(&mut Random::new(2), &mut right);
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
    questions::searches(&mut Random::new(3), &mut right);
}

#[test]
fn task_8_4_every_worker_gets_its_list() {
    on_each("8.4", &[1, 2, 4], |world| {
        messages::handed_out(world, &mut Random::new(4), &mut right);
    });
}

#[test]
fn task_8_5_the_master_gets_all_lists_in_the_order_of_workers() {
    on_each("8.5", &[1, 2, 4], |world| {
        messages::collected(world, &mut Random::new(5), &mut right);
    });
}

#[test]
fn task_8_6_workers_are_told_which_discs_collided() {
    questions::told_discs(&mut Random::new(6), &mut right);
}

#[test]
fn task_8_6_workers_move_their_own_discs() {
    questions::updates(&mut Random::new(60), &mut right);
}

fn crowd() -> (&'static str, Scene) {
    ("crowded", scenes::random(100, 0.3, 2.0, 1))
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
fn task_8_7_only_what_collided_travels() {
    on_each("8.7", &[1, 2, 3], |world| messages::quiet_steps(world, &mut right));
}

#[test]
fn task_8_7_no_rank_looks_at_nearly_all_pairs() {
    let name = "master-workers";
    on_each("8.7", &[4], |world| {
        messages::shares(world, &mut Random::new(87), name, &mut right);
    });
}

#[test]
fn task_8_7_counts_every_pair_once() {
    let names = ["pair tests", "candidates", "pair collisions", "wall collisions"];
    on_each("8.7", &[1, 3], |world| counts_of_sequential(world, "master-workers", &names));
}

#[test]
fn task_8_7_memory_does_not_grow() {
    on_each("8.7", &[3], |world| messages::long_run(world, "master-workers", &mut right));
}

#[test]
fn task_8_7_a_killed_rank_ends_the_job() {
    killed_rank_ends_the_job("8.7", "master-workers");
}
