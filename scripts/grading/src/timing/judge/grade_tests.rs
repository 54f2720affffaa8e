//! Tests of grades, with artificial times.

use super::{is_noisy, judge};
use crate::record::{Kind, Outcome, Record, Run, Verdict, Whose};
use crate::timing::is_done_on;
use crate::timing::plan::plan;
use lab_kit::Facts;
use lab_kit::facts::Timed;

/// Returns the rubric of a lab with one measure.
fn rubric(kind: Kind) -> Facts {
    match kind {
        Kind::Complexity => Facts { complexity: timed(64_000), ..Facts::default() },
        Kind::Scaling => Facts { scaling: timed(100_000), ..Facts::default() },
        Kind::Speed => Facts { speed: timed(100_000), ..Facts::default() },
    }
}

fn timed(n: usize) -> Option<Timed> {
    Some(Timed { points: 20.0, variant: "sorted".into(), n })
}

/// Returns a record of runs that take `seconds`, a function of program, n and workers.
fn record(kind: Kind, cores: usize, seconds: impl Fn(Whose, f64, f64) -> Vec<f64>) -> Record {
    let mut record = Record::sample();
    record.found.timed = true;
    record.found.runs = plan(&rubric(kind), record.found.seed, cores);
    for run in &mut record.found.runs {
        run.seconds = vec![0.0; 5];
        if run.steps > 0 {
            run.seconds = seconds(run.whose, run.n as f64, run.workers as f64);
        }
        // Making a scene takes time too.
        run.seconds.iter_mut().for_each(|take| *take += 0.01);
    }
    record
}

/// Returns a record of a submission that takes `own` seconds for n particles. The solution takes
/// 2e-6 n seconds.
fn complexity(own: impl Fn(f64) -> f64) -> Record {
    record(Kind::Complexity, 2, |whose, n, _| {
        vec![if whose == Whose::Own { own(n) } else { 2e-6 * n }; 5]
    })
}

/// Returns a record of a submission that takes `own` seconds for n particles and p workers. The
/// serial program takes 2e-6 n seconds, and the solution takes this time divided by p.
fn scaling(own: impl Fn(f64, f64) -> f64) -> Record {
    record(Kind::Scaling, 2, |whose, n, p| match whose {
        Whose::Own => vec![own(n, p); 5],
        Whose::Solution => vec![2e-6 * n / p; 5],
        Whose::Serial => vec![2e-6 * n; 5],
    })
}

/// Returns the runs of a program that make steps.
fn runs_of(record: &mut Record, whose: Whose) -> impl Iterator<Item = &mut Run> {
    record.found.runs.iter_mut().filter(move |run| run.whose == whose && run.steps > 0)
}

fn graded(record: &Record, kind: Kind) -> (Verdict, Option<f64>, String) {
    let measure = judge(&record.found, &rubric(kind)).remove(0);
    assert_eq!(measure.kind, kind);
    (measure.verdict, measure.grade, measure.message)
}

fn grade_of_complexity(own: impl Fn(f64) -> f64) -> (f64, String) {
    let (_, grade, words) = graded(&complexity(own), Kind::Complexity);
    (grade.unwrap(), words)
}

#[test]
fn the_slope_decides() {
    assert_eq!(grade_of_complexity(|n| 4e-6 * n).0, 100.0);
    assert!(grade_of_complexity(|n| 1e-9 * n * n).0 < 1e-6);
    let (grade, words) = grade_of_complexity(|n| 1e-7 * n.powf(1.4));
    assert!((grade - 87.5).abs() < 1e-6 && words.contains("power 1.40"), "{words}");
}

#[test]
fn to_dawdle_on_small_scenes_makes_no_line_flat() {
    // The program computes all pairs. On small scenes it waits until four seconds have passed,
    // which is about its time on the largest scene.
    let (grade, words) = grade_of_complexity(|n| (1e-9 * n * n).max(4.0));
    assert!(grade < 30.0 && words.contains("begins at the solution's"), "{words}");
    let (grade, _) = grade_of_complexity(|n| 2e-6 * n + 1.0);
    assert_eq!(grade, 100.0, "slow, and yet it grows with n");
}

#[test]
fn to_sleep_on_small_scenes_makes_no_line_flat() {
    // The program is quadratic. On the largest scene it takes about five times as long as the
    // solution. On smaller scenes it sleeps until it has taken five times as long there, too.
    let work = |n: f64| 1.5e-10 * n * n;
    let mut record = complexity(|n| work(n).max(1e-5 * n));
    assert_eq!(graded(&record, Kind::Complexity).1, Some(100.0), "by the clock alone");
    for run in runs_of(&mut record, Whose::Own) {
        run.processors = Some(5.0 * work(run.n as f64));
    }
    let (_, given, words) = graded(&record, Kind::Complexity);
    assert!(given.unwrap() < 30.0 && words.contains("idle at n = 1"), "{words}");
}

#[test]
fn who_is_too_slow_for_the_large_scenes_is_not_flat_either() {
    let mut record = complexity(|n| 1e-9 * n * n);
    for run in runs_of(&mut record, Whose::Own).filter(|run| run.n >= 32_000) {
        (run.outcome, run.seconds) = (Outcome::TooSlow, vec![8.0]);
        run.message = "no result within 8 s".into();
    }
    let (verdict, grade, words) = graded(&record, Kind::Complexity);
    assert!(verdict == Verdict::Graded && grade.unwrap() < 1e-6, "{words}");
    assert!(words.contains("there was no result"), "{words}");
}

#[test]
fn efficiency_is_measured_against_the_serial_program() {
    let (_, grade, words) = graded(&scaling(|n, p| 2e-6 * n / p), Kind::Scaling);
    assert_eq!(grade, Some(100.0), "{words}");
    let (_, grade, words) = graded(&scaling(|n, p| 2e-6 * n / (0.65 * p)), Kind::Scaling);
    assert!((grade.unwrap() - 87.5).abs() < 1e-6, "{words}");
    assert!(words.contains("strong 0.65, weak 0.65; the solution's: 1.00"), "{words}");
}

#[test]
fn one_worker_at_work_does_not_scale() {
    let (verdict, grade, words) = graded(&scaling(|n, _| 2e-6 * n), Kind::Scaling);
    assert_eq!((verdict, grade), (Verdict::Graded, Some(0.0)), "{words}");
    assert!(words.contains("no faster than one"), "{words}");
    // This program uses only one worker, but it takes half the time of the grader's serial program.
    // So its times alone look as if the program were parallel.
    let mut record = scaling(|n, _| 1e-6 * n);
    assert_eq!(graded(&record, Kind::Scaling).1, Some(100.0));
    for run in runs_of(&mut record, Whose::Own) {
        run.processors = Some(1.05 * run.seconds.iter().sum::<f64>());
    }
    assert_eq!(graded(&record, Kind::Scaling).1, Some(0.0));
    // The machine does other work, so the solution's workers get little more than one processor.
    for run in runs_of(&mut record, Whose::Solution) {
        run.processors = Some(1.15 * run.seconds.iter().sum::<f64>());
    }
    assert_eq!(graded(&record, Kind::Scaling).0, Verdict::TooNoisy);
}

#[test]
fn where_the_solution_does_not_scale_nobody_loses() {
    let mut record = scaling(|n, _| 1.8e-6 * n);
    for run in runs_of(&mut record, Whose::Solution) {
        run.seconds.iter_mut().for_each(|seconds| *seconds *= 1.7);
    }
    // Submissions are graded relative to the scaling that the solution reaches.
    let (verdict, grade, words) = graded(&record, Kind::Scaling);
    assert!(verdict == Verdict::Graded && (97.0..99.5).contains(&grade.unwrap()), "{words}");
    for run in runs_of(&mut record, Whose::Solution) {
        run.seconds.iter_mut().for_each(|seconds| *seconds *= 1.3);
    }
    let (verdict, none, words) = graded(&record, Kind::Scaling);
    assert_eq!((verdict, none), (Verdict::TooNoisy, None), "{words}");
    assert!(words.contains("the solution itself"), "{words}");
    let rubric = Facts { scaling: timed(100_000), speed: timed(100_000), ..Facts::default() };
    let speed = judge(&record.found, &rubric).pop().unwrap();
    assert_eq!((speed.kind, speed.verdict), (Kind::Speed, Verdict::TooNoisy), "{}", speed.message);
}

#[test]
fn what_cannot_be_is_wrong() {
    for kind in [Kind::Scaling, Kind::Speed] {
        let record = record(kind, 2, |whose, n, _| {
            vec![if whose == Whose::Own { 0.0 } else { 1e-4 * n }; 5]
        });
        let (verdict, grade, words) = graded(&record, kind);
        assert_eq!((verdict, grade), (Verdict::Wrong, Some(0.0)), "{words}");
        assert!(words.contains("impossible"), "{words}");
    }
}

#[test]
fn speed_is_relative_to_the_solution() {
    for (times, expected) in [(1.1, 100.0), (2.0, 75.0), (4.0, 37.5)] {
        let record = record(Kind::Speed, 2, |whose, _, _| {
            vec![if whose == Whose::Own { 0.1 * times } else { 0.1 }; 5]
        });
        let grade = graded(&record, Kind::Speed).1.unwrap();
        assert!((grade - expected).abs() < 1e-9, "{times}: {grade}");
    }
}

#[test]
fn noise_of_the_machine_is_not_graded_and_wrong_is_worth_nothing() {
    let mut record = record(Kind::Speed, 2, |whose, _, _| match whose {
        Whose::Own => vec![0.1, 0.3, 0.3, 0.3, 0.4],
        _ => vec![0.1, 0.1, 0.12, 0.3, 0.3],
    });
    let (verdict, given, words) = graded(&record, Kind::Speed);
    assert_eq!((verdict, given), (Verdict::TooNoisy, None));
    assert!(words.contains("Grade again"), "{words}");
    let own = record.found.runs.iter_mut().find(|run| run.whose == Whose::Own).unwrap();
    (own.outcome, own.message) = (Outcome::Wrong, "particle 3 is lost".into());
    let (verdict, given, words) = graded(&record, Kind::Speed);
    assert_eq!((verdict, given), (Verdict::Wrong, Some(0.0)));
    assert!(words.contains("particle 3 is lost"), "{words}");
    record.found.runs.clear();
    assert_eq!(graded(&record, Kind::Speed).0, Verdict::NotTimed);
}

#[test]
fn noise_that_only_the_submission_has_is_its_own() {
    let record = record(Kind::Speed, 2, |whose, _, _| match whose {
        Whose::Own => vec![0.1, 0.4, 0.4, 0.4, 0.1],
        _ => vec![0.1, 0.101, 0.1, 0.102, 0.1],
    });
    assert!(is_noisy(&record.found, &rubric(Kind::Speed)), "further takes may tell more");
    let (verdict, given, words) = graded(&record, Kind::Speed);
    assert_eq!(verdict, Verdict::Graded);
    assert!(given.unwrap() < 40.0 && words.contains("the medians count"), "{words}");
}

#[test]
fn only_what_can_be_graded_is_timed_again() {
    let [quiet_on_one, quiet, noisy] = [(1, 1.0), (2, 1.0), (2, 4.0)].map(|(cores, later)| {
        record(Kind::Scaling, cores, |whose, _, p| {
            let later = if whose == Whose::Serial { 1.0 } else { later };
            [1.0, later, later, later, later].map(|seconds| seconds / p).into()
        })
    });
    let rubric = rubric(Kind::Scaling);
    let done = |cores, record: &Record| is_done_on(cores, &record.found, &rubric);
    assert!(done(2, &quiet) && !done(2, &noisy));
    // With one core, no run of scaling is needed. With two cores, runs are needed, and the record
    // of one core lacks them.
    assert!(done(1, &quiet_on_one) && !done(2, &quiet_on_one));
    let mut half = quiet;
    half.found.runs.retain(|run| run.whose != Whose::Own);
    assert!(!done(2, &half));
    let mut untimed = quiet_on_one;
    untimed.found.timed = false;
    assert!(!done(1, &untimed));
}
