/// The pairs that collide, by lab 7's one candidate function.
fn pairs_of(scene: &Scene) -> BTreeSet<[u32; 2]> {
    let discs = scene.discs();
    let n = discs.len() as u32;
    let pairs = (0..n).flat_map(|a| (a + 1..n).map(move |b| [a, b]));
    pairs.filter(|&[a, b]| pair_hit(discs, a, b, scene.radius()).is_some()).collect()
}

/// Everything that collides must be among `found`, each once.
fn nothing_is_lost(name: &str, scene: &Scene, found: &[[u32; 2]]) {
    let expected = pairs_of(scene);
    let mut seen = BTreeSet::new();
    for &[a, b] in found {
        assert!(a < b, "{name}: ({a}, {b}) is no pair of a lower and a higher disc");
        assert!(seen.insert([a, b]), "{name}: discs {a} and {b} were found twice");
    }
    if let Some([a, b]) = expected.difference(&seen).next() {
        let (p, q) = (scene.discs()[*a as usize], scene.discs()[*b as usize]);
        panic!("{name}: discs {a} and {b} collide but were lost: {p:?} and {q:?}");
    }
}

fn filter_loses_nothing<R: Real>(gpu: &Gpu) {
    for (name, scene) in hard::scenes::all() {
        let n = scene.len() as u64;
        let (count, found) = appended::<R>(gpu, ALL_PAIRS, &scene, 0..0, false, n * n);
        assert_eq!(count as usize, found.len(), "{name}: not all were counted");
        nothing_is_lost(name, &scene, &found);
        if ["crowded", "overfull", "thin", "fast"].contains(&name) {
            let (passed, collide) = (found.len(), pairs_of(&scene).len());
            assert!(
                passed <= collide + collide / 20 + 2,
                "{name}: {passed} pairs were passed on, though only {collide} collide"
            );
        }
    }
}

#[test]
fn task_9_2_no_pair_is_lost_in_double_precision() {
    on_device("9.2", |gpu| {
        if has_doubles(gpu) {
            filter_loses_nothing::<f64>(gpu);
        }
    });
}

#[test]
fn task_9_2_no_pair_is_lost_in_single_precision() {
    on_device("9.2", filter_loses_nothing::<f32>);
}

#[test]
fn task_9_2_slow_contacts_are_not_lost_in_single_precision() {
    on_device("9.2", |gpu| {
        let mut random = Random::new(9);
        let scene = slow_contacts(|| random.between(0.0, std::f64::consts::TAU));
        assert_eq!(pairs_of(&scene).len(), 100, "each pair of the scene touches");
        let (_, found) = appended::<f32>(gpu, ALL_PAIRS, &scene, 0..0, false, 10_000);
        nothing_is_lost("slow contacts", &scene, &found);
    });
}

#[test]
fn task_9_2_all_are_counted_though_the_list_is_full() {
    on_device("9.2", |gpu| {
        let scene = hard::scenes::random(100, 0.3, 2.0, 3);
        let (count, list) = appended::<f32>(gpu, ALL_PAIRS, &scene, 0..0, true, 16);
        assert_eq!(count, 4950, "the list has room for 16 candidates, and there are 4950");
        let kinds: BTreeSet<_> = list.iter().collect();
        assert_eq!((list.len(), kinds.len()), (16, 16), "two took the same index: {list:?}");
    });
}

/// A finder on a small launch, so that every invocation has several turns.
fn finder<R: Real>(gpu: &'static Gpu, deal: Deal) -> Finder<Lab9, R> {
    Finder::new(gpu, deal, SMALL, None).unwrap_or_else(|error| panic!("{error}"))
}

/// All candidates that lab 7's functions know of.
fn candidates_of(discs: &[Disc], square: Square) -> BTreeSet<(u64, Hit)> {
    let n = discs.len() as u32;
    let walls = (0..).zip(discs).filter_map(|(i, disc)| wall_hit(i, disc, square));
    let pairs = (0..n).flat_map(|a| (a + 1..n).map(move |b| (a, b)));
    let pairs = pairs.filter_map(|(a, b)| pair_hit(discs, a, b, square.radius));
    walls.chain(pairs).map(key).collect()
}

/// The engine's candidates of its last step must be these, each once.
fn expect_candidates<R: Real>(
    when: &str,
    engine: &HardDiscs<Lab9, R>,
    expected: &BTreeSet<(u64, Hit)>,
) {
    let found: BTreeSet<_> = engine.candidates().iter().copied().map(key).collect();
    assert_eq!(found.len(), engine.candidates().len(), "{when}: a candidate came twice");
    if let Some((_, lost)) = expected.difference(&found).next() {
        panic!("{when}: the candidate {lost:?} is missing");
    }
    if let Some((_, odd)) = found.difference(expected).next() {
        panic!("{when}: {odd:?} is taken for a candidate, but does not collide");
    }
}

fn key(candidate: Candidate) -> (u64, Hit) {
    (candidate.time.to_bits(), candidate.hit)
}

fn same_candidates<R: Real>(gpu: &'static Gpu, deal: Deal) {
    use common::hard::Simulation;
    let mut engine = HardDiscs::new(finder::<R>(gpu, deal), Choice::Host);
    for (name, scene) in hard::scenes::all() {
        engine.load(&scene);
        engine.step();
        expect_candidates(name, &engine, &candidates_of(scene.discs(), Square::of(&scene)));
    }
}

/// The candidates of each of 50 steps of 2,000 discs, which its own state decides.
fn same_candidates_for_50_steps(gpu: &'static Gpu, deal: Deal) {
    use common::hard::Simulation;
    let mut engine = HardDiscs::new(finder::<f64>(gpu, deal), Choice::Host);
    let scene = two_thousand();
    let mut discs = scene.discs().to_vec();
    engine.load(&scene);
    for step in 1..=50 {
        let expected = candidates_of(&discs, Square::of(&scene));
        assert!(expected.len() > 100, "step {step}: the scene shows nothing");
        engine.step();
        expect_candidates(&format!("2,000 discs, step {step}"), &engine, &expected);
        engine.read(0, &mut discs);
    }
}

#[test]
fn task_9_3_the_host_has_the_last_word() {
    confirmed::confirmed(&mut Random::new(93), &mut right::<f64>);
}

#[test]
fn task_9_3_basic_has_the_candidates_of_all_pairs() {
    on_device("9.3", |gpu| {
        same_candidates::<f32>(gpu, Deal::Discs);
        if has_doubles(gpu) {
            same_candidates::<f64>(gpu, Deal::Discs);
            same_candidates_for_50_steps(gpu, Deal::Discs);
        }
    });
}

#[test]
fn task_9_3_the_list_grows_and_starts_again() {
    on_device("9.3", |gpu| {
        let mut finder = finder::<f32>(gpu, Deal::Discs);
        for n in [40, 900, 30, 1200, 1] {
            let scene = hard::scenes::random(n, 0.3, 2.0, n as u64);
            let found = everything_found(&mut finder, &scene);
            let kinds: BTreeSet<_> = found.iter().copied().collect();
            assert_eq!(
                (found.len(), kinds.len()),
                (n * (n + 1) / 2, n * (n + 1) / 2),
                "{n} discs, all pairs of them candidates, and each with the walls"
            );
        }
    });
}

/// Lab 7's sequential program, beside which ours has the same bytes.
fn same_bytes(task: &'static str, variant: &'static str, scene: &Scene, steps: usize) {
    let sequential = hard::Grader::new(task, solution7::VARIANTS, "sequential").run(scene, steps);
    let ours = hard::Grader::new(task, HARD_VARIANTS, variant).run(scene, steps);
    if let Some(words) = difference(&sequential, &ours) {
        panic!("task {task}, variant {variant}, after {steps} steps: {words}");
    }
    let collisions: u64 = ours.iter().map(|d| u64::from(d.pair_collisions)).sum();
    assert!(collisions > 0, "the scene shows nothing: no discs met");
}

fn two_thousand() -> Scene {
    hard::scenes::random(2000, 0.2, 2.0, 50)
}

/// Whether `variant` can run on this machine.
fn runs(variant: &str) -> bool {
    has_adapter() && (!variant.ends_with("f64") || has_doubles(Gpu::shared().expect("it is there")))
}

fn fifty_steps(task: &'static str, variants: &[&'static str]) {
    visit(task);
    for variant in variants.iter().filter(|variant| runs(variant)) {
        same_bytes(task, variant, &two_thousand(), 50);
        let grader = hard::Grader::new(task, HARD_VARIANTS, variant);
        grader.resynchronised("crowded", &hard::scenes::random(400, 0.3, 2.0, 1), 5);
    }
}

#[test]
fn task_9_3_basic_has_the_bytes_of_the_sequential_program() {
    fifty_steps("9.3", &["basic-f64", "basic-f32"]);
}

#[test]
fn task_9_4_every_pair_has_a_number() {
    on_device("9.4", |gpu| {
        let source = format!("{RECTANGLE}{}", Lab9::balanced());
        for n in [2, 3, 4, 5, 6, 7, 31, 64, 101] {
            let rows = 0..(n - 1 + n % 2) as u32;
            let (count, list) = appended::<f32>(gpu, &source, &line(n), rows, true, 6000);
            assert_eq!(count as usize, n * (n - 1) / 2, "{n} discs: the number of pairs");
            let all: BTreeSet<_> = list.iter().copied().collect();
            assert_eq!(all.len(), list.len(), "{n} discs: a pair has two numbers");
            for [a, b] in all {
                assert!(a < b && b < n as u32, "{n} discs: ({a}, {b}) is no pair");
            }
        }
    });
}

#[test]
fn task_9_4_pairs_past_32_bits() {
    on_device("9.4", |gpu| {
        let source = format!("{DEALT}{}", Lab9::balanced());
        let n = 100_000_u32;
        for row in [0, 1, 49_999, 50_000, 85_899, 85_900, 99_998] {
            let (count, list) =
                appended::<f32>(gpu, &source, &line(n as usize), row..row + 1, true, 60_000);
            assert_eq!(count, n / 2, "row {row} of {n} discs: a candidate for each column");
            let found: BTreeSet<_> = list.into_iter().collect();
            // n is even: see the picture in balanced.wgsl.
            let pair = |column: u32| match column < row + 1 {
                true => [column, row + 1],
                false => [n - 1 - column, n - 1 - row],
            };
            let expected: BTreeSet<_> = (0..n / 2).map(pair).collect();
            if let Some(lost) = expected.difference(&found).next() {
                panic!("row {row} of {n} discs: the pair {lost:?} was not looked at");
            }
        }
    });
}

#[test]
fn task_9_4_balanced_has_the_candidates_of_all_pairs() {
    on_device("9.4", |gpu| {
        same_candidates::<f32>(gpu, Deal::Pairs);
        if has_doubles(gpu) {
            same_candidates::<f64>(gpu, Deal::Pairs);
            same_candidates_for_50_steps(gpu, Deal::Pairs);
        }
    });
}

#[test]
fn task_9_4_balanced_has_the_bytes_of_the_sequential_program() {
    fifty_steps("9.4", &["balanced-f64", "balanced-f32"]);
}

#[test]
fn task_9_4_a_launch_beyond_the_limits_is_an_error() {
    visit("9.4");
    if has_adapter() {
        let variant = HARD_VARIANTS.iter().find(|v| v.name == "balanced-f32").expect("it is there");
        let mut config = variant.config();
        variant.set(&mut config, "workgroup", 65_536.0).expect("there is such a parameter");
        let error = (variant.build)(&config).err().expect("no device has such workgroups");
        assert!(error.to_string().contains("workgroup of 65536"), "{error}");
    }
}

#[test]
fn task_9_5_takes_what_the_sort_takes() {
    on_device("9.5", |gpu| {
        let mut chooser =
            Chooser::<Lab9>::new(gpu, 64, None).unwrap_or_else(|error| panic!("{error}"));
        for (seed, count) in [(1, 1), (2, 40), (3, 300), (4, 3000), (5, 200), (6, 5000)] {
            let mut random = Random::new(seed);
            let below = |most| (random.bits() % most as u64) as usize;
            let mut candidates = rivals(count, below);
            let flags = chooser
                .choose(&candidates, 300)
                .unwrap_or_else(|error| panic!("{count} candidates among 300 discs: {error}"));
            let mut found: Vec<_> = candidates
                .iter()
                .zip(&flags)
                .filter(|(_, flag)| **flag == 1)
                .map(|(c, _)| c.hit)
                .collect();
            let (mut free, mut taken) = (vec![true; 300], Vec::new());
            take_in_order(&mut candidates, &mut free, &mut taken);
            let mut expected: Vec<_> = taken.iter().map(|c| c.hit).collect();
            found.sort();
            expected.sort();
            assert_eq!(found, expected, "{count} candidates among 300 discs");
        }
    });
}

#[test]
fn task_9_5_chosen_has_the_bytes_of_the_sequential_program() {
    fifty_steps("9.5", &["chosen-f32"]);
}
