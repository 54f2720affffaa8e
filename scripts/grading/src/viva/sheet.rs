//! The page of a sheet: its questions, and the key on a new page.

use super::changes::{Line, is_head};
use lab_kit::Lab;
use lab_kit::sources::Sources;

/// Questions about a submission, with their keys.
#[derive(Debug, Default)]
pub(super) struct Sheet {
    pub(super) questions: Vec<(String, String)>,
}

impl Sheet {
    /// Adds a question about a line. The sheet shows the function that contains the line, with
    /// `new` in place of the line.
    pub(super) fn ask(
        &mut self,
        sources: &Sources,
        line: &Line,
        new: &str,
        question: &str,
        key: String,
    ) {
        let task = line.task.map_or("your own function".into(), |task| format!("task {task}"));
        let place = format!("`{}`, line {}, {task}", line.path, line.at + 1);
        let code = function(sources, line, new);
        self.questions.push((format!("{question}\n\n{place}:\n\n```diff\n{code}```"), key));
    }

    /// Returns the page, as Markdown.
    pub(super) fn page(&self, lab: Lab, name: &str, seed: u64) -> String {
        let mut questions = String::new();
        let mut keys = String::new();
        for (number, (question, key)) in (1..).zip(&self.questions) {
            questions += &format!("## {number}\n\n{question}\n\n");
            keys += &format!("## Key to {number}\n\n{}\n\n", key.trim_end());
        }
        format!(
            "# Lab {lab}: {name}\n\nSeed {seed}. Five minutes.\n\n{questions}\
             <div style=\"break-before: page\"></div>\n\n# Key to lab {lab}: {name}\n\n{keys}"
        )
    }
}

/// Returns the function that contains a line as a diff, with `new` instead of the line. If `new` is
/// the line itself, an arrow marks it.
fn function(sources: &Sources, line: &Line, new: &str) -> String {
    let text = String::from_utf8_lossy(sources.get(&line.path).map_or(&[], Vec::as_slice));
    let lines: Vec<&str> = text.lines().collect();
    let head = lines[..=line.at].iter().rposition(|line| is_head(line)).unwrap_or(line.at);
    let outer = &lines[head][..lines[head].len() - lines[head].trim_start().len()];
    let tail = lines[line.at..].iter().position(|text| *text == format!("{outer}}}"));
    let mut shown = String::new();
    for (at, text) in lines.iter().enumerate().take(line.at + tail.unwrap_or(0) + 1).skip(head) {
        let text = text.strip_prefix(outer).unwrap_or_default();
        let indent = &text[..text.len() - text.trim_start().len()];
        shown += &match at == line.at {
            false => format!(" {text}\n"),
            true if new == line.text => format!(">{text}   // <- this line\n"),
            true if new.is_empty() => format!("-{text}\n"),
            true => format!("-{text}\n+{indent}{new}\n"),
        };
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::{Line, Sources, function};

    #[test]
    fn the_function_is_shown_with_the_change() {
        let text = "fn f() {}\nimpl X {\n    fn g() {\n        a;\n        b;\n    }\n}\n";
        let sources: Sources = [("a.rs".into(), text.into())].into();
        let line = Line { path: "a.rs".into(), at: 3, text: "a;".into(), task: None, begins: true };
        for (new, shown) in
            [("", "-    a;\n"), ("c;", "-    a;\n+    c;\n"), ("a;", ">    a;   // <- this line\n")]
        {
            assert_eq!(
                function(&sources, &line, new),
                format!(" fn g() {{\n{shown}     b;\n }}\n")
            );
        }
    }
}
