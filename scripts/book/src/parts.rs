//! The parts that every chapter has: its [opening](crate::labs::opening), its headings, an idea that is drawn before a
//! task needs it, and for each figure words for readers who cannot see it. Its title and its tasks are those of the
//! lab's [facts](lab_kit::Facts).

use anyhow::Result;

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
pub(crate) fn check(kit: &Kit) -> Result<Vec<String>> {
    let mut wrong = Vec::new();
    let summary = read_text(&kit.path("book/src/SUMMARY.md"))?;
    for lab in kit.solutions() {
        let Some(chapter) = kit.chapter(lab) else { continue };
        let text = read_text(&kit.path(&chapter))?;
        wrong.extend(missing(&text, lab).into_iter().map(|what| format!("{chapter}: {what}")));
        let facts = kit.facts(lab)?;
        let title = titled(lab, &facts.title);
        if !text.starts_with(&format!("# {title}\n")) {
            wrong.push(format!("{chapter}: its title is not '{title}'"));
        }
        if !summary.contains(&format!("- [{title}](lab{lab}.md)\n")) {
            wrong.push(format!("book/src/SUMMARY.md: there is no [{title}](lab{lab}.md)"));
        }
        let tasks: Vec<String> =
            hints::read(kit, lab)?.iter().map(|hint| hint.task.to_string()).collect();
        let odd = facts.tasks.keys().filter(|task| !tasks.contains(task));
        let untold = tasks.iter().filter(|task| !facts.tasks.contains_key(*task));
        let fault = |task| format!("lab {lab}: lab.toml and hints.md differ in task {task}");
        wrong.extend(odd.chain(untold).map(fault));
    }
    Ok(wrong)
}

/// `Lab 2: Bins`, as chapters are called.
fn titled(lab: Lab, title: &str) -> String {
    let mut letters = title.chars();
    let first = letters.next().map(|first| first.to_uppercase().collect::<String>());
    format!("Lab {lab}: {}{}", first.unwrap_or_default(), letters.as_str())
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
            None => faults.push(format!("'{heading}' is missing, or in the wrong order")),
        }
    }
    let between = |from, to| {
        let after = section(text, from).unwrap_or_default();
        &after[..after.find(&format!("\n{to}\n")).unwrap_or(after.len())]
    };
    if figures(text.split("\n## Build\n").next().unwrap_or_default()).next().is_none() {
        faults.push("no figure before 'Build'".into());
    }
    // A box that plays, or a run to step through.
    if !["live", "steps"].iter().any(|kind| text.contains(&format!("<figure class=\"{kind}\""))) {
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

/// The figures, from `<figure` to its end.
fn figures(text: &str) -> impl Iterator<Item = &str> {
    text.split("<figure").skip(1).filter_map(|rest| rest.split("</figure>").next())
}

/// What a figure lacks for a reader who cannot see it, or sees it still. A figure of text is its own words.
fn wordless(figure: &str) -> Option<String> {
    let is_text = figure.contains("```text");
    let within = |from: &str, to: &str| {
        let words = figure.split_once(from).and_then(|(_, rest)| rest.split(to).next());
        words.is_some_and(|words| !words.trim().is_empty())
    };
    let file = figure.split_once("src=\"").and_then(|(_, rest)| rest.split('"').next());
    let name = file.unwrap_or("without a picture");
    let lacks = [
        (!is_text && !within("alt=\"", "\""), "alternative text"),
        (!within("<figcaption>", "</figcaption>"), "caption"),
    ];
    let lacks: Vec<_> =
        lacks.into_iter().filter_map(|(lacks, what)| lacks.then_some(what)).collect();
    (!lacks.is_empty()).then(|| format!("the figure {name} has no {}", lacks.join(" and no ")))
}

/// What follows a heading.
fn section<'t>(text: &'t str, heading: &str) -> Option<&'t str> {
    text.split_once(&format!("\n{heading}\n")).map(|(_, rest)| rest)
}

/// The items of a numbered list, from line to line.
fn items(text: &str) -> Vec<String> {
    let mut items: Vec<String> = Vec::new();
    for line in text.lines() {
        let numbered = line.split_once(". ").is_some_and(|(n, _)| n.parse::<u8>().is_ok());
        match items.last_mut() {
            _ if numbered => items.push(line.into()),
            Some(item) if line.starts_with(' ') => *item += line,
            _ => {}
        }
    }
    items
}

#[cfg(test)]
mod tests {
    use super::check;
    use crate::labs::opening;
    use lab_kit::Kit;

    const CHAPTER: &str = "# Lab 1: All\n\n{{#opening 1}}\n\n## Predict\n\n1. How long?\n2. How\n   often?\n\n\
        <figure class=\"live\">\n<img src=\"figures/a.svg\" alt=\"Discs\">\n<figcaption>Two.</figcaption>\n</figure>\n\n\
        ## Build\n\n```text\n●──▶\n```\n\nCheckpoint: now `cargo lab run 1` says 5.\n\n## Test\n\n\
        ## Measure\n\n## Explain\n\n## The predictions\n\n1. For 3 s.\n\
        2. Often:\n   7 times.\n\n## Test your understanding\n\n1. A?\n2. B?\n3. C?\n4. D?\n5. E?\n\n\
        ## Go further\n\n## In writing\n\nA page.\n";
    const FACTS: &str = "title = 'all'\ndiscs = 'soft'\nworkers = 'threads'\n\
        able = ['fly']\nbefore = ['[it](x.md)']\nreading = 1.0\n\
        [tasks]\n'1.1' = { points = 100, hours = 1.5, mark = 2, section = 'A' }\n";

    fn with<T>(chapter: &str, facts: &str, test: impl FnOnce(&Kit) -> T) -> T {
        let folder = tempfile::tempdir().unwrap();
        let files = [
            ("solutions/lab1/Cargo.toml", ""),
            ("labs/lab1/hints.md", "## Task 1.1: the force\n1. a\n2. b\n3. c\n"),
            ("solutions/lab1/lab.toml", facts),
            ("book/src/lab1.md", chapter),
            ("book/src/SUMMARY.md", "- [Lab 1: All](lab1.md)\n"),
        ];
        test(&Kit::of_files(folder.path(), &files))
    }

    fn faults(chapter: &str) -> Vec<String> {
        with(chapter, FACTS, |kit| check(kit).unwrap())
    }

    #[test]
    fn an_opening_says_what_the_list_says() {
        let text = with(CHAPTER, FACTS, |kit| opening(kit, "1").unwrap());
        assert!(text.starts_with("*About 2 hours. You need only Rust.*"), "{text}");
        for part in ["\n- fly\n", "\n- [it](x.md)\n", "| 1.1 | the force | 1.5 | ●●○ |"] {
            assert!(text.contains(part), "{text}");
        }
        assert!(with(CHAPTER, FACTS, |kit| opening(kit, "2").is_err()));
    }

    #[test]
    fn a_whole_chapter_passes() {
        assert_eq!(faults(CHAPTER), [""; 0]);
    }

    #[test]
    fn each_part_is_missed() {
        for (part, other, why) in [
            ("{{#opening 1}}", "", "no {{#opening 1}}"),
            ("# Lab 1: All", "# Lab 1: None", "its title is not 'Lab 1: All'"),
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
    fn title_and_tasks_are_those_of_the_lab() {
        let faults = |facts: &str| with(CHAPTER, facts, |kit| check(kit).unwrap());
        let other = faults(&FACTS.replace("'1.1'", "'1.2'"));
        assert!(other.len() == 2 && other[0].contains("task 1.2"), "{other:?}");
        let other = faults(&FACTS.replace("'all'", "'none'"));
        assert!(other.len() == 2 && other[1].contains("SUMMARY.md"), "{other:?}");
    }
}
