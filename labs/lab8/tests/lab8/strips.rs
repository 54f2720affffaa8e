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
        let found = reached(&strips, &at(0, y, vy), reach);
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
    let found = reached(&strips, &at(0, 12.0, 1.0), 1.0);
    assert_eq!((found.first, found.last), (1, 1), "rank 0 has no rows");
    let found = reached(&strips, &at(0, 19.0, 2.0), 1.0);
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
                "the ranks that look at a pair that reaches {a:?} and {b:?}; the ranks {both:?} have both"
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
            assert!(own.contains(ghost), "disc {} is changed on its way", ghost.number);
        }
    }
}

#[test]
fn task_8_12_each_disc_is_moved_once() {
    let square = Square { side: 100.0, radius: 1.0 };
    let disc = |x: f64, vx: f64| Disc::new(x, 50.0, vx, 0.5);
    // Discs 20 and 21 meet here; 21 is a ghost. Disc 30 was taken elsewhere, 31 is a free ghost.
    let mut discs =
        [disc(10.0, 2.0), disc(30.0, 2.0), disc(34.0, -2.0), disc(60.0, 1.0), disc(80.0, 1.0)];
    let owns = [true, true, false, true, false];
    let mut decisions = Decisions::default();
    decisions.start::<Lab7>(&[4, 20, 21, 30, 31], &[HERE, SHARED, SHARED, SHARED, SHARED], &[]);
    decisions.taken = vec![Candidate { time: 0.5, hit: Hit::Pair(20, 21) }];
    decisions.free = vec![true, false, false, false, true];
    let moved = move_on(&mut discs, &owns, &decisions, square);
    let numbers: Vec<_> = moved.iter().map(|wire| wire.number).collect();
    assert_eq!(numbers, [4, 20, 21], "the own disc that is free, and both of the pair taken here");
    let found: Vec<_> =
        moved.iter().map(|wire| (wire.x, wire.y, wire.vx, wire.pair_collisions)).collect();
    let expected = [(12.0, 50.5, 2.0, 0), (30.0, 50.5, -2.0, 1), (34.0, 50.5, 2.0, 1)];
    assert_eq!(found, expected, "(x, y, vx, pair collisions) of discs 4, 20 and 21");
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
