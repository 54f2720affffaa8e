/// Each part begins where the one before it ended, and the last one ends with the loop.
fn cover_once(schedule: &str, parts: &[Range<usize>], n: usize) {
    let mut next = 0;
    for part in parts.iter().filter(|part| !part.is_empty()) {
        let how = if part.start < next { "is done twice" } else { "belongs to no part" };
        let lost = part.start.min(next);
        assert!(
            part.start == next,
            "{schedule}, {n} iterations in {parts:?}: iteration {lost} {how}"
        );
        next = part.end;
    }
    assert_eq!(next, n, "{schedule}, {n} iterations in {parts:?}: where the last part ends");
}

#[test]
fn task_7_8_fixed_parts_cover_the_loop() {
    for (n, workers) in [(10, 3), (0, 4), (3, 8), (1000, 7), (5, 1)] {
        let parts: Vec<_> = (0..workers).map(|w| fixed_part(n, workers, w)).collect();
        cover_once(&format!("{workers} workers"), &parts, n);
        let lengths = parts.iter().map(ExactSizeIterator::len);
        let uneven = lengths.clone().max().unwrap() - lengths.min().unwrap();
        assert!(uneven <= 1, "{n} iterations, {workers} workers: {parts:?}");
    }
}

#[test]
fn task_7_8_the_queue_hands_out_everything_once() {
    let next = SharedCount::default();
    let parts: Vec<_> = std::iter::from_fn(|| next_part(&next, 10, 4)).take(9).collect();
    assert_eq!(parts, [0..4, 4..8, 8..10], "10 iterations in chunks of 4");
    let next = SharedCount::default();
    let parts: Vec<_> = std::iter::from_fn(|| next_part(&next, 8, 4)).take(9).collect();
    assert_eq!(parts, [0..4, 4..8], "8 iterations in chunks of 4: no part is empty");
}

#[test]
fn task_7_8_no_thread_comes_between_a_load_and_a_store() {
    cover_once("two workers at once", &between_load_and_store(), 100);
}

#[test]
fn task_7_9_the_outer_loop_is_dealt_out_in_whole_rows() {
    for (n, workers) in [(1, 2), (10, 3), (33, 4), (3, 8)] {
        let looks = Looks::of(|look| outer(n, Team::Fresh(workers), Schedule::Static, look));
        looks.cover_all_pairs("outer", n);
        for (list, a, partners) in looks.in_order() {
            assert_eq!(partners, a + 1..n, "outer, {n} discs: the partners of disc {a}");
            let rows = fixed_part(n, workers, list);
            let what = "the rows that belong to this list's worker";
            assert!(
                rows.contains(&a),
                "outer, {n} discs: list {list} has disc {a}; {what}: {rows:?}"
            );
        }
    }
}

#[test]
fn task_7_9_the_inner_loop_is_dealt_out_row_by_row() {
    for (n, workers) in [(1, 2), (10, 3), (33, 4), (3, 8)] {
        let looks = Looks::of(|look| inner(n, Team::Fresh(workers), Schedule::Static, look));
        looks.cover_all_pairs("inner", n);
        for (list, a, partners) in looks.in_order() {
            let part = fixed_part(n - a - 1, workers, list);
            let expected = a + 1 + part.start..a + 1 + part.end;
            assert_eq!(partners, expected, "inner, {n} discs: disc {a}'s partners for list {list}");
        }
    }
}

#[test]
fn task_7_9_both_loops_are_dealt_out_each_row_to_a_team_of_its_own() {
    for (n, workers) in [(1, 2), (10, 3), (33, 4), (3, 8)] {
        let looks = Looks::of(|look| nested(n, Team::Fresh(workers), Schedule::Static, look));
        looks.cover_all_pairs("nested", n);
        for (list, a, partners) in looks.in_order() {
            let (worker, member) = (list / workers, list % workers);
            let rows = fixed_part(n, workers, worker);
            assert!(
                rows.contains(&a),
                "nested, {n} discs, teams of {workers}: list {list} has a part of disc {a}'s row, and is \
                 member {member}'s of worker {worker}, whose rows are {rows:?}"
            );
            let part = fixed_part(n - a - 1, workers, member);
            let expected = a + 1 + part.start..a + 1 + part.end;
            assert_eq!(
                partners, expected,
                "nested, {n} discs: disc {a}'s partners for list {list}"
            );
        }
    }
}

#[test]
fn task_7_9_rows_come_from_the_queue_where_they_should() {
    let queue = Schedule::Dynamic { chunk: 3 };
    let outer = Looks::of(|look| outer(40, Team::Fresh(3), queue, look));
    outer.cover_all_pairs("outer, from a queue", 40);
    let inner = Looks::of(|look| inner(40, Team::Fresh(3), queue, look));
    inner.cover_all_pairs("inner, from a queue", 40);
    let longest = inner.in_order().map(|(.., partners)| partners.len()).max();
    assert_eq!(longest, Some(3), "inner, in chunks of 3: partners that are looked at in one go");
    let nested = Looks::of(|look| nested(40, Team::Fresh(3), queue, look));
    nested.cover_all_pairs("nested, from a queue", 40);
}

#[test]
fn task_7_9_the_programs_find_every_pair() {
    Looks::of(|look| outer(2, Team::Fresh(1), Schedule::Static, look));
    Looks::of(|look| inner(2, Team::Fresh(1), Schedule::Static, look));
    Looks::of(|look| nested(2, Team::Fresh(1), Schedule::Static, look));
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
    let candidates: Vec<_> = (0..10_000).map(|k| candidate(0.25, Hit::Pair(k, k + 1))).collect();
    let (list, locked, atomic) = (Slots::default(), LockedCount::default(), SharedCount::default());
    for candidate in &candidates {
        append_locked(&list, &locked, *candidate);
    }
    assert_eq!(locked.locked(|count| *count), 10_000, "slots used of the locked list");
    same_candidates("appended under a lock", &list.first(10_000).collect::<Vec<_>>(), &candidates);
    let list = Slots::default();
    for candidate in &candidates {
        append_atomic(&list, &atomic, *candidate);
    }
    assert_eq!(atomic.load(), 10_000, "slots used of the list without a lock");
    same_candidates(
        "appended without a lock",
        &list.first(10_000).collect::<Vec<_>>(),
        &candidates,
    );
}

#[test]
fn task_7_10_no_thread_comes_between_two_critical_sections() {
    let found = within("7.10", 10, appended_between_critical_sections);
    let what = "three candidates appended, one of them by another worker when the lock was free: which discs";
    assert_eq!(found, [1, 2, 3], "{what}");
}

#[test]
fn task_7_10_no_thread_comes_between_a_load_and_a_store() {
    let found = appended_between_load_and_store();
    let what = "three candidates appended, one of them by another worker between two operations: which discs";
    assert_eq!(found, [1, 2, 3], "{what}");
}

#[test]
fn task_7_10_one_list_holds_what_many_lists_hold() {
    let pair = candidate(0.5, Hit::Pair(0, 1));
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

/// What a loop asked to look at: into which list, which disc, with which partners.
struct Looks(Vec<(usize, usize, Range<usize>)>);

impl Looks {
    fn of(share: impl FnOnce(&(dyn Fn(usize, usize, Range<usize>) + Sync))) -> Self {
        let looks = Mutex::new(Vec::new());
        share(&|list, a, partners| looks.lock().unwrap().push((list, a, partners)));
        let mut looks = looks.into_inner().unwrap();
        looks.retain(|(_, _, partners)| !partners.is_empty());
        looks.sort_by_key(|(list, a, partners)| (*a, partners.start, *list));
        Self(looks)
    }

    fn in_order(&self) -> impl Iterator<Item = (usize, usize, Range<usize>)> {
        self.0.iter().cloned()
    }

    fn cover_all_pairs(&self, name: &str, n: usize) {
        let mut times = vec![0; n * n];
        for (_, a, partners) in self.in_order() {
            for b in partners {
                assert!(a < n && b < n, "{name}, {n} discs: disc {a} was paired with disc {b}");
                times[a * n + b] += 1;
            }
        }
        for a in 0..n {
            for b in 0..n {
                let what =
                    format!("{name}, {n} discs: how often disc {a} was paired with disc {b}");
                assert_eq!(times[a * n + b], i32::from(a < b), "{what}");
            }
        }
    }
}
