//! Known-wrong programs: `tests/wrong/labN.md`, a page for each lab.
//!
//! Each program is a wrong body for one region of the solution, in a section of the page:
//!
//! ````text
//! ## corners_forgotten
//!
//! The four corner bins are forgotten.
//!
//! - region: 2.4
//! - fails: `task_2_4::nine_bins`, `task_2_4::rebuild_steps`
//! - also loses: 2.7
//!
//! ```rust
//! …body…
//! ```
//! ````
//!
//! A long body can be a diff of the answer instead, in a block called `diff`. Lines with `-` are
//! replaced by lines with `+`, lines with a blank stay, and an empty line ends a change. The old
//! lines of a change must occur once in the answer.
//!
//! A program loses the marks of its region's task. The line `also loses` names other tasks that
//! lose their marks because their questions need that task.
//!
//! Unusual programs that are right are kept in `tests/right/labN.md` in the same form, with
//! `passes` instead of `fails`. They keep all marks.

use std::collections::BTreeSet;

use anyhow::{Context, Error, Result, anyhow, bail, ensure};

use crate::answers::{self, MarkedFile, Part, RegionId, Task, indent};
use crate::files::read_text;
use crate::kit::Kit;
use crate::lab::Lab;
use crate::sources::{Sources, of_solution};
use crate::starter::rename;

/// A wrong answer to a task, or an unusual right one.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// Heading of the answer's section.
    pub name: String,
    /// Region that the answer replaces.
    pub region: RegionId,
    /// Tests that must fail with this answer; empty if it is right.
    pub fails: Vec<String>,
    /// Tests that must pass with this answer, if it is right.
    pub passes: Vec<String>,
    /// Other tasks that lose their marks too, because their questions need this task.
    pub loses: Vec<Task>,
    /// Description of the mistake, or of the unusual idea.
    pub story: String,
    /// Body that replaces the answer.
    pub body: String,
}

/// Reads the known-wrong programs of a lab; empty if it has no page yet.
pub fn read(kit: &Kit, lab: Lab) -> Result<Vec<Wrong>> {
    read_page(kit, lab, &page(lab))
}

/// Reads the unusual right programs of a lab; empty if it has no page.
pub fn read_right(kit: &Kit, lab: Lab) -> Result<Vec<Wrong>> {
    read_page(kit, lab, &right_page(lab))
}

fn read_page(kit: &Kit, lab: Lab, page: &str) -> Result<Vec<Wrong>> {
    let path = kit.path(page);
    if !path.is_file() {
        return Ok(Vec::new());
    }
    let text = read_text(&path)?;
    let files = answers::read_solution(kit, lab)?;
    let sections = text.split("\n## ").skip(1);
    let all: Vec<Wrong> = sections
        .map(|section| complete(lab, section, &files).with_context(|| page.to_owned()))
        .collect::<Result<_>>()?;
    let mut names = BTreeSet::new();
    for wrong in &all {
        ensure!(names.insert(&wrong.name), "{page}: there are two sections '{}'", wrong.name);
    }
    Ok(all)
}

/// Returns the page of a lab's known-wrong programs, below the kit's top folder.
pub fn page(lab: Lab) -> String {
    format!("tests/wrong/lab{lab}.md")
}

/// Returns the page of a lab's unusual right programs, below the kit's top folder.
pub fn right_page(lab: Lab) -> String {
    format!("tests/right/lab{lab}.md")
}

impl Wrong {
    /// Returns the solution with this answer in it, as a submission.
    pub fn in_solution(&self, kit: &Kit, lab: Lab) -> Result<Sources> {
        let mut sources = of_solution(kit, lab)?;
        for file in answers::read_solution(kit, lab)? {
            if !file.regions().any(|region| region.id == self.region) {
                continue;
            }
            let parts = file.parts.iter().map(|part| match part {
                Part::Answer(region) if region.id == self.region => self.body.as_str(),
                other => other.text(),
            });
            let text = rename(&parts.collect::<String>(), lab);
            sources.insert(file.path.to_string_lossy().into_owned(), text.into_bytes());
        }
        Ok(sources)
    }
}

/// Parses a section of the page, and applies its diff if it has one.
fn complete(lab: Lab, section: &str, files: &[MarkedFile]) -> Result<Wrong> {
    let mut wrong = parse(lab, section)?;
    if section.contains("\n```diff\n") {
        let name = &wrong.name;
        let region = wrong.region;
        let mut regions = files.iter().flat_map(MarkedFile::regions);
        let answer = regions.find(|answer| answer.id == region);
        let answer = answer.with_context(|| format!("'{name}': no region {region}"))?;
        let body = patched(&answer.body, &wrong.body).with_context(|| format!("'{name}'"))?;
        wrong.body = body;
    }
    Ok(wrong)
}

/// Applies the changes of a diff to an answer, after removing the answer's common indentation.
fn patched(answer: &str, diff: &str) -> Result<String> {
    let filled = answer.lines().filter(|line| !line.is_empty());
    let outer = filled.map(indent).min().unwrap_or(0);
    let mut lines: Vec<&str> =
        answer.lines().map(|line| line.get(outer..).unwrap_or_default()).collect();
    for change in diff.split("\n\n") {
        let old = without(change, '+');
        let places: Vec<usize> =
            (0..lines.len()).filter(|&first| lines[first..].starts_with(&old)).collect();
        let &[place] = &places[..] else {
            let lines = old.join("\n");
            bail!("{} places of the answer have these lines, not one:\n{lines}", places.len());
        };
        lines.splice(place..place + old.len(), without(change, '-'));
    }
    Ok(lines.join("\n") + "\n")
}

/// Returns the lines of a change that do not begin with `sign`, without their first characters.
fn without(change: &str, sign: char) -> Vec<&str> {
    change.lines().filter(|line| !line.starts_with(sign)).map(|line| &line[1..]).collect()
}

/// Parses a section of the page, from its name to the end of its code.
fn parse(lab: Lab, section: &str) -> Result<Wrong> {
    let (name, text) = section.split_once('\n').context("the last section is empty")?;
    let name = name.trim();
    parse_named(lab, name, text).map_err(|why| anyhow!("'{name}': {why}"))
}

/// Parses the text below a section's name.
fn parse_named(lab: Lab, name: &str, text: &str) -> Result<Wrong> {
    let (head, code) = text.split_once("\n```").context("no code")?;
    let (_, code) = code.split_once('\n').unwrap_or_default();
    let (body, _) = code.split_once("\n```").context("no code")?;
    let region: RegionId = needed(head, "- region:")?.parse().map_err(Error::msg)?;
    ensure!(region.task.lab == lab, "task {region} is not of lab {lab}");
    let passes = field(head, "- passes:").map(tests).unwrap_or_default();
    let fails = if passes.is_empty() { tests(needed(head, "- fails:")?) } else { Vec::new() };
    let loses = field(head, "- also loses:").into_iter().flat_map(|tasks| tasks.split(','));
    let loses = loses.map(|task| task.trim().parse().map_err(Error::msg)).collect::<Result<_>>()?;
    let story = head.split("\n- region:").next().unwrap_or_default();
    let story = story.split_whitespace().collect::<Vec<_>>().join(" ");
    ensure!(!story.is_empty(), "its description is missing");
    ensure!(!body.trim().is_empty(), "no code");
    let body = format!("{body}\n");
    Ok(Wrong { name: name.into(), region, fails, passes, loses, story, body })
}

/// Returns the rest of the line that begins with `name`; `None` if there is no such line.
fn field<'h>(head: &'h str, name: &str) -> Option<&'h str> {
    head.lines().find_map(|line| line.strip_prefix(name)).map(str::trim)
}

fn needed<'h>(head: &'h str, name: &str) -> Result<&'h str> {
    field(head, name).with_context(|| format!("no line '{name} …'"))
}

fn tests(list: &str) -> Vec<String> {
    list.split(',').map(|test| test.trim().replace('`', "")).collect()
}

#[cfg(test)]
mod tests {
    use super::{parse, patched, read};
    use crate::kit::Kit;

    const SECTION: &str = "corner\n\nOne:\ntwo.\n\n- region: 2.4b\n- fails: `task_2_4::a`, `task_2_5::b`\n\n\
                           ```rust\n// why\nreturn 1;\n```\n";

    #[test]
    fn a_section_is_read() {
        let wrong = parse("2".parse().unwrap(), SECTION).unwrap();
        assert_eq!((wrong.region.to_string(), &*wrong.story), ("2.4b".into(), "One: two."));
        assert_eq!(wrong.fails, ["task_2_4::a", "task_2_5::b"]);
        assert!(wrong.loses.is_empty());
        assert_eq!(wrong.body, "// why\nreturn 1;\n");
    }

    #[test]
    fn a_diff_changes_the_answer() {
        let answer = "    let a = 1;\n    if a {\n        b();\n    }\n";
        let body = patched(answer, "-let a = 1;\n+let a = 2;\n\n     b();\n+    c();\n").unwrap();
        assert_eq!(body, "let a = 2;\nif a {\n    b();\n    c();\n}\n");
        let error = patched(answer, "-let b = 1;\n").unwrap_err().to_string();
        assert!(error.starts_with("0 places of the answer"), "{error}");
    }

    #[test]
    fn every_diff_fits_its_answer() {
        let kit = Kit::find().unwrap();
        kit.solutions().into_iter().for_each(|lab| _ = read(&kit, lab).unwrap());
    }

    #[test]
    fn a_right_program_names_tests_that_pass() {
        let section = SECTION.replace("fails", "passes");
        let right = parse("2".parse().unwrap(), &section).unwrap();
        assert!(right.fails.is_empty());
        assert_eq!(right.passes, ["task_2_4::a", "task_2_5::b"]);
    }

    #[test]
    fn whose_marks_go_with_it_is_read() {
        let section = SECTION.replace("\n\n```r", "\n- also loses: 2.4, 2.7\n\n```r");
        let wrong = parse("2".parse().unwrap(), &section).unwrap();
        let lost: Vec<String> = wrong.loses.iter().map(ToString::to_string).collect();
        assert_eq!(lost, ["2.4", "2.7"]);
    }

    #[test]
    fn what_is_missing_is_named() {
        for (from, to, message) in [
            ("return 1;\n", "", None),
            ("// why\nreturn 1;\n", "", Some("'corner': no code")),
            ("- fails: `task_2_4::a`, `task_2_5::b`\n", "", Some("'corner': no line '- fails: …'")),
            ("2.4b", "3.4", Some("'corner': task 3.4 is not of lab 2")),
            ("One:\ntwo.\n", "", Some("'corner': its description is missing")),
            (
                "2.4b",
                "two",
                Some("'corner': 'two' is not the number of a task, such as 3.2 or 3.2b"),
            ),
        ] {
            let error = parse("2".parse().unwrap(), &SECTION.replace(from, to)).err();
            assert_eq!(error.map(|error| error.to_string()).as_deref(), message);
        }
    }

    #[test]
    fn names_are_used_once() {
        let folder = tempfile::tempdir().unwrap();
        let page = format!("# Lab 2\n\n## {SECTION}\n## {SECTION}");
        let kit = Kit::of_files(folder.path(), &[("tests/wrong/lab2.md", &page)]);
        let error = read(&kit, "2".parse().unwrap()).unwrap_err().to_string();
        assert_eq!(error, "tests/wrong/lab2.md: there are two sections 'corner'");
        assert_eq!(read(&kit, "3".parse().unwrap()).unwrap(), []);
    }
}
