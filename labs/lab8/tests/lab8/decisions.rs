/// A disc that only rank 0 has, and one that rank 1 has too.
const HERE: Reach = Reach { first: 0, last: 0 };
const SHARED: Reach = Reach { first: 0, last: 1 };

/// Discs a and b at a time.
fn pair(time: f64, a: u32, b: u32) -> Candidate {
    Candidate { time, hit: Hit::Pair(a, b) }
}

/// The decisions of `ranks` ranks for the same candidates among `discs` discs: random ones, many of
/// them at exactly the same time. Each is known to the one rank that looks at its pair, or to the
/// owner of the disc.
fn decisions_of(seed: u64, ranks: usize, discs: u32) -> (Vec<Decisions>, Vec<Candidate>) {
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
    let all_ranks = (0..ranks)
        .map(|rank| {
            let here: Vec<_> = (0..discs).filter(|&d| reach[d as usize].contains(rank)).collect();
            let reach: Vec<_> = here.iter().map(|&d| reach[d as usize]).collect();
            let own = all.iter().filter(|(_, (owner, _))| *owner == rank);
            let open: Vec<_> =
                own.map(|(hit, (_, time))| Candidate { time: *time, hit: *hit }).collect();
            let mut decisions = Decisions::default();
            decisions.start::<Lab7>(&here, &reach, &open);
            decisions
        })
        .collect();
    let all = all.iter().map(|(hit, (_, time))| Candidate { time: *time, hit: *hit }).collect();
    (all_ranks, all)
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
        panic!("{when}: {hit:?} happens, and no rank has taken it");
    }
    if let Some(hit) = taken.difference(expected).next() {
        panic!("{when}: {hit:?} was taken; something earlier has one of its discs");
    }
}

#[test]
fn task_8_10_a_rank_alone_is_certain_of_everything() {
    within("8.10", 30, || {
        for seed in 0..100 {
            let (mut all_ranks, all) = decisions_of(seed, 1, 40);
            let decisions = &mut all_ranks[0];
            take_certain(decisions);
            let taken: BTreeSet<_> = decisions.taken.iter().map(|c| c.hit).collect();
            same_hits(&format!("seed {seed}"), &taken, &decided(all, 40));
            assert!(
                decisions.front.is_empty(),
                "seed {seed}: open at the end: {:?}",
                decisions.front
            );
            assert!(decisions.waits.iter().all(|waits| !waits), "a disc waits at the end");
        }
    });
}

#[test]
fn task_8_10_nothing_is_taken_that_another_rank_could_prevent() {
    within("8.10", 30, || {
        let mut decisions = Decisions::default();
        // Rank 1 has discs 12 and 15 as well.
        let open = vec![pair(0.5, 10, 12), pair(0.25, 10, 11), pair(0.5, 15, 17)];
        decisions.start::<Lab7>(&[10, 11, 12, 15, 17], &[HERE, HERE, SHARED, SHARED, HERE], &open);
        take_certain(&mut decisions);
        assert_eq!(decisions.taken, [pair(0.25, 10, 11)], "only this rank has discs 10 and 11");
        assert_eq!(
            decisions.front,
            [pair(0.5, 15, 17)],
            "disc 10 is taken; of disc 15 rank 1 has not told"
        );
        assert_eq!(
            decisions.free,
            [false, false, true, true, true],
            "of 10, 11, 12, 15, 17: which are free"
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
            let mut decisions = decisions.clone();
            decisions.rivals[3] = rival;
            take_certain(&mut decisions);
            assert_eq!(
                decisions.taken.len() == 2,
                happens,
                "whether it is certain that discs 15 and 17 collide at 0.5, if the rival of 15 is {rival:?}"
            );
        }
    });
}

#[test]
fn task_8_10_later_candidates_wait_for_earlier_ones() {
    let mut decisions = Decisions::default();
    // Rank 1 has disc 1 as well: about 1 and 2 nothing is certain, so about 2 and 3 neither.
    let chain = vec![pair(0.5, 3, 4), pair(0.375, 2, 3), pair(0.25, 1, 2), pair(0.75, 1, 3)];
    decisions.start::<Lab7>(&[1, 2, 3, 4], &[SHARED, HERE, HERE, HERE], &chain);
    take_certain(&mut decisions);
    assert_eq!(decisions.taken, [], "the first link of the chain is not certain");
    let front = [pair(0.25, 1, 2), pair(0.375, 2, 3), pair(0.5, 3, 4)];
    assert_eq!(decisions.front, front, "the earliest of discs 1 and 2, of 3, of 4");
    decisions.rivals[0] = None;
    take_certain(&mut decisions);
    assert_eq!(decisions.taken, [pair(0.25, 1, 2), pair(0.5, 3, 4)], "one after the other");
    assert_eq!(
        decisions.front,
        [],
        "`front` when nothing is open: the other candidates cannot happen"
    );
}

#[test]
fn task_8_11_partners_hear_what_concerns_them() {
    let (here, shared) = (Reach { first: 1, last: 1 }, Reach { first: 1, last: 2 });
    let wide = Reach { first: 0, last: 2 };
    let mut decisions = Decisions::default();
    let open = vec![pair(0.75, 1, 2), pair(0.5, 2, 3), Candidate { time: 0.5, hit: Hit::WallX(4) }];
    decisions.start::<Lab7>(&[1, 2, 3, 4, 5, 6], &[here, here, shared, wide, here, shared], &open);
    decisions.front = open;
    decisions.queues.enter::<Lab7>(vec![pair(0.875, 3, 5)]); // by their slots: discs 4 and 6
    decisions.taken = vec![pair(0.0, 5, 6), pair(0.125, 3, 5), pair(0.25, 4, 6), pair(0.375, 1, 5)];
    decisions.told = 1;
    let told = |rank: usize| -> Vec<(Hit, bool)> {
        let news = news_for(&decisions, rank);
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
    let mut decisions = Decisions::default();
    decisions.start::<Lab7>(&[2, 5, 7, 9], &[SHARED; 4], &[]);
    hear(
        &mut decisions,
        &[
            CandidateWire::from(&pair(0.5, 2, 8)),
            CandidateWire::from(&pair(0.25, 2, 5)),
            CandidateWire::from(&pair(0.75, 1, 5)),
            CandidateWire::taken(&pair(0.125, 3, 9)),
        ],
    );
    let first = Some(pair(0.25, 2, 5));
    assert_eq!(
        decisions.rivals,
        [first, first, None, None],
        "the rivals of discs 2, 5, 7 and 9: the earliest of each that is open"
    );
    assert_eq!(decisions.free, [true, true, true, false], "disc 9 was taken");
    hear(&mut decisions, &[CandidateWire::from(&pair(0.75, 1, 5))]);
    assert_eq!(decisions.rivals, [None, Some(pair(0.75, 1, 5)), None, None], "old rivals are gone");
    assert_eq!(decisions.free, [true, true, true, false], "a disc that was taken stays taken");
}

#[test]
fn task_8_11_ranks_together_take_what_one_would() {
    news_for(&Decisions::default(), 0);
    within("8.11", 60, || {
        for (seed, ranks) in (0..200).zip((2..6).cycle()) {
            let (mut all_ranks, all) = decisions_of(seed, ranks, 40);
            let expected = decided(all, 40);
            let mut rounds = 0;
            loop {
                all_ranks.iter_mut().for_each(take_certain);
                if all_ranks.iter().all(|d| d.front.is_empty() && d.told == d.taken.len()) {
                    break;
                }
                rounds += 1;
                assert!(rounds < 100, "seed {seed}, {ranks} ranks: they never come to an end");
                let news: Vec<Vec<CandidateWire>> = (0..ranks)
                    .map(|to| {
                        let others = (0..ranks).filter(|from| *from != to);
                        others.flat_map(|from| news_for(&all_ranks[from], to)).collect()
                    })
                    .collect();
                for (decisions, news) in all_ranks.iter_mut().zip(&news) {
                    decisions.told = decisions.taken.len();
                    hear(decisions, news);
                }
            }
            let mut taken = BTreeSet::new();
            for (rank, decisions) in all_ranks.iter().enumerate() {
                for candidate in &decisions.taken {
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
