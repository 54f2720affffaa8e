#[test]
fn task_8_8_strips_that_a_box_reaches() {
    questions::reaches(&mut Random::new(8), &mut right);
}

#[test]
fn task_8_9_ghosts_go_where_their_boxes_reach() {
    questions::ghosts(&mut Random::new(9), &mut right);
}

#[test]
fn task_8_12_each_disc_is_moved_once() {
    questions::moves(&mut Random::new(12), &mut right);
}

#[test]
fn task_8_13_the_bits_of_one_rank() {
    on_each("8.13", &[1, 2, 3, 4, 5], |world| {
        bits_of_sequential(world, "spatial-cuts", &[], &all_scenes());
    });
}

#[test]
fn task_8_13_cuts_that_move() {
    on_each("8.13", &[4], |world| {
        bits_of_sequential(world, "spatial-cuts", &[("recut", 1.0)], &all_scenes());
    });
}

#[test]
fn task_8_13_counts_every_candidate_once() {
    let names = ["candidates", "pair collisions", "wall collisions"];
    on_each("8.13", &[1, 4], |world| counts_of_sequential(world, "spatial-cuts", &names));
}

#[test]
fn task_8_13_only_what_crosses_a_cut_travels() {
    on_each("8.13", &[4], |world| {
        let scene = scenes::random(4000, 0.1, 2.0, 813);
        let found = counters(variant("spatial-cuts"), &scene, 3);
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
fn task_8_13_no_rank_looks_at_nearly_all_pairs() {
    let name = "spatial-cuts";
    on_each("8.13", &[4], |world| {
        messages::shares(world, &mut Random::new(813), name, &mut right);
    });
}

#[test]
fn task_8_13_ranks_talk_to_the_two_beside_them() {
    on_each("8.13", &[5], |world| messages::neighbours(world, &mut right));
}

#[test]
fn task_8_13_memory_does_not_grow() {
    on_each("8.13", &[3], |world| messages::long_run(world, "spatial-cuts", &mut right));
}

#[test]
fn task_8_13_a_killed_rank_ends_the_job() {
    killed_rank_ends_the_job("8.13", "spatial-cuts");
}
