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
fn task_7_9_fixed_parts_cover_the_loop() {
    for (n, workers) in [(10, 3), (0, 4), (3, 8), (1000, 7), (5, 1)] {
        let parts: Vec<_> = (0..workers).map(|w| fixed_part(n, workers, w)).collect();
        cover_once(&format!("{workers} workers"), &parts, n);
        let lengths = parts.iter().map(ExactSizeIterator::len);
        let uneven = lengths.clone().max().unwrap() - lengths.min().unwrap();
        assert!(uneven <= 1, "{n} iterations, {workers} workers: {parts:?}");
    }
}

#[test]
fn task_7_9_the_queue_hands_out_everything_once() {
    let next = SharedCount::default();
    let parts: Vec<_> = std::iter::from_fn(|| next_part(&next, 10, 4)).take(9).collect();
    assert_eq!(parts, [0..4, 4..8, 8..10], "10 iterations in chunks of 4");
    let next = SharedCount::default();
    let parts: Vec<_> = std::iter::from_fn(|| next_part(&next, 8, 4)).take(9).collect();
    assert_eq!(parts, [0..4, 4..8], "8 iterations in chunks of 4: no part is empty");
}

#[test]
fn task_7_9_no_thread_comes_between_a_load_and_a_store() {
    cover_once("two workers at once", &between_load_and_store(), 100);
}

#[test]
fn task_7_9_the_locked_queue_hands_out_everything_once() {
    let next = LockedCount::default();
    let parts: Vec<_> = std::iter::from_fn(|| next_part_locked(&next, 10, 4)).take(9).collect();
    assert_eq!(parts, [0..4, 4..8, 8..10], "10 iterations in chunks of 4");
    let next = LockedCount::default();
    let parts: Vec<_> = std::iter::from_fn(|| next_part_locked(&next, 8, 4)).take(9).collect();
    assert_eq!(parts, [0..4, 4..8], "8 iterations in chunks of 4: no part is empty");
}

#[test]
fn task_7_9_no_thread_comes_between_two_critical_sections() {
    let parts = within("7.9", 10, between_critical_sections);
    cover_once("two workers at once", &parts, 100);
}

/// A deque with these parts, the last one on top.
fn deque(parts: &[Range<usize>]) -> Deque {
    let deque = Deque::new_lifo();
    parts.iter().for_each(|part| deque.push(part.clone()));
    deque
}

#[test]
fn task_7_10_own_parts_first_then_the_next_victim() {
    within("7.10", 20, || {
        let own = deque(&[0..4, 4..8]);
        let (first, second) = (deque(&[]), deque(&[20..24, 24..28]));
        let others = [Victim::of(&first), Victim::of(&second)];
        let take = || take_or_steal(&own, &others);
        let taken: Vec<_> = std::iter::from_fn(take).take(9).collect();
        let expected = [4..8, 0..4, 20..24, 24..28];
        assert_eq!(taken, expected, "from the top of the own deque 0..4, 4..8, then stolen");
        first.push(8..9);
        second.push(9..10);
        assert_eq!(take(), Some(8..9), "the first of two victims that have a part");
    });
}

#[test]
fn task_7_10_a_steal_that_met_another_thread_is_tried_again() {
    within("7.10", 20, || {
        let (own, one) = (deque(&[]), deque(&[3..5, 5..9]));
        let others = [Victim::crowded(&one, 2), Victim::of(&own)];
        let found = take_or_steal(&own, &others);
        assert_eq!(found, Some(3..5), "from a victim that first says Retry, twice");
        assert_eq!(
            take_or_steal(&own, &others),
            Some(5..9),
            "from a victim that has one part more"
        );
        assert_eq!(take_or_steal(&own, &others), None, "when all deques are empty");
    });
}

#[test]
fn task_7_10_halves_lie_ready_the_largest_at_the_bottom() {
    let whole = leave_halves(5..9, 4, &Deque::new_lifo());
    assert_eq!(whole, 5..9, "a part of four iterations, of which four are done at once");
    for (part, least, expected) in [
        (0..64, 8, vec![0..8, 8..16, 16..32, 32..64]),
        (100..107, 1, vec![100..101, 101..103, 103..107]),
        (5..10, 4, vec![5..7, 7..10]),
    ] {
        let own = Deque::new_lifo();
        let kept = leave_halves(part.clone(), least, &own);
        let mut parts = vec![kept];
        parts.extend(std::iter::from_fn(|| own.pop()).take(99));
        assert_eq!(parts, expected, "{part:?} halved down to {least}: kept, then from the top");
    }
}

#[test]
fn task_7_10_every_iteration_is_done_once() {
    assert_eq!(take_or_steal(&deque(&[]), &[]), None, "from an empty deque, and no other");
    within("7.10", 10, || {
        for (n, threads, least) in [(1000, 4, 1), (7, 8, 1), (0, 3, 1), (100_000, 3, 16), (9, 1, 2)]
        {
            let times: Vec<_> = (0..n).map(|_| AtomicUsize::new(0)).collect();
            Team::Fresh(threads).run(n, Schedule::Stealing { least }, |_, part| {
                part.for_each(|k| _ = times[k].fetch_add(1, Ordering::Relaxed));
            });
            let wrong = times.iter().position(|times| times.load(Ordering::Relaxed) != 1);
            let found = wrong.map(|k| (k, times[k].load(Ordering::Relaxed)));
            assert_eq!(found, None, "{n} iterations, {threads} threads: done how often, and which");
        }
    });
}

#[test]
fn task_7_10_what_a_busy_worker_left_is_stolen() {
    assert_eq!(take_or_steal(&deque(&[]), &[]), None, "from an empty deque, and no other");
    // Iteration 0 ends when all other iterations have been done, which are half of them its worker's.
    within("7.10", 10, || {
        let done = AtomicUsize::new(0);
        Team::Fresh(2).run(64, Schedule::Stealing { least: 1 }, |_, part| {
            while part.start == 0 && done.load(Ordering::Relaxed) < 63 {
                thread::yield_now();
            }
            done.fetch_add(part.len(), Ordering::Relaxed);
        });
    });
}
