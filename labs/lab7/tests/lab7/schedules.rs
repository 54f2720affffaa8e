#[test]
fn task_7_8_fixed_parts_cover_the_loop() {
    search::parts(&mut Random::new(78), &mut right);
}

#[test]
fn task_7_8_the_queue_hands_out_everything_once() {
    search::queues(&mut Random::new(780), &mut right);
}

#[test]
fn task_7_8_no_thread_comes_between_a_load_and_a_store() {
    interrupted::parts(&mut right);
}

#[test]
fn task_7_9_each_pair_comes_into_the_list_of_its_worker() {
    search::loops(&mut Random::new(79), &mut right);
}

#[test]
fn task_7_9_rows_come_from_the_queue_where_they_should() {
    search::queued_loops(&mut Random::new(790), &mut right);
    search::fresh_teams(&mut right);
}

#[test]
fn task_7_9_no_thread_does_the_work_of_the_others() {
    search::shared_loops(&mut Random::new(791), &mut right);
}

#[test]
fn task_7_9_the_programs_find_every_pair() {
    outer(2, Team::Fresh(1), Schedule::Static, |_, _, _| ());
    inner(2, Team::Fresh(1), Schedule::Static, |_, _, _| ());
    nested(2, Team::Fresh(1), Schedule::Static, |_, _, _| ());
    for (name, scene) in scenes::all().into_iter().filter(|(_, scene)| scene.len() <= 400) {
        for which in [Which::Outer, Which::Inner, Which::Nested] {
            let workers = Workers::new(2).expect("two threads start");
            let queue = Schedule::Dynamic { chunk: 7 };
            let mut finder = Loops::<Lab7>::new(which, queue, Collect::Own, workers);
            finds_all_pairs(&format!("{which:?}, {name}"), &mut finder, &scene);
        }
    }
}

#[test]
fn task_7_10_each_candidate_has_a_slot_of_its_own() {
    questions::appends(&mut Random::new(710), &mut right);
}

#[test]
fn task_7_10_no_thread_comes_between_two_critical_sections() {
    within("7.10", 10, || interrupted::appends_locked(&mut right));
}

#[test]
fn task_7_10_no_thread_comes_between_a_load_and_a_store() {
    interrupted::appends_atomic(&mut right);
}

#[test]
fn task_7_10_one_list_holds_what_many_lists_hold() {
    let pair = Candidate { time: 0.5, hit: Hit::Pair(0, 1) };
    append_locked(&Slots::default(), &LockedCount::default(), pair);
    append_atomic(&Slots::default(), &SharedCount::default(), pair);
    for (name, scene) in scenes::all() {
        for collect in [Collect::Locked, Collect::Atomic] {
            let workers = Workers::new(3).expect("three threads start");
            let queue = Schedule::Dynamic { chunk: 1 };
            let mut finder = Loops::<Lab7>::new(Which::Outer, queue, collect, workers);
            finds_all_pairs(&format!("{collect:?}, {name}"), &mut finder, &scene);
        }
    }
}
