//! Checks of the exam. The exam questions are complete and their numbers computed. Each learning
//! outcome has a task, a question of a chapter and an exam question. The weekly plans list the
//! hours of the chapters.

mod bank;
mod numbers;

use std::collections::{BTreeMap, BTreeSet};

use bank::{Question, rows};
use lab_kit::files::read_text;
use lab_kit::{Kit, Lab, answers};

/// Returns the labs that the exam asks about: those with prescribed answers.
fn labs() -> (Kit, Vec<Lab>) {
    let kit = Kit::find().unwrap();
    let mut labs = kit.solutions();
    labs.retain(|lab| !answers::tasks(&kit, *lab).unwrap().is_empty());
    (kit, labs)
}

fn questions(kit: &Kit, labs: &[Lab]) -> Vec<Question> {
    labs.iter().flat_map(|lab| bank::read(kit, *lab).unwrap()).collect()
}

/// Returns mdBook's anchor of a heading.
fn anchor(heading: &str) -> String {
    let text = heading.trim_start_matches('#').trim().to_lowercase();
    let kept = text.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[test]
fn questions_are_whole_and_the_book_teaches_what_they_ask() {
    let (kit, labs) = labs();
    for lab in labs {
        let questions = bank::read(&kit, lab).unwrap();
        assert!(questions.len() >= 8, "lab {lab} has {} questions", questions.len());
        for (at, Question { id, points, page, anchor: section, .. }) in (1..).zip(&questions) {
            assert_eq!(*id, format!("{lab}.{at}"));
            assert!((2..=8).contains(points), "question {id} is worth {points} points");
            let chapter = read_text(&kit.path("book/src").join(page)).unwrap();
            let mut headings = chapter.lines().filter(|line| line.starts_with("##"));
            let there = headings.any(|heading| anchor(heading) == *section);
            assert!(there, "question {id}: {page} has no section #{section}");
        }
    }
}

#[test]
fn numbers_in_answers_are_computed() {
    let (kit, labs) = labs();
    let mut computed = numbers::all();
    for Question { id, numbers, .. } in questions(&kit, &labs) {
        let values = computed.remove(&*id).unwrap_or_default();
        // The computed number is rounded to the digits of the answer.
        let digits = |text: &str| text.split_once('.').map_or(0, |(_, digits)| digits.len());
        let shown: Vec<String> = (numbers.iter().zip(&values))
            .map(|(text, value)| format!("{value:.*}", digits(text)))
            .collect();
        assert_eq!(numbers, shown, "question {id}: the answer, and what is computed");
        assert_eq!(numbers.len(), values.len(), "question {id}: {values:?}");
    }
    assert!(computed.is_empty(), "no question has these: {computed:?}");
}

/// Expands a list of tasks: `1.2–1.4, 2.1` is tasks 1.2, 1.3, 1.4 and 2.1.
fn each(list: &str) -> Vec<String> {
    let words = list.split(", ").filter(|word| word.contains('.'));
    let run = |word: &str| {
        let (first, last) = word.split_once('–').unwrap_or((word, word));
        let ((lab, first), (_, last)) = (first.split_once('.')?, last.split_once('.')?);
        let (first, last): (u32, u32) = (first.parse().ok()?, last.parse().ok()?);
        Some((first..=last).map(|task| format!("{lab}.{task}")).collect::<Vec<_>>())
    };
    words
        .flat_map(|word| run(word).unwrap_or_else(|| panic!("{word} is no run of tasks")))
        .collect()
}

#[test]
fn each_outcome_has_a_task_a_question_and_an_exam_question() {
    let (kit, labs) = labs();
    let mut asked: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for question in questions(&kit, &labs) {
        asked.entry(question.outcome).or_default().push(question.id);
    }
    let facts = kit.solutions().into_iter().map(|lab| kit.facts(lab).unwrap());
    let mut tasks: BTreeSet<String> = facts.flat_map(|facts| facts.tasks.into_keys()).collect();
    let all_tasks = tasks.clone();
    let page = read_text(&kit.path("book/src/instructor/outcomes.md")).unwrap();
    for row in rows(&page).filter(|row| row[0].parse::<u32>().is_ok()) {
        let [outcome, _, of_tasks, of_chapter, of_exam] = row[..] else { panic!("{row:?}") };
        for task in each(of_tasks) {
            assert!(all_tasks.contains(&task), "outcome {outcome}: there is no task {task}");
            tasks.remove(&task);
        }
        assert!(!each(of_tasks).is_empty(), "outcome {outcome} has no task");
        assert!(!each(of_chapter).is_empty(), "outcome {outcome} has no question of a chapter");
        assert_eq!(each(of_exam), asked.remove(outcome).unwrap_or_default(), "outcome {outcome}");
        assert!(!each(of_exam).is_empty(), "outcome {outcome} has no exam question");
    }
    assert!(asked.is_empty(), "outcomes that the table lacks: {asked:?}");
    assert!(tasks.is_empty(), "tasks for no outcome: {tasks:?}");
}

/// Checks that a week's hours are the hours of the chapters that begin in it and of its tasks.
#[test]
fn weeks_have_the_hours_of_their_chapters() {
    let (kit, _) = labs();
    let facts = |lab: &str| kit.facts(lab.parse().unwrap()).unwrap();
    let page = read_text(&kit.path("book/src/instructor/weeks.md")).unwrap();
    let mut weeks = 0;
    for row in rows(&page) {
        let [week, _, read, tasks, hours, ..] = row[..] else { continue };
        let Ok(hours) = hours.parse::<f64>() else { continue };
        let begun = read.split("](../lab").skip(1).filter_map(|rest| rest.split_once(".md"));
        let reading: f64 = begun.map(|(lab, _)| facts(lab).reading).sum();
        let task = |task: String| {
            let (lab, _) = task.split_once('.').unwrap();
            facts(lab).tasks.get(&task).unwrap_or_else(|| panic!("no task {task}")).hours
        };
        let work: f64 = each(tasks).into_iter().map(task).sum();
        assert_eq!(hours, reading + work, "week {week}: {read} {tasks}");
        weeks += 1;
    }
    assert!(weeks > 0);
}
