//! The parts that every chapter has: its [opening](crate::opening), its headings, an idea that is drawn before a
//! task needs it, and for each figure words for readers who cannot see it.

use anyhow::Result;

use crate::chapter::{before_build, figures, items, moves, section, wordless};
use crate::opening::openings;
use lab_kit::files::read_text;
use lab_kit::{Kit, Lab, hints};

/// Headings that a chapter has, in this order.
const HEADINGS: [&str; 9] = [
    "## Predict",
    "## Build",
    "## Test",
    "## Measure",
    "## Explain",
    "## The predictions",
    "## Test your understanding",
    "## Go further",
    "## In writing",
];

/// Chapters without one of their parts.
///
/// # Errors
/// A chapter, its hints or `book/chapters.toml` cannot be read.
pub(crate) fn check(kit: &Kit) -> Result<Vec<String>> {
    let mut openings = openings(kit)?;
    let mut wrong = Vec::new();
    for lab in kit.solutions()? {
        let Some(chapter) = kit.chapter(lab) else { continue };
        let text = read_text(&kit.path(&chapter))?;
        wrong.extend(missing(&text, lab).into_iter().map(|what| format!("{chapter}: {what}")));
        let Some(opening) = openings.remove(&format!("lab{lab}")) else {
            wrong.push(format!("book/chapters.toml has no lab {lab}"));
            continue;
        };
        let tasks: Vec<String> =
            hints::read(kit, lab)?.iter().map(|hint| hint.task.to_string()).collect();
        let odd = opening.tasks.keys().filter(|task| !tasks.contains(task));
        let untold = tasks.iter().filter(|task| !opening.tasks.contains_key(*task));
        let fault =
            |task| format!("book/chapters.toml: lab {lab} and its hints differ in task {task}");
        wrong.extend(odd.chain(untold).map(fault));
    }
    wrong.extend(
        openings.keys().map(|lab| format!("book/chapters.toml: there is no chapter of {lab}")),
    );
    Ok(wrong)
}

/// What a chapter lacks.
fn missing(text: &str, lab: Lab) -> Vec<String> {
    let mut faults = Vec::new();
    let marker = format!("{{{{#opening {lab}}}}}");
    if !text.contains(&marker) {
        faults.push(format!("there is no {marker}"));
    }
    let mut rest = text;
    for heading in HEADINGS {
        match section(rest, heading) {
            Some(after) => rest = after,
            None => faults.push(format!("'{heading}' is missing, or not in its place")),
        }
    }
    let between = |from, to| {
        let after = section(text, from).unwrap_or_default();
        &after[..after.find(&format!("\n{to}\n")).unwrap_or(after.len())]
    };
    if figures(before_build(text)).next().is_none() {
        faults.push("no figure before 'Build'".into());
    }
    if !moves(text) {
        faults.push("no figure that moves".into());
    }
    faults.extend(figures(text).filter_map(wordless));
    let build = between("## Build", "## Test");
    if !build.contains("<img src=\"figures/") && !build.contains("```text") {
        faults.push("no picture between 'Build' and 'Test'".into());
    }
    if !text.split("\n\n").any(|part| part.starts_with("Checkpoint: ") && part.contains("cargo ")) {
        faults.push("no paragraph 'Checkpoint: …' with a command of cargo".into());
    }
    let questions = items(between("## Test your understanding", "## Go further")).len();
    if questions != 5 {
        faults.push(format!("{questions} questions to test one's understanding, not 5"));
    }
    let answers = between("## The predictions", "## Test your understanding");
    let (asked, answered) = (items(between("## Predict", "## Build")), items(answers));
    if asked.len() != answered.len() {
        faults.push(format!("{} predictions and {} answers", asked.len(), answered.len()));
    }
    for (at, answer) in answered.iter().enumerate() {
        // Its own number does not count.
        if !answer
            .split_once(". ")
            .is_some_and(|(_, text)| text.contains(|c: char| c.is_ascii_digit()))
        {
            faults.push(format!("the answer to prediction {} has no number", at + 1));
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::check;
    use crate::opening::opening;
    use lab_kit::Kit;

    const CHAPTER: &str = "# Lab 1\n\n{{#opening 1}}\n\n## Predict\n\n1. How long?\n2. How\n   often?\n\n\
        <figure class=\"live\">\n<img src=\"figures/a.svg\" alt=\"Discs\">\n<figcaption>Two.</figcaption>\n</figure>\n\n\
        ## Build\n\n```text\n●──▶\n```\n\nCheckpoint: now `cargo lab run 1` says 5.\n\n## Test\n\n\
        ## Measure\n\n## Explain\n\n## The predictions\n\n1. For 3 s.\n\
        2. Often:\n   7 times.\n\n## Test your understanding\n\n1. A?\n2. B?\n3. C?\n4. D?\n5. E?\n\n\
        ## Go further\n\n## In writing\n\nA page.\n";
    const OPENING: &str = "[lab1]\nneeds = 'only Rust'\nable = ['fly']\nbefore = ['[it](x.md)']\nreading = 1.0\n\
        [lab1.tasks]\n'1.1' = { hours = 1.5, mark = 2 }\n";

    fn with<T>(chapter: &str, openings: &str, test: impl FnOnce(&Kit) -> T) -> T {
        let folder = tempfile::tempdir().unwrap();
        let files = [
            ("solutions/lab1/Cargo.toml", ""),
            ("labs/lab1/hints.md", "## Task 1.1: the force\n1. a\n2. b\n3. c\n"),
            ("book/src/lab1.md", chapter),
            ("book/chapters.toml", openings),
        ];
        test(&Kit::of_files(folder.path(), &files))
    }

    fn faults(chapter: &str) -> Vec<String> {
        with(chapter, OPENING, |kit| check(kit).unwrap())
    }

    #[test]
    fn an_opening_says_what_the_list_says() {
        let text = with(CHAPTER, OPENING, |kit| opening(kit, "1").unwrap());
        assert!(text.starts_with("*About 2 hours. You need only Rust.*"), "{text}");
        for part in ["\n- fly\n", "\n- [it](x.md)\n", "| 1.1 | the force | 1.5 | ●●○ |"] {
            assert!(text.contains(part), "{text}");
        }
        assert!(with(CHAPTER, OPENING, |kit| opening(kit, "2").is_err()));
    }

    #[test]
    fn a_whole_chapter_passes() {
        assert_eq!(faults(CHAPTER), [""; 0]);
    }

    #[test]
    fn each_part_is_missed() {
        for (part, other, why) in [
            ("{{#opening 1}}", "", "no {{#opening 1}}"),
            ("## In writing", "## Later", "'## In writing' is missing"),
            (" class=\"live\"", "", "no figure that moves"),
            ("alt=\"Discs\"", "alt=\"\"", "figures/a.svg has no alternative text"),
            ("Two.", "", "figures/a.svg has no caption"),
            ("```text\n●──▶\n```", "", "no picture"),
            ("Checkpoint: ", "", "no paragraph 'Checkpoint"),
            ("`cargo lab run 1`", "it", "no paragraph 'Checkpoint"),
            ("1. For 3 s.\n", "", "2 predictions and 1 answers"),
            ("For 3 s", "Long", "prediction 1 has no number"),
            ("5. E?\n", "", "4 questions"),
        ] {
            let faults = faults(&CHAPTER.replace(part, other));
            assert!(faults.len() == 1 && faults[0].contains(why), "without {part}: {faults:?}");
        }
        let faults = faults(&CHAPTER.replace("<figure", "<p"));
        assert!(faults[0].contains("no figure before 'Build'"), "{faults:?}");
    }

    #[test]
    fn tasks_are_those_of_the_hints() {
        let faults = |openings: &str| with(CHAPTER, openings, |kit| check(kit).unwrap());
        let other = faults(&OPENING.replace("'1.1'", "'1.2'"));
        assert!(other.len() == 2 && other[0].contains("task 1.2"), "{other:?}");
        assert!(faults("")[0].contains("no lab 1"));
        assert!(
            faults(&(OPENING.to_owned() + &OPENING.replace("lab1", "lab2")))[0].contains("lab2")
        );
    }
}
