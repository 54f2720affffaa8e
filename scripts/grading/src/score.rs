//! Computes points from results. A record gets its points here only.

use anyhow::{Result, ensure};

use crate::record::{Decision, Measure, Record, Status, Task, Verdict, number};
use crate::timing;
use lab_kit::Facts;
use lab_kit::facts::TaskFacts;

/// Sets the record's points by `rubric`, replacing any earlier points.
///
/// # Errors
/// If the rubric has a task that the record does not have.
pub(crate) fn score(record: &mut Record, rubric: &Facts) -> Result<()> {
    for id in rubric.tasks.keys() {
        if record.tasks.iter().any(|task| task.id == *id) {
            continue;
        }
        ensure!(
            record.status != Status::Graded,
            "the record of {} knows nothing about task {id}: grade it again",
            record.name
        );
        record.tasks.push(Task::unasked(id));
    }
    // Tasks are sorted by number: 7.2 before 7.10.
    record.tasks.sort_by_key(|task| number(&task.id));
    for task in &mut record.tasks {
        let TaskFacts { points, partial, .. } =
            rubric.tasks.get(&task.id).cloned().unwrap_or_default();
        task.out_of = points;
        let share = if task.passed { 1.0 } else { partial * task.share };
        // Two decimals are enough; more would only confuse.
        task.points = (100.0 * share * task.out_of).round() / 100.0;
    }
    record.measures = timing::judge(record, rubric);
    decide_parts(record);
    // An open measure has no points yet, so no student gains by it.
    let tasks = |of: fn(&Task) -> f64| record.tasks.iter().map(of).sum::<f64>();
    let measures = |of: fn(&Measure) -> f64| record.measures.iter().map(of).sum::<f64>();
    record.points = tasks(|task| task.points) + measures(|measure| measure.points);
    record.out_of = tasks(|task| task.out_of) + measures(|measure| measure.out_of);
    decide_whole(record);
    Ok(())
}

/// Sets the points of tasks and measures that a person decided. The last decision counts.
fn decide_parts(record: &mut Record) {
    for Decision { task, points, .. } in &record.by_hand {
        let (Some(id), Some(points)) = (task, *points) else { continue };
        for task in record.tasks.iter_mut().filter(|task| task.id == *id) {
            task.points = points;
        }
        for measure in record.measures.iter_mut().filter(|m| m.kind.name() == id) {
            (measure.points, measure.verdict) = (points, Verdict::Graded);
        }
    }
}

/// Sets the total: the points that a person decided, or else the points reduced by lateness.
fn decide_whole(record: &mut Record) {
    let decided = record.by_hand.iter().rev().filter(|decision| decision.task.is_none());
    match (decided.into_iter().find_map(|decision| decision.points), &record.late) {
        (Some(points), _) => record.points = points,
        (None, Some(late)) => record.points *= 1.0 - late.lost,
        (None, None) => {}
    }
}

#[cfg(test)]
mod tests {
    use super::score;
    use crate::record::{Record, Status, Verdict};
    use lab_kit::Facts;
    use lab_kit::facts::{TaskFacts, Timed};

    fn rubric(tasks: &[(&str, f64)]) -> Facts {
        let task = |points| TaskFacts { points, ..TaskFacts::default() };
        let tasks = tasks.iter().map(|(id, points)| ((*id).to_owned(), task(*points))).collect();
        Facts { tasks, ..Facts::default() }
    }

    #[test]
    fn points_follow_the_rubric_and_what_passed() {
        let mut record = Record::sample();
        score(&mut record, &rubric(&[("1.1", 30.0), ("1.2", 70.0)])).unwrap();
        assert_eq!((record.points, record.out_of), (30.0, 100.0));
        score(&mut record, &rubric(&[("1.2", 100.0)])).unwrap();
        assert_eq!((record.points, record.out_of), (0.0, 100.0));
    }

    #[test]
    fn a_part_of_a_task_is_worth_what_the_rubric_says() {
        let mut record = Record::sample();
        record.tasks[1].share = 0.75;
        let mut rubric = rubric(&[("1.1", 60.0), ("1.2", 40.0)]);
        score(&mut record, &rubric).unwrap();
        assert_eq!(record.points, 60.0, "nothing if it says nothing");
        rubric.tasks.get_mut("1.2").unwrap().partial = 0.5;
        score(&mut record, &rubric).unwrap();
        assert_eq!(record.points, 75.0);
    }

    #[test]
    fn a_task_that_was_never_asked_cannot_be_marked() {
        let mut record = Record::sample();
        let error = score(&mut record, &rubric(&[("1.9", 1.0)])).unwrap_err().to_string();
        assert!(error.contains("task 1.9: grade it again"), "{error}");
        record.status = Status::NotBuilt;
        score(&mut record, &rubric(&[("1.9", 1.0)])).unwrap();
        assert_eq!(record.out_of, 1.0);
    }

    #[test]
    fn what_was_not_timed_is_open() {
        let mut record = Record::sample();
        let mut rubric = rubric(&[("1.1", 100.0)]);
        rubric.speed = Some(Timed { points: 20.0, variant: "all-pairs".into(), n: 1000 });
        score(&mut record, &rubric).unwrap();
        assert_eq!(record.measures[0].verdict, Verdict::NotTimed);
        assert_eq!((record.points, record.out_of, record.open_points()), (100.0, 120.0, 20.0));
    }
}
