fn filter_loses_nothing<R: Real>(gpu: &Gpu) {
    for (name, scene) in hard::scenes::all() {
        let strict = ["crowded", "overfull", "thin", "fast"].contains(&name);
        questions::filtered::<R>(gpu, name, &scene, strict, &mut right);
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
    on_device("9.2", |gpu| {
        questions::slow_and_many(gpu, &mut Random::new(92), &mut right);
        filter_loses_nothing::<f32>(gpu);
    });
}

/// A finder on a small launch, so that every invocation has several turns.
fn finder<R: Real>(gpu: &'static Gpu, deal: Deal) -> Finder<Lab9, R> {
    Finder::new(gpu, deal, SMALL, None).unwrap_or_else(|error| panic!("{error}"))
}

fn same_candidates<R: Real>(gpu: &'static Gpu, deal: Deal, steps: usize) {
    let mut engine = HardDiscs::new(finder::<R>(gpu, deal), Choice::Host);
    for (name, scene) in hard::scenes::all() {
        questions::candidates(&mut engine, (name, &scene), 1, &mut right);
    }
    questions::candidates(&mut engine, ("2,000 discs", &two_thousand()), steps, &mut right);
}

#[test]
fn task_9_3_the_host_has_the_last_word() {
    questions::confirmed(&mut Random::new(93), &mut right);
}

#[test]
fn task_9_3_basic_has_the_candidates_of_all_pairs() {
    on_device("9.3", |gpu| {
        same_candidates::<f32>(gpu, Deal::Discs, 1);
        if has_doubles(gpu) {
            same_candidates::<f64>(gpu, Deal::Discs, 50);
        }
    });
}

#[test]
fn task_9_3_invocations_share_the_discs() {
    on_device("9.3", |gpu| questions::turns(gpu, ("find_of_discs", Lab9::basic()), &mut right));
}

#[test]
fn task_9_3_the_list_grows_and_starts_again() {
    on_device("9.3", |gpu| {
        questions::grown(&mut Random::new(93), || finder(gpu, Deal::Discs), &mut right);
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
        questions::rectangles(gpu, &mut Random::new(94), &mut right);
    });
}

#[test]
fn task_9_4_invocations_share_the_pairs() {
    on_device("9.4", |gpu| questions::turns(gpu, ("find_of_pairs", Lab9::balanced()), &mut right));
}

#[test]
fn task_9_4_balanced_has_the_candidates_of_all_pairs() {
    on_device("9.4", |gpu| {
        same_candidates::<f32>(gpu, Deal::Pairs, 1);
        if has_doubles(gpu) {
            same_candidates::<f64>(gpu, Deal::Pairs, 50);
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
        questions::choices(gpu, &mut Random::new(95), &mut right);
    });
}

#[test]
fn task_9_5_chosen_has_the_bytes_of_the_sequential_program() {
    fifty_steps("9.5", &["chosen-f32"]);
}
