//! Checks that a starter fails as it should.

use std::collections::BTreeSet;

use super::first_lines;
use lab_kit::answers::Task;
use lab_kit::harness::{Outcome, Verdict};

/// Lists the faults of a starter's outcomes.
///
/// Every test of a task must first meet the `todo!` of that task, every other test must pass, and
/// every task must have a test. A solution without regions is its own starter, so all tests must
/// pass.
pub(crate) fn faults(outcomes: &[Outcome], tasks: &BTreeSet<Task>) -> Vec<String> {
    let mut faults = Vec::new();
    for outcome in outcomes {
        let Outcome { test, verdict, .. } = outcome;
        let Some(task) = Task::of_test(test).filter(|_| !tasks.is_empty()) else {
            if !matches!(verdict, Verdict::Passed | Verdict::Ignored) {
                faults.push(format!("{test} meets no todo, and fails: {}", first_lines(outcome)));
            }
            continue;
        };
        match (verdict, outcome.todo()) {
            (Verdict::Passed | Verdict::Ignored | Verdict::Skipped, _) => {
                faults.push(format!("{test} does not fail"))
            }
            (Verdict::Failed, Some(_)) if outcome.meets_todo_of(task) => {}
            (Verdict::Failed, Some(todo)) => {
                faults.push(format!("{test} meets the todo of task {todo} first"))
            }
            _ => {
                faults.push(format!("{test} fails, but not at its todo: {}", first_lines(outcome)))
            }
        }
    }
    if tasks.is_empty() {
        return faults;
    }
    let tested: BTreeSet<_> =
        outcomes.iter().filter_map(|outcome| Task::of_test(&outcome.test)).collect();
    for task in tasks.difference(&tested) {
        faults.push(format!("the starter has no test of task {task} (is it up to date?)"));
    }
    for task in tested.difference(tasks) {
        faults.push(format!("there are tests of task {task}, which has no region"));
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::faults;
    use lab_kit::harness::{Outcome, Verdict};

    fn todo(id: &str) -> String {
        format!("thread said\nnot yet implemented: task {id}: x")
    }

    #[test]
    fn a_starter_fails_at_its_own_todos_only() {
        let outcomes = [
            Outcome::new("task_1_1::a", Verdict::Failed, todo("1.1")),
            Outcome::new("task_1_1::b", Verdict::Failed, todo("1.1b")),
            Outcome::new("names", Verdict::Passed, ""),
        ];
        let tasks = ["1.1".parse().unwrap()].into();
        assert_eq!(faults(&outcomes, &tasks), [""; 0]);

        let outcomes = [
            Outcome::new("task_1_1::a", Verdict::Passed, ""),
            Outcome::new("task_1_1::b", Verdict::Failed, todo("1.2")),
            Outcome::new("task_1_1::c", Verdict::Failed, "other"),
            Outcome::new("task_1_1::d", Verdict::Crashed("it aborted".into()), todo("1.1")),
            Outcome::new("names", Verdict::Failed, "why"),
        ];
        let tasks = ["1.1".parse().unwrap(), "1.2".parse().unwrap()].into();
        let expected = [
            "task_1_1::a does not fail",
            "task_1_1::b meets the todo of task 1.2 first",
            "task_1_1::c fails, but not at its todo: other",
            "task_1_1::d fails, but not at its todo: it aborted",
            "names meets no todo, and fails: why",
            "the starter has no test of task 1.2 (is it up to date?)",
        ];
        assert_eq!(faults(&outcomes, &tasks), expected);
    }

    #[test]
    fn a_starter_without_todos_passes() {
        let passed = Outcome::new("task_14_1::a", Verdict::Passed, "");
        let failed = Outcome::new("task_14_1::b", Verdict::Failed, "why");
        let expected = ["task_14_1::b meets no todo, and fails: why"];
        assert_eq!(faults(&[passed, failed], &[].into()), expected);
    }
}
