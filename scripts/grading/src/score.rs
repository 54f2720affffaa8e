//! Computes points from results. No other module writes points into a record.

use anyhow::{Result, ensure};

use crate::record::{Decision, Findings, Marked, Record, Status, Task, Verdict, number};
use crate::timing;
use lab_kit::Facts;
use lab_kit::facts::TaskFacts;

/// Computes the record's points from `rubric`, and replaces any earlier points.
///
/// # Errors
/// If the rubric has a task that the record does not have.
pub(crate) fn score(record: &mut Record, rubric: &Facts) -> Result<()> {
    let Record { found, tasks, marked } = record;
    add_unasked(found, tasks, rubric)?;
    // Tasks are sorted by number: 7.2 before 7.10.
    tasks.sort_by_key(|task| number(&task.id));
    for task in &mut *tasks {
        score_task(task, rubric);
    }
    marked.measures = timing::judge(found, rubric);
    decide_parts(tasks, marked);
    // A measure without a grade gives no points yet, so no student gains from a missing grade.
    let measures = &marked.measures;
    marked.points = tasks.iter().map(|task| task.points).sum::<f64>()
        + measures.iter().map(|measure| measure.points).sum::<f64>();
    marked.out_of = tasks.iter().map(|task| task.out_of).sum::<f64>()
        + measures.iter().map(|measure| measure.out_of).sum::<f64>();
    decide_whole(marked);
    Ok(())
}

/// Adds the tasks of the rubric that were not judged because the submission has no program.
fn add_unasked(found: &Findings, tasks: &mut Vec<Task>, rubric: &Facts) -> Result<()> {
    for id in rubric.tasks.keys() {
        if tasks.iter().any(|task| task.id == *id) {
            continue;
        }
        ensure!(
            found.status != Status::Graded,
            "the record of {} knows nothing about task {id}: grade it again",
            found.name
        );
        tasks.push(Task { id: id.clone(), ..Task::default() });
    }
    Ok(())
}

/// Sets a task's points. A task that is not in the rubric is worth nothing.
fn score_task(task: &mut Task, rubric: &Facts) {
    let TaskFacts { points, partial, .. } = rubric.tasks.get(&task.id).cloned().unwrap_or_default();
    task.out_of = points;
    let share = if task.passed { 1.0 } else { partial * task.share };
    // Points have two decimals, because more decimals would only confuse.
    task.points = (100.0 * share * task.out_of).round() / 100.0;
}

/// Sets the points that a person decided for tasks and measures. The last decision counts.
fn decide_parts(tasks: &mut [Task], marked: &mut Marked) {
    for Decision { task, points, .. } in &marked.by_hand {
        let (Some(id), Some(points)) = (task, *points) else { continue };
        for task in tasks.iter_mut().filter(|task| task.id == *id) {
            task.points = points;
        }
        for measure in marked.measures.iter_mut().filter(|m| m.kind.name() == id) {
            measure.points = points;
            measure.verdict = Verdict::Graded;
        }
    }
}

/// Sets the total. It consists of the points that a person decided, or else of the sum of the
/// points minus the penalty for lateness.
fn decide_whole(marked: &mut Marked) {
    let decided = marked.by_hand.iter().rev().filter(|decision| decision.task.is_none());
    match (decided.into_iter().find_map(|decision| decision.points), &marked.late) {
        (Some(points), _) => marked.points = points,
        (None, Some(late)) => marked.points *= 1.0 - late.lost,
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
        let tasks = tasks.iter().map(|(id, points)| {
            ((*id).to_owned(), TaskFacts { points: *points, ..TaskFacts::default() })
        });
        Facts { tasks: tasks.collect(), ..Facts::default() }
    }

    #[test]
    fn points_follow_the_rubric_and_what_passed() {
        let mut record = Record::sample();
        score(&mut record, &rubric(&[("1.1", 30.0), ("1.2", 70.0)])).unwrap();
        assert_eq!((record.marked.points, record.marked.out_of), (30.0, 100.0));
        score(&mut record, &rubric(&[("1.2", 100.0)])).unwrap();
        assert_eq!((record.marked.points, record.marked.out_of), (0.0, 100.0));
    }

    #[test]
    fn a_part_of_a_task_is_worth_what_the_rubric_says() {
        let mut record = Record::sample();
        record.tasks[1].share = 0.75;
        let mut rubric = rubric(&[("1.1", 60.0), ("1.2", 40.0)]);
        score(&mut record, &rubric).unwrap();
        assert_eq!(record.marked.points, 60.0, "nothing if it says nothing");
        rubric.tasks.get_mut("1.2").unwrap().partial = 0.5;
        score(&mut record, &rubric).unwrap();
        assert_eq!(record.marked.points, 75.0);
    }

    #[test]
    fn a_task_that_was_never_asked_cannot_be_marked() {
        let mut record = Record::sample();
        let error = score(&mut record, &rubric(&[("1.9", 1.0)])).unwrap_err().to_string();
        assert!(error.contains("task 1.9: grade it again"), "{error}");
        record.found.status = Status::NotBuilt;
        score(&mut record, &rubric(&[("1.9", 1.0)])).unwrap();
        assert_eq!(record.marked.out_of, 1.0);
    }

    #[test]
    fn what_was_not_timed_is_open() {
        let mut record = Record::sample();
        let mut rubric = rubric(&[("1.1", 100.0)]);
        rubric.speed = Some(Timed { points: 20.0, variant: "all-pairs".into(), n: 1000 });
        score(&mut record, &rubric).unwrap();
        assert_eq!(record.marked.measures[0].verdict, Verdict::NotTimed);
        assert_eq!(
            (record.marked.points, record.marked.out_of, record.open_points()),
            (100.0, 120.0, 20.0)
        );
    }
}
