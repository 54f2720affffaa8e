//! The page of a sheet: its questions, and the key on a new page.

use super::changes::{Change, Line};
use crate::asking::Said;
use lab_kit::Lab;
use lab_kit::submission::Sources;

/// Maximal number of lines shown of a function, and of a message.
const SHOWN: usize = 40;
const MESSAGE: usize = 8;

/// Questions about a submission, with their keys.
#[derive(Debug, Default)]
pub(super) struct Sheet {
    questions: Vec<(String, String)>,
    /// Number of changed programs that were built.
    pub(super) tried: usize,
}

impl Sheet {
    pub(super) fn len(&self) -> usize {
        self.questions.len()
    }

    /// Adds a question about a line.
    pub(super) fn ask_about_line(
        &mut self,
        sources: &Sources,
        line: &Line,
        question: &str,
        key: &str,
    ) {
        let code = function(sources, line, &[format!("{}   // <- this line", line.text)]);
        self.questions
            .push((format!("{question}\n\n{}\n\n```rust\n{code}```\n", line.place()), key.into()));
    }

    /// Adds a question about a changed line, if a test fails because of it.
    ///
    /// `tasks` are the tasks with the results of the program and of the changed program. Returns
    /// whether the question was added.
    pub(super) fn ask_about_change<'a>(
        &mut self,
        sources: &Sources,
        change: &Change,
        tasks: impl Iterator<Item = (&'a String, (&'a Said, &'a Said))>,
    ) -> bool {
        let mut key = String::new();
        let lost =
            tasks.filter(|(_, (before, after))| before.wrong.is_none() && !after.failed.is_empty());
        for (task, (_, after)) in lost {
            let message = after.wrong.as_deref().unwrap_or_default();
            let message: Vec<&str> = message.lines().take(MESSAGE).collect();
            key += &format!(
                "Task {task} fails: `{}`.\n\n```text\n{}\n```\n\n",
                after.failed.join("`, `"),
                message.join("\n")
            );
        }
        if key.is_empty() {
            return false;
        }
        key.extend(change.story.as_ref().map(|story| format!("A known mistake: {story}\n")));
        let line = &change.line;
        let mut lines = vec![format!("-{}", line.text)];
        if !change.new.is_empty() {
            lines.push(format!("+{}", change.new));
        }
        let code = function(sources, line, &lines);
        let question = format!(
            "Here is your program with one line changed. Which test fails, what does a user see, and why?\n\n{}\n\n\
             ```diff\n{code}```\n",
            line.place()
        );
        self.questions.push((question, key));
        true
    }

    /// Returns the page, as Markdown.
    pub(super) fn page(&self, lab: Lab, name: &str, seed: u64) -> String {
        let (mut questions, mut keys) = (String::new(), String::new());
        for (number, (question, key)) in (1..).zip(&self.questions) {
            questions += &format!("## {number}\n\n{question}\n");
            keys += &format!("## Key to {number}\n\n{key}\n");
        }
        format!(
            "# Lab {lab}: {name}\n\nSeed {seed}. Five minutes. The key begins on a new page.\n\n{questions}\
             <div style=\"break-before: page\"></div>\n\n# Key to lab {lab}: {name}\n\n\
             The keys were read from runs of the programs.\n\n{keys}"
        )
    }
}

impl Line {
    /// Returns the line's task, file and number, in words.
    fn place(&self) -> String {
        let task = self.task.map_or("A function of your own".into(), |task| format!("Task {task}"));
        format!("{task}, `{}`, line {}:", self.path, self.at + 1)
    }

    /// Returns the line with its number, for a list.
    pub(super) fn quoted(&self) -> String {
        format!("line {} of `{}`, `{}`", self.at + 1, self.path, self.text)
    }
}

/// Returns the function around a line, with `new` instead of the line.
///
/// The signs `-` and `+` of a new line stand before its indent.
fn function(sources: &Sources, line: &Line, new: &[String]) -> String {
    let text = String::from_utf8_lossy(sources.get(&line.path).map_or(&[], Vec::as_slice));
    let lines: Vec<&str> = text.lines().collect();
    let indent = |line: &str| line.len() - line.trim_start().len();
    let is_head = |line: &&str| line.split_whitespace().take(3).any(|word| word == "fn");
    let head = lines[..=line.at].iter().rposition(is_head).unwrap_or(0);
    let (outer, inner) = (indent(lines[head]), indent(lines[line.at]));
    let end = format!("{:outer$}}}", "");
    let tail = lines[line.at..].iter().position(|line| *line == end);
    let tail = line.at + tail.unwrap_or(lines.len() - line.at - 1);
    let first = head.max(line.at.saturating_sub(SHOWN / 2));
    let last = tail.min(first + SHOWN);
    let is_diff = new[0].starts_with('-') && new[0][1..] == line.text;
    let blank = if is_diff { " " } else { "" };
    let mut shown = String::new();
    for (at, text) in lines.iter().enumerate().take(last + 1).skip(first) {
        if at != line.at {
            shown += &format!("{blank}{}\n", text.get(outer..).unwrap_or_default());
            continue;
        }
        for new in new {
            let (sign, code) = if is_diff { new.split_at(1) } else { ("", new.as_str()) };
            shown += &format!("{sign}{:width$}{code}\n", "", width = inner - outer.min(inner));
        }
    }
    shown
}
