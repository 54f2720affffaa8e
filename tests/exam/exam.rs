//! Checks the exam. The exam questions are complete, and their numbers are computed. Each learning
//! outcome has a core task, a question in a chapter, and an exam question. The weekly plans list
//! the hours of the chapters.

use std::collections::{BTreeMap, BTreeSet};

use exam::bank::{self, Question, each, named, rows};
use exam::numbers;
use exam::numbers::draw::{Draw, Inputs};
use exam::paper::{self, KINDS, POINTS};
use lab_kit::files::read_text;
use lab_kit::{Kit, Lab, answers};

/// Returns the labs that the exam asks about: the labs with prescribed answers.
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

/// Rounds numbers to the digits that an answer shows.
fn as_shown(texts: &[String], values: &[f64]) -> Vec<String> {
    let digits = |text: &String| text.split_once('.').map_or(0, |(_, digits)| digits.len());
    let mut shown: Vec<String> = Vec::new();
    for (at, value) in values.iter().enumerate() {
        shown.push(format!("{value:.*}", texts.get(at).map_or(0, digits)));
    }
    shown
}

#[test]
fn numbers_in_answers_are_computed() {
    let (kit, labs) = labs();
    let mut inputs = Inputs::of(Draw::Book);
    let mut computed = numbers::all(&mut inputs);
    for Question { id, numbers, text, answer, .. } in questions(&kit, &labs) {
        // A number that a paper may change is the same in the text and in the program.
        for (name, value) in named(&id, &(text + &answer)) {
            let own = inputs.shown.remove(&name);
            assert!(own.is_some_and(|own| (own - value).abs() < 1e-9), "{name}: {value}, {own:?}");
        }
        let values = computed.remove(&*id).unwrap_or_default();
        let shown = as_shown(&numbers, &values);
        assert_eq!(numbers, shown, "question {id}: the answer, and what is computed");
        assert_eq!(numbers.len(), values.len(), "question {id}: {values:?}");
    }
    assert!(computed.is_empty(), "no question has these: {computed:?}");
    assert!(inputs.shown.is_empty(), "no question prints these: {:?}", inputs.shown);
}

#[test]
fn papers_are_equally_hard_and_their_keys_are_computed() {
    let (kit, labs) = labs();
    let mut papers = BTreeSet::new();
    for seed in 0..40 {
        let paper = paper::draw(&kit, &labs, seed).unwrap();
        let headings: Vec<&str> = paper.questions.split("\n## ").skip(1).collect();
        let kinds = headings.iter().zip(KINDS).filter(|(text, kind)| text.contains(kind)).count();
        assert_eq!((headings.len(), kinds), (KINDS.len(), KINDS.len()), "paper {seed}");
        let points = headings.iter().filter_map(|text| {
            text.split_once(" points)")?.0.rsplit_once('(')?.1.parse::<u32>().ok()
        });
        assert_eq!(points.sum::<u32>(), POINTS, "paper {seed}");
        // The key follows from the numbers that the paper prints.
        let texts = paper.ids.iter().zip(&headings);
        let printed = texts.flat_map(|(id, text)| named(id, text)).collect();
        let computed = numbers::all(&mut Inputs::of(Draw::Printed(printed)));
        let answers = paper.key.split("\n## ").skip(1);
        for (id, answer) in paper.ids.iter().zip(answers) {
            let shown = answer.split("**").skip(1).step_by(2).flat_map(bank::numbers);
            let shown: Vec<String> = shown.collect();
            let values = computed.get(&**id).cloned().unwrap_or_default();
            assert_eq!(shown, as_shown(&shown, &values), "paper {seed}, question {id}: {values:?}");
        }
        papers.insert(paper.questions);
    }
    assert_eq!(papers.len(), 40);
    let spine = ["1", "2", "3", "5", "6"].map(|lab| lab.parse().unwrap());
    assert!((0..5).all(|seed| paper::draw(&kit, &spine, seed).is_ok()));
}

#[test]
fn each_outcome_has_a_core_task_a_question_and_an_exam_question() {
    let (kit, labs) = labs();
    let mut asked: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for question in questions(&kit, &labs) {
        asked.entry(question.outcome).or_default().push(question.id);
    }
    let (mut tasks, mut core) = (BTreeSet::new(), BTreeSet::new());
    for (id, facts) in kit.solutions().iter().flat_map(|lab| kit.facts(*lab).unwrap().tasks) {
        core.extend((!facts.optional).then(|| id.clone()));
        tasks.insert(id);
    }
    let all_tasks = tasks.clone();
    let page = read_text(&kit.path("book/src/instructor/outcomes.md")).unwrap();
    for row in rows(&page).filter(|row| row[0].parse::<u32>().is_ok()) {
        let [outcome, _, of_tasks, of_chapter, of_exam] = row[..] else { panic!("{row:?}") };
        for task in each(of_tasks) {
            assert!(all_tasks.contains(&task), "outcome {outcome}: there is no task {task}");
            tasks.remove(&task);
        }
        let is_core = each(of_tasks).iter().any(|task| core.contains(task));
        assert!(is_core, "outcome {outcome} has no core task");
        assert!(!each(of_chapter).is_empty(), "outcome {outcome} has no question of a chapter");
        assert_eq!(each(of_exam), asked.remove(outcome).unwrap_or_default(), "outcome {outcome}");
        assert!(!each(of_exam).is_empty(), "outcome {outcome} has no exam question");
    }
    assert!(asked.is_empty(), "outcomes that the table lacks: {asked:?}");
    assert!(tasks.is_empty(), "tasks for no outcome: {tasks:?}");
}

/// Checks that each week has the hours of its tasks and of the chapters that begin in it.
#[test]
fn weeks_have_the_hours_of_their_chapters() {
    let (kit, _) = labs();
    let facts = |lab: &str| kit.facts(lab.parse().unwrap()).unwrap();
    let page = read_text(&kit.path("book/src/instructor/weeks.md")).unwrap();
    let (mut weeks, mut sum) = (0, 0.0);
    for row in rows(&page) {
        let [week, _, read, tasks, hours, ..] = row[..] else { continue };
        if hours == "hours" {
            sum = 0.0;
        }
        let Ok(hours) = hours.parse::<f64>() else { continue };
        if week == "all" {
            assert_eq!(hours, sum, "the plan with {weeks} weeks before its sum");
            continue;
        }
        sum += hours;
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
