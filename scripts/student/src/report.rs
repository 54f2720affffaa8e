//! Output of `cargo lab test` and `cargo lab watch`.

use anyhow::Result;

use crate::results::Run;
use crate::tasks::{self, Progress, State, What, print_tasks};
use lab_kit::harness::{Outcome, Verdict};
use lab_kit::terminal::folded;
use lab_kit::{Kit, Lab};

/// Maximal number of lines of a test's message that are shown.
const LINES: usize = 40;

/// Prints the state of a lab or a task, and the next step.
pub(crate) fn report(kit: &Kit, what: What, run: &Run, all: bool) -> Result<()> {
    match what.task {
        Some(_) => run.tasks.iter().try_for_each(|progress| report_task(kit, progress, all)),
        None => report_lab(kit, what.lab, run, all),
    }
}

/// Prints the state of a lab, the next task, and its location.
fn report_lab(kit: &Kit, lab: Lab, run: &Run, all: bool) -> Result<()> {
    let progress = &run.tasks;
    let others = run.other_failures();
    let title = kit.title(lab);
    let done = tasks::done(progress);
    let total = progress.len();
    let next = progress.iter().find(|p| matches!(p.state, State::Todo | State::Failing));
    let unrun = progress.iter().any(|p| p.state == State::Untested);
    let rest = match next {
        Some(next) if next.state == State::Todo => {
            let begin = if done == 0 { "start" } else { "go on" };
            format!(", {begin} with task {}: {}.", next.task, next.title)
        }
        Some(next) => format!(", task {} fails: {}.", next.task, next.title),
        None if others.is_empty() => ".".into(),
        None => ", but something else fails.".into(),
    };
    print!("{}", folded("", &format!("Lab {lab}, {title}: {done} of {total} tasks done{rest}")));
    if done > 0 || next.is_some_and(|next| next.state == State::Failing) {
        println!();
        print_tasks(progress);
    }
    if let Some(next) = next {
        println!();
        explain(next, all);
        print_help(kit, next)?;
    }
    if all {
        let later = progress
            .iter()
            .filter(|p| p.state == State::Failing)
            .filter(|p| Some(p.task) != next.map(|n| n.task));
        for failing in later {
            println!("\nTask {}: {}", failing.task, failing.title);
            explain(failing, true);
        }
    }
    if next.is_none() || all {
        others.iter().for_each(|outcome| print_failure(outcome));
    }
    if next.is_none() && others.is_empty() && !unrun {
        let next = format!("'cargo lab check {lab}', and the measurements of its chapter.");
        print!("{}", folded("Every test passes. What comes now: ", &next));
    }
    Ok(())
}

/// Prints whether a single task is done, and otherwise the reason.
fn report_task(kit: &Kit, progress: &Progress, all: bool) -> Result<()> {
    let Progress { task, title, state, .. } = progress;
    let state = state.word().unwrap_or("not tested");
    let open = tasks::line_of_todo(kit, *task)?.map(|(id, _)| id.to_string());
    let part = open.filter(|id| progress.state == State::Todo && *id != task.to_string());
    let which = part.map(|id| format!(" {id}")).unwrap_or_default();
    print!("{}", folded(&format!("Task {task}, "), &format!("{title}: {state}{which}.")));
    if matches!(progress.state, State::Failing | State::Todo) {
        println!();
        explain(progress, all);
        print_help(kit, progress)?;
    }
    if progress.state == State::Done {
        let open = tasks::open_todos(kit, task.lab)?;
        match open.first() {
            Some(next) => println!("The next gap is in task {next}: 'cargo lab test {next}'."),
            None => println!("What comes now: 'cargo lab test {}'.", task.lab),
        }
    }
    Ok(())
}

/// Prints the location of a task, and where to find help.
fn print_help(kit: &Kit, progress: &Progress) -> Result<()> {
    let task = progress.task;
    if let Some((_, line)) = tasks::line_of_todo(kit, task)? {
        print!("{}", folded("  where        ", &line));
    }
    if kit.chapter(task.lab).is_some() {
        let lab = task.lab;
        let facts = kit.facts(lab)?;
        let section = facts.tasks.get(&task.to_string()).map(|task| format!(", {}", task.section));
        let section = section.unwrap_or_default();
        let address = format!("localhost:3000/lab{lab}.html#{}", task.anchor());
        let place = format!("chapter {lab}{section}: 'cargo lab book --serve', then {address}");
        print!("{}", folded("  in the book  ", &place));
    }
    println!("  stuck?       cargo lab hint {task}");
    Ok(())
}

/// Prints why a task is not done: its first failure, or all of them. A `todo!` explains itself.
///
/// The clearest failures come first: a sentence about particles, then a panic in the lab's own
/// code, which may follow from the same mistake, then a crash or an endless run.
fn explain(progress: &Progress, all: bool) {
    let failures = progress.tests.iter().filter(|o| !o.passes() && !o.meets_todo_of(progress.task));
    let mut failures: Vec<_> = failures.collect();
    failures.sort_by_key(|outcome| vagueness(outcome));
    let shown = if all { failures.len() } else { 1 };
    for outcome in failures.iter().take(shown) {
        print_failure(outcome);
    }
    let others = &failures[shown.min(failures.len())..];
    let waiting = others.iter().filter(|outcome| outcome.todo().is_some()).count();
    print_more(
        others.len() - waiting,
        "test of this task fails: --all shows it",
        "tests of this task fail: --all shows them",
    );
    print_more(
        waiting,
        "test needs an earlier task first: --all names it",
        "tests need an earlier task first: --all names it",
    );
}

/// Prints how many tests are not shown, in words for one test or for several.
fn print_more(count: usize, one: &str, several: &str) {
    match count {
        0 => {}
        1 => println!("  One more {one}.\n"),
        _ => println!("  {count} more {several}.\n"),
    }
}

fn vagueness(outcome: &Outcome) -> u8 {
    match outcome.verdict {
        _ if outcome.todo().is_some() => 4,
        _ if outcome.hung() => 3,
        Verdict::Crashed(_) => 2,
        _ => u8::from(outcome.panicked()),
    }
}

fn print_failure(outcome: &Outcome) {
    let how = match &outcome.verdict {
        Verdict::Crashed(how) => format!("did not finish: {how}"),
        Verdict::TimedOut => {
            "did not end. The usual causes are a loop that does not end, two threads that wait for each other, far \
             more work than the task needs, or a busy machine."
                .into()
        }
        _ => match outcome.todo() {
            Some(id) => format!("needs task {id} first"),
            None => "fails:".into(),
        },
    };
    print!("{}", folded("  ", &format!("{} {how}", outcome.test)));
    let lines: Vec<&str> = outcome.message.lines().collect();
    if outcome.todo().is_none() {
        lines.iter().take(LINES).for_each(|line| print!("{}", folded("    ", line)));
        if lines.len() > LINES {
            println!("    … {} more lines", lines.len() - LINES);
        }
    }
    println!();
}

#[cfg(test)]
mod tests {
    use super::vagueness;
    use lab_kit::harness::{Outcome, Verdict};

    #[test]
    fn a_sentence_of_the_problem_comes_first() {
        let panic = "a panic in labs/lab3/src/parts.rs, line 7:\nrange end index 17 out of range";
        let mut failures = [
            Outcome::new("a", Verdict::Failed, "not yet implemented: task 3.9: mail"),
            Outcome::new("b", Verdict::TimedOut, ""),
            Outcome::new("c", Verdict::Crashed("it aborted".into()), ""),
            Outcome::new("d", Verdict::Failed, panic),
            Outcome::new("e", Verdict::Failed, "nobody begins a part too early"),
            Outcome::new("f", Verdict::Failed, "particle 3 is lost"),
        ];
        failures.sort_by_key(vagueness);
        assert_eq!(failures.map(|outcome| outcome.test).concat(), "efdcba");
    }
}
