/// Whole runs of `strips-deep` need tasks 13.2, 13.5 and 13.7 as well; this one is met first.
fn deep(ranks: usize) -> OnRanks {
    assert_eq!(right_steps(&[0.0], CUTOFF), 1, "the only step of an epoch");
    OnRanks::new("13.8", PROGRAM, "strips-deep", ranks)
}

tests! { deep:
    fn task_13_8_the_official_bytes = official_bytes;
    fn task_13_8_dense_scenes_follow_the_model = dense;
    fn task_13_8_a_scene_that_lasts_many_epochs = lasts;
    fn task_13_8_more_ranks_than_rows = few_rows;
    fn task_13_8_fast_particles = fast;
    fn task_13_8_empty_ranks = empty_ranks;
    fn task_13_8_strips_are_cut_anew_when_the_scene_drifts = drifting;
    fn task_13_8_a_killed_rank_ends_the_job = killed;
}

/// Two particles at one position, in strip 1 of two, feel no force. Their speeds differ by next to nothing; so in step
/// 2 they are apart by next to nothing, and in step 3 a push takes each eight cutoffs. One flies across the
/// border, to a particle that is at rest there.
fn a_kick() -> Scene {
    let (size, x) = (60.0 * CUTOFF, 30.2 * CUTOFF);
    let mut particles = scenes::lattice_with_jitter(600, size, 0.01, 8).particles().to_vec();
    let bystander = |p: &Particle| (p.x - x).abs() > 2.5 * CUTOFF;
    particles.retain(bystander);
    let y = 50.0 * CUTOFF;
    let one = Particle { x, y, ..Particle::default() };
    particles.push(Particle { vy: -1.28e-9, ..one });
    particles.push(one);
    let path = |particles: &[Particle]| {
        let mut model = Model::from_state(size, particles.to_vec());
        (0..5).for_each(|_| model.step());
        model.particles[particles.len() - 2]
    };
    let end = path(&particles);
    particles.push(Particle { x: end.x + 0.4 * CUTOFF, y: end.y, ..Particle::default() });
    Scene::new(size, particles).expect("a scene")
}

#[test]
fn task_13_8_a_kick_in_the_middle_of_an_epoch() {
    let scene = a_kick();
    for ranks in [2, 3, 5] {
        let grader = deep(ranks);
        grader.follows_the_model(&scene, 12);
        let [again] = grader.counters(&scene, 12, ["epochs taken again"]);
        assert!(again >= 1.0, "a particle became fast in step 3, and no epoch was taken again");
    }
}

#[test]
fn task_13_8_a_run_repeats_to_the_bit_however_often_one_looks() {
    // In the kick's scene an epoch is taken again.
    for (scene, steps) in [(scenes::dense(), 61), (a_kick(), 13)] {
        let grader = deep(3);
        let often = grader.states(&scene, steps);
        let once = grader.last_state(&scene, steps);
        assert!(once == often[steps - 1], "other bits where each step of {steps} was looked at");
        assert!(
            often == grader.states(&scene, steps),
            "two runs on three ranks gave different bits"
        );
    }
}

#[test]
fn task_13_8_statistics_are_those_of_strips() {
    let words = |variant| OnRanks::new("13.8", PROGRAM, variant, 2).averages(&scenes::dense(), 4);
    deep(2);
    assert_eq!(words("strips-deep"), words("strips"), "statistics of two ranks");
}

#[test]
fn task_13_8_far_fewer_messages_than_steps() {
    let scene = Scene::counter(20_000, 1).expect("a scene");
    for (ranks, most) in [(2, 0.5), (3, 0.6)] {
        let grader = deep(ranks);
        let names = ["steps per epoch", "messages per step, busiest rank", "epochs taken again"];
        let [steps, messages, again] = grader.counters(&scene, 100, names);
        assert!(steps > 4.0, "an epoch had {steps} steps");
        // A message to each partner and a word of all ranks, for all steps of an epoch.
        assert!(messages < most, "{messages} messages in a step on {ranks} ranks");
        assert!(
            again <= 2.0,
            "{again} epochs of 100 steps were taken again where no particle is kicked"
        );
    }
}
