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
