use lab10::VARIANTS;
use oracle::{Grader, scenes};

fn grader(task: &'static str, variant: &str) -> Grader {
    Grader::new(task, VARIANTS, variant)
}

#[test]
fn task_10_4_verlet_follows_the_model() {
    let grader = grader("10.4", "verlet");
    grader.resynchronised(&scenes::official(), 200);
    grader.resynchronised(&scenes::dense(), 20);
    grader.resynchronised_on_each(scenes::edges(), 3);
    grader.resynchronised(&scenes::close_pairs(), 20);
    grader.resynchronised_on_each(scenes::fast().to_vec(), 20);
}

#[test]
fn task_10_4_verlet_official() {
    grader("10.4", "verlet").official_bytes();
}

#[test]
fn task_10_4_verlet_crowds_and_forces() {
    grader("10.4", "verlet").crowds();
    grader("10.4", "verlet").forces();
}

#[test]
fn task_10_4_verlet_threads() {
    grader("10.4", "verlet").same_bits_on_threads(
        &scenes::cloud(5000, 80.0, 3),
        30,
        &[1, 2, 3, 4, 8],
    );
}

#[test]
fn task_10_5_planned_follows_the_model() {
    let grader = grader("10.5", "planned");
    grader.resynchronised(&scenes::official(), 200);
    grader.resynchronised(&scenes::dense(), 20);
    grader.resynchronised_on_each(scenes::edges(), 3);
    grader.resynchronised(&scenes::close_pairs(), 20);
    grader.resynchronised_on_each(scenes::fast().to_vec(), 20);
}

#[test]
fn task_10_5_windows_have_the_bits_of_all_pairs() {
    for window in [1.0, 2.0, 4.0, 8.0, 16.0] {
        let grader = grader("10.5", "planned").set("window", window);
        grader.bits_of_all_pairs(&scenes::official(), 400);
        grader.bits_of_all_pairs(&scenes::dense(), 40);
        grader.bits_of_all_pairs(&scenes::close_pairs(), 40);
        for scene in scenes::fast() {
            grader.bits_of_all_pairs(&scene, 40);
        }
        grader.bits_of_all_pairs(&scenes::crowd(1), 20);
        grader.bits_of_all_pairs(&scenes::cloud(300, 30.0, 5), 100);
    }
}

#[test]
fn task_10_5_planned_official() {
    grader("10.5", "planned").official_bytes();
}

#[test]
fn task_10_5_planned_crowds_and_forces() {
    grader("10.5", "planned").crowds();
    grader("10.5", "planned").forces();
}

#[test]
fn task_10_5_planned_threads() {
    for window in [0.0, 4.0, 8.0] {
        grader("10.5", "planned")
            .set("window", window)
            .same_bits_on_threads(&scenes::cloud(5000, 200.0, 3), 30, &[1, 2, 3, 4, 8]);
    }
}
