#[test]
fn task_9_6_prefix_sums_of_any_length() {
    on_device("9.6", |gpu| {
        questions::scans(gpu, &mut Random::new(96), &mut right);
    });
}

fn options(threads: u32) -> Options {
    Options { threads, bin: 1.0, in_flight: 1, statistics: false }
}

#[test]
fn task_9_7_particles_stand_by_bin_and_by_id() {
    on_device("9.7", |gpu| {
        if !has_doubles(gpu) {
            return;
        }
        for threads in [1, 7, 64] {
            let mut engine = SoftDiscs::<Lab9, Double>::new(gpu, options(threads), None)
                .unwrap_or_else(|error| panic!("{error}"));
            for scene in [
                ("dense", scenes::dense()),
                ("crowd", scenes::crowd(3)),
                ("official", scenes::official()),
            ] {
                questions::bins(&mut engine, (scene.0, &scene.1), &mut right);
            }
        }
    });
}

/// A grader of a variant of soft discs, if the machine can run it.
fn grader(task: &'static str, variant: &'static str) -> Option<Grader> {
    visit(task);
    runs(variant).then(|| Grader::new(task, VARIANTS, variant))
}

#[test]
fn task_9_7_steps_in_double_precision() {
    let Some(grader) = grader("9.7", "soft-f64") else { return };
    for threads in [5.0, 64.0] {
        let grader = grader.clone().set("workgroup", threads);
        grader.resynchronised(&scenes::dense(), 20);
        grader.resynchronised_on_each(scenes::edges(), 1);
        grader.resynchronised_on_each((1..=20).map(scenes::crowd).collect(), 2);
    }
    grader.resynchronised_on_each(scenes::fast().to_vec(), 3);
    grader.forces();
    grader.keeps_everyone(&scenes::dense(), 100);
    grader.clone().set("bin", 2.0).resynchronised(&scenes::dense(), 5);
}

#[test]
fn task_9_7_the_same_bits_again() {
    let Some(grader) = grader("9.7", "soft-f64") else { return };
    grader.same_bits_on_threads(&scenes::dense(), 50, &[1]);
    grader.free_run();
}

#[test]
fn task_9_7_statistics() {
    let Some(grader) = grader("9.7", "soft-f64") else { return };
    grader.statistics_of_each_step(&scenes::dense(), 5);
}

/// 2,000 particles in a box of a hundred bins by a hundred: positions that count from its corner in
/// single precision are off by a hundred times as much as those that count from the bin's.
fn wide() -> soft::Scene {
    scenes::lattice_with_jitter(2000, 100.05 * soft::CUTOFF, 1.0, 9)
}

/// One step at a time, from the program's own state, within what the roundings of one step can
/// make: the oracle derives it for each particle from its neighbours (tests/oracle/src/single.rs;
/// book: chapter 9, *What single precision owes*).
#[test]
fn task_9_8_steps_in_single_precision() {
    let Some(grader) = grader("9.8", "soft-f32") else { return };
    let grader = grader.in_single(|scene| Grid::new(scene.size(), scene.len(), 1.0).side);
    grader.resynchronised_on_each(scenes::edges(), 1);
    grader.resynchronised(&scenes::dense(), 20);
    grader.resynchronised(&wide(), 3);
    grader.resynchronised_on_each((1..=20).map(scenes::crowd).collect(), 3);
    grader.resynchronised_on_each(vec![scenes::close_pairs(), scenes::cloud(200, 4.0, 1)], 2);
    grader.resynchronised_on_each(scenes::fast().to_vec(), 3);
}

#[test]
fn task_9_8_all_particles_stay_and_bits_repeat() {
    let Some(grader) = grader("9.8", "soft-f32") else { return };
    grader.keeps_everyone(&scenes::dense(), 200);
    grader.same_bits_on_threads(&scenes::dense(), 50, &[1]);
}
