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
fn task_8_10_what_is_certain_is_taken() {
    within("8.10", 60, || questions::certain(&mut Random::new(10), &mut right));
}

#[test]
fn task_8_11_partners_hear_what_concerns_them() {
    questions::news(&mut Random::new(11), &mut right);
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
