//! Quizzes of the chapters: a known-wrong program and four explanations, one of which is right.
//!
//! `tests/wrong/labN.toml`, beside the programs, lists them.
//!
//! ```toml
//! [[quiz]]
//! program = "corner_forgotten"   # a section of tests/wrong/labN.md
//! question = "What a test saw, and what to find."
//!
//! [[quiz.answers]]
//! line = "for bin in 1..bins {"  # a line of the function, without its indent
//! why = "The loop leaves out the first bin."
//! refutation = "The first bin is …"   # of the three that are wrong
//! ```

use anyhow::{Context, Result, anyhow, ensure};
use serde::Deserialize;

use crate::answers::{self, MarkedFile, Part, indent};
use crate::files::read_toml_at;
use crate::kit::Kit;
use crate::lab::Lab;
use crate::wrong::{self, Wrong};

/// A known-wrong program, with possible explanations.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Quiz {
    /// Name of the known-wrong program.
    pub program: String,
    /// Observation about the program, and the question.
    pub question: String,
    /// Four explanations, one of which is right.
    pub answers: Vec<Answer>,
}

/// An explanation of the observation.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Answer {
    /// Line that the explanation blames.
    pub line: String,
    /// Reason why that line would be the cause.
    pub why: String,
    /// Reason why it is not the cause; `None` for the right explanation.
    pub refutation: Option<String>,
}

/// Parses the words of a marker `{{#quiz LAB PROGRAM}}`: a lab and one of its known-wrong programs.
///
/// # Errors
/// If a word is missing, or if the first word is not a lab.
pub fn marked(words: &str) -> Result<(Lab, &str)> {
    let (lab, program) = words.split_once(' ').context("a quiz has a lab and a program")?;
    Ok((lab.parse().map_err(|error| anyhow!("quiz: {error}"))?, program))
}

/// Returns the quiz about a lab's known-wrong `program`, as Markdown.
///
/// Returns `None` if the kit has no known-wrong programs of this lab. A class's kit has none.
///
/// # Errors
/// If the lab has no quiz about this program, or if the quiz does not fit the program.
pub fn markdown(kit: &Kit, lab: Lab, program: &str) -> Result<Option<String>> {
    let all = wrong::read(kit, lab)?;
    if all.is_empty() {
        return Ok(None);
    }
    let quizzes = read(kit, lab)?;
    let quiz = quizzes.iter().find(|quiz| quiz.program == program);
    let quiz = quiz.with_context(|| format!("lab {lab} has no quiz about '{program}'"))?;
    let wrong = all.iter().find(|wrong| wrong.name == program);
    let wrong = wrong.with_context(|| format!("{} has no '{program}'", wrong::page(lab)))?;
    let code = function(&answers::read_solution(kit, lab)?, wrong)
        .with_context(|| format!("'{program}' is not in a function"))?;
    check(quiz, &code).with_context(|| format!("quiz '{program}'"))?;
    Ok(Some(rendered(quiz, wrong, &code)))
}

/// Reads the quizzes of a lab; empty if the lab has none.
fn read(kit: &Kit, lab: Lab) -> Result<Vec<Quiz>> {
    let path = kit.path(format!("tests/wrong/lab{lab}.toml"));
    if !path.is_file() {
        return Ok(Vec::new());
    }
    read_toml_at(&path, "/quiz")?.with_context(|| format!("{} has no quiz", path.display()))
}

/// Checks that a quiz has four answers, one of them right, and that each answer blames one line.
fn check(quiz: &Quiz, code: &str) -> Result<()> {
    let right = quiz.answers.iter().filter(|answer| answer.refutation.is_none()).count();
    ensure!(quiz.answers.len() == 4 && right == 1, "it needs four answers, one of them right");
    for Answer { line, .. } in &quiz.answers {
        let found = code.lines().filter(|text| text.trim() == line).count();
        ensure!(found == 1, "the line '{line}' is there {found} times");
    }
    Ok(())
}

/// Writes the program, the question, and each answer with a fold that confirms or refutes it.
///
/// The answers are in the order of their lines.
fn rendered(quiz: &Quiz, wrong: &Wrong, code: &str) -> String {
    let mut answers: Vec<&Answer> = quiz.answers.iter().collect();
    answers.sort_by_key(|answer| code.lines().position(|line| line.trim() == answer.line));
    let mut out = format!(
        "<details class=\"quiz\"><summary>Find the fault in an answer to task {}, once yours is right</summary>\n\n\
         This answer compiles. {}\n\n```rust,ignore\n{code}```\n\n",
        wrong.region.task,
        quiz.question.trim()
    );
    for Answer { line, why, refutation } in answers {
        let says = format!("`{line}`: {why}");
        let reply = refutation.as_ref().unwrap_or(&wrong.story);
        out += &choice(&quiz.program, &says, refutation.is_none(), reply);
    }
    out + "</details>\n"
}

/// Returns an answer of a quiz: a fold with the reply to it.
///
/// Only one of the folds with the same `name` is open at a time.
pub fn choice(name: &str, says: &str, is_right: bool, reply: &str) -> String {
    let (class, verdict) = if is_right { (" class=\"is-right\"", "Yes") } else { ("", "No") };
    format!(
        "<details name=\"{name}\"{class}><summary>\n\n{says}\n\n</summary>\n\n{verdict}. {reply}\n\n</details>\n\n"
    )
}

/// Returns the function around a known-wrong program's region, with the wrong body in it.
fn function(files: &[MarkedFile], wrong: &Wrong) -> Option<String> {
    let mut files = files.iter().map(|file| &file.parts);
    let (parts, at, region) = files.find_map(|parts| {
        parts.iter().enumerate().find_map(|(at, part)| match part {
            Part::Answer(region) if region.id == wrong.region => Some((parts, at, region)),
            _ => None,
        })
    })?;
    let before: String = parts[..at].iter().map(Part::text).collect();
    let after: String = parts[at + 1..].iter().map(Part::text).collect();
    let before: Vec<&str> = before.lines().collect();
    let first =
        before.iter().rposition(|line| line.split_whitespace().take(2).any(|word| word == "fn"))?;
    let head = &before[first..];
    let outer = indent(head[0]);
    let end = format!("{:outer$}}}", "");
    let tail = after.lines().position(|line| line == end)?;
    let inner = indent(region.body.lines().find(|line| !line.is_empty())?) - outer;

    let mut lines: Vec<String> = head.iter().map(|line| without_indent(line, outer)).collect();
    for line in wrong.body.lines() {
        lines.push(if line.is_empty() { String::new() } else { format!("{:inner$}{line}", "") });
    }
    lines.extend(after.lines().take(tail + 1).map(|line| without_indent(line, outer)));
    Some(lines.join("\n") + "\n")
}

fn without_indent(line: &str, indent: usize) -> String {
    line.get(indent..).unwrap_or_default().to_owned()
}

#[cfg(test)]
mod tests {
    use super::{Answer, Quiz, check, markdown, read};
    use crate::kit::Kit;
    use crate::wrong;

    const CODE: &str = "fn f() {\n    a;\n    b;\n    c;\n    d;\n    d;\n}\n";

    fn quiz(lines: &[&str], right: usize) -> Quiz {
        let mut answers = Vec::new();
        for (at, line) in lines.iter().enumerate() {
            let refutation = (at >= right).then(|| "It is not.".to_owned());
            answers.push(Answer { line: (*line).into(), why: "It is.".into(), refutation });
        }
        Quiz { program: "p".into(), question: "Why?".into(), answers }
    }

    #[test]
    fn a_quiz_has_four_answers_one_right_each_about_one_line() {
        for (lines, right, error) in [
            (&["fn f() {", "a;", "b;", "c;"][..], 1, None),
            (&["a;", "b;", "c;"], 1, Some("it needs four answers, one of them right")),
            (&["fn f() {", "a;", "b;", "c;"], 2, Some("it needs four answers, one of them right")),
            (&["a;", "b;", "c;", "d;"], 1, Some("the line 'd;' is there 2 times")),
            (&["a;", "b;", "c;", "e;"], 1, Some("the line 'e;' is there 0 times")),
        ] {
            let found = check(&quiz(lines, right), CODE).err().map(|error| error.to_string());
            assert_eq!(found.as_deref(), error);
        }
    }

    #[test]
    fn every_quiz_of_the_kit_is_in_its_chapter() {
        let kit = Kit::find().unwrap();
        for lab in kit.solutions() {
            let chapter = std::fs::read_to_string(kit.path(format!("book/src/lab{lab}.md")));
            for quiz in read(&kit, lab).unwrap() {
                let text = markdown(&kit, lab, &quiz.program).unwrap().unwrap();
                assert_eq!(text.matches("<summary>").count(), 5);
                assert_eq!(text.matches("\n\nYes. ").count(), 1);
                let marker = format!("{{{{#quiz {lab} {}}}}}", quiz.program);
                assert!(chapter.as_ref().unwrap().contains(&marker), "{marker}");
            }
        }
    }

    #[test]
    fn a_class_s_kit_has_none() {
        let folder = tempfile::tempdir().unwrap();
        let kit = Kit::of_files(folder.path(), &[("labs/lab1/lab.toml", "")]);
        let lab = "1".parse().unwrap();
        assert!(wrong::read(&kit, lab).unwrap().is_empty());
        assert_eq!(markdown(&kit, lab, "p").unwrap(), None);
    }
}
