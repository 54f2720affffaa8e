//! Tasks of a lab, and the state of each.

use std::collections::{BTreeMap, BTreeSet};
use std::str::FromStr;

use anyhow::{Result, ensure};
use serde::Serialize;

use lab_kit::answers::{RegionId, Task};
use lab_kit::facts::TaskFacts;
use lab_kit::files::read_bytes;
use lab_kit::harness::{Outcome, Verdict};
use lab_kit::starter::todo;
use lab_kit::terminal::folded;
use lab_kit::{Kit, Lab, sources_below, task_list};

/// A whole lab, or one task of it.
#[derive(Clone, Copy)]
pub(crate) struct What {
    pub(crate) lab: Lab,
    pub(crate) task: Option<Task>,
}

impl FromStr for What {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.contains('.') {
            return text.parse().map(|task: Task| Self { lab: task.lab, task: Some(task) });
        }
        text.parse().map(|lab| Self { lab, task: None })
    }
}

/// State of a task.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum State {
    /// All tests of the task pass.
    Done,
    /// The task was answered, and a test fails.
    #[serde(rename = "fails")]
    Failing,
    /// The task's `todo!`, or the `todo!` of a task that it builds on, is still there.
    Todo,
    /// Some tests of the task have not run, or lack a device; the others pass.
    Untested,
}

impl State {
    /// Returns the state in a word; `None` if there is nothing to print.
    pub(crate) fn word(self) -> Option<&'static str> {
        match self {
            Self::Done => Some("done"),
            Self::Failing => Some("fails"),
            Self::Todo => Some("todo"),
            Self::Untested => None,
        }
    }
}

/// A task with the outcomes of its tests.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Progress {
    pub(crate) task: Task,
    pub(crate) title: String,
    /// Whether the task is not one of the core tasks.
    pub(crate) optional: bool,
    pub(crate) state: State,
    /// Outcomes of the task's tests, as far as they have run.
    pub(crate) tests: Vec<Outcome>,
}

/// Returns the tasks of a lab in order, with the outcomes that belong to each.
pub(crate) fn progress(kit: &Kit, lab: Lab, outcomes: &[Outcome]) -> Result<Vec<Progress>> {
    let mut tasks = BTreeMap::new();
    for (task, TaskFacts { title, optional, .. }) in task_list::read(kit, lab)? {
        tasks.insert(task, (title, optional));
    }
    // A lab may have no facts.
    for Todo { id, title, .. } in todos(kit, lab)? {
        tasks.entry(id.task).or_insert((title, false));
    }
    for task in outcomes.iter().filter_map(|outcome| Task::of_test(&outcome.test)) {
        tasks.entry(task).or_insert(("(no title)".into(), false));
    }
    let mut all = Vec::new();
    for (task, (title, optional)) in tasks {
        let own = outcomes.iter().filter(|outcome| Task::of_test(&outcome.test) == Some(task));
        let tests: Vec<Outcome> = own.cloned().collect();
        all.push(Progress { task, title, optional, state: state(&tests), tests });
    }
    Ok(all)
}

/// Returns an error if a lab does not have this task.
pub(crate) fn expect_task(kit: &Kit, task: Task) -> Result<()> {
    let all = progress(kit, task.lab, &[])?;
    let known = all.iter().any(|progress| progress.task == task);
    let names: Vec<String> = all.iter().map(|progress| progress.task.to_string()).collect();
    ensure!(known, "lab {} has no task {task}; it has {}", task.lab, names.join(", "));
    Ok(())
}

/// Returns the number of tasks that are done.
pub(crate) fn done(tasks: &[Progress]) -> usize {
    tasks.iter().filter(|progress| progress.state == State::Done).count()
}

fn state(tests: &[Outcome]) -> State {
    match tests.iter().find(|outcome| !outcome.passes()) {
        _ if tests.is_empty() => State::Untested,
        None if tests.iter().any(|outcome| outcome.verdict == Verdict::Skipped) => State::Untested,
        None => State::Done,
        Some(_) if tests.iter().any(|outcome| outcome.todo().is_some()) => State::Todo,
        Some(_) => State::Failing,
    }
}

/// Returns a task's first remaining `todo!`, with its location and title; 2.1 precedes 2.1b.
///
/// The location is a path below the top folder, and a line.
pub(crate) fn line_of_todo(kit: &Kit, task: Task) -> Result<Option<(RegionId, String)>> {
    let own = todos(kit, task.lab)?.into_iter().filter(|todo| todo.id.task == task);
    let first = own.min_by_key(|todo| todo.id);
    Ok(first.map(|Todo { id, title, location }| (id, format!("{location}: {id}, {title}"))))
}

/// Returns the tasks that still have a `todo!`, in order.
pub(crate) fn open_todos(kit: &Kit, lab: Lab) -> Result<Vec<Task>> {
    let open: BTreeSet<Task> = todos(kit, lab)?.into_iter().map(|todo| todo.id.task).collect();
    Ok(open.into_iter().collect())
}

/// A remaining `todo!`.
struct Todo {
    id: RegionId,
    title: String,
    /// File below the top folder, and line.
    location: String,
}

/// Returns all remaining `todo!`s of a lab.
fn todos(kit: &Kit, lab: Lab) -> Result<Vec<Todo>> {
    let mut todos = Vec::new();
    for path in sources_below(&kit.starter(lab).join("src"))? {
        let shown = path.strip_prefix(kit.root()).unwrap_or(&path).display();
        for (line, number) in String::from_utf8_lossy(&read_bytes(&path)?).lines().zip(1..) {
            let Some((id, title)) = todo(line) else { continue };
            let location = format!("{shown}, line {number}");
            todos.push(Todo { id, title: title.into(), location });
        }
    }
    Ok(todos)
}

/// Prints a line for each task: its state, its number, its title.
pub(crate) fn print_tasks(tasks: &[Progress]) {
    for Progress { task, title, optional, state, .. } in tasks {
        let state = state.word().unwrap_or_default();
        let optional = if *optional { " (optional)" } else { "" };
        print!("{}", folded(&format!("  {state:5}  {task}  "), &format!("{title}{optional}")));
    }
}

#[cfg(test)]
impl Progress {
    /// Makes the tasks of a lab, without tests, in these states.
    pub(crate) fn samples(lab: u8, states: &[State]) -> Vec<Self> {
        let mut tasks = Vec::new();
        for (state, number) in states.iter().zip(1..) {
            tasks.push(Self {
                task: format!("{lab}.{number}").parse().unwrap(),
                title: "a task".into(),
                optional: false,
                state: *state,
                tests: Vec::new(),
            });
        }
        tasks
    }
}

#[cfg(test)]
mod tests {
    use super::{State, What, expect_task, line_of_todo, state};
    use lab_kit::Kit;
    use lab_kit::harness::{Outcome, Verdict};

    fn outcome(verdict: Verdict, message: &str) -> Outcome {
        Outcome::new("task_1_1_x", verdict, message)
    }

    #[test]
    fn states_follow_from_outcomes() {
        let passed = outcome(Verdict::Passed, "");
        let failed = outcome(Verdict::Failed, "particle 3 is lost");
        let todo = outcome(Verdict::Failed, "not yet implemented: task 1.1b: x");
        assert_eq!(state(&[]), State::Untested);
        let skipped = outcome(Verdict::Skipped, "skipped: no adapter");
        assert_eq!(state(&[passed.clone(), skipped]), State::Untested);
        assert_eq!(state(std::slice::from_ref(&passed)), State::Done);
        assert_eq!(state(&[passed.clone(), failed.clone()]), State::Failing);
        assert_eq!(state(&[passed, failed, todo]), State::Todo);
    }

    #[test]
    fn the_first_todo_that_is_left_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let a = ("labs/lab1/src/a.rs", "\ntodo!(\"task 1.1b: b\")");
        for (b, line) in [
            ("todo!(\"task 1.1: a\")", "labs/lab1/src/b.rs, line 1: 1.1, a"),
            ("panic!(\"task 1.1: given\")", "labs/lab1/src/a.rs, line 2: 1.1b, b"),
        ] {
            let kit = Kit::of_files(folder.path(), &[a, ("labs/lab1/src/b.rs", b)]);
            let found = line_of_todo(&kit, "1.1".parse().unwrap()).unwrap();
            assert_eq!(found.unwrap().1, line);
        }
    }

    #[test]
    fn a_lab_or_a_task_is_meant() {
        for (text, lab, task) in
            [("10", "10", None), ("lab3", "3", None), ("10.6", "10", Some("10.6"))]
        {
            let what: What = text.parse().unwrap();
            assert_eq!(what.lab, lab.parse().unwrap());
            assert_eq!(what.task, task.map(|task| task.parse().unwrap()));
        }
        for text in ["", "x", "10.", ".6", "10.6b", "0.1"] {
            assert!(text.parse::<What>().is_err(), "{text}");
        }
    }

    #[test]
    fn a_task_that_is_not_there_is_named_beside_those_that_are() {
        let kit = Kit::find().unwrap();
        assert!(expect_task(&kit, "1.5".parse().unwrap()).is_ok());
        let error = expect_task(&kit, "1.6".parse().unwrap()).unwrap_err().to_string();
        assert_eq!(error, "lab 1 has no task 1.6; it has 1.1, 1.2, 1.3, 1.4, 1.5");
    }
}
