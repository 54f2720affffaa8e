//! Turns the questions of the section *Test your understanding* into quizzes.
//!
//! The section has a numbered list. Below each question are possible answers, as a task list in
//! which the right answer is checked. Below each answer is the reply, as a quotation:
//!
//! ```markdown
//! 1. Why are bins not narrower than the cutoff?
//!
//!    - [ ] Fewer bins take less memory.
//!      > Memory does not decide what is right.
//!    - [x] Two particles in touch would be two bins apart.
//!      > So a particle would miss a neighbour.
//! ```

use std::path::Path;

use anyhow::{Context, Result, ensure};

use lab_kit::quiz::choice;

const SECTION: &str = "## Test your understanding\n";

/// Returns the page `file` of the book with a fold for each question and for each answer.
///
/// If not `with_answers`, only the questions remain. A page without the section stays as it is.
///
/// # Errors
/// A question has fewer than three answers, or not exactly one right answer, or an answer has no
/// reply.
pub(crate) fn folded(file: &Path, text: &str, with_answers: bool) -> Result<String> {
    let Some(begin) = text.find(SECTION) else { return Ok(text.to_owned()) };
    let begin = begin + SECTION.len();
    let end = text[begin..].find("\n## ").map_or(text.len(), |at| begin + at + 1);
    let page = file.file_stem().unwrap_or_default().to_string_lossy();
    let mut out = text[..begin].to_owned();
    let mut rest = text[begin..end].split_inclusive('\n').peekable();
    while let Some(line) = rest.next() {
        if !is_numbered(line) {
            out += line;
            continue;
        }
        // The indented lines below a line with a number belong to the same question.
        let mut lines = vec![line];
        while let Some(line) = rest.next_if(|line| line.starts_with("   ") || *line == "\n") {
            lines.push(line);
        }
        let question = Question::of(&lines);
        if !with_answers {
            out += &question.says;
            out.push_str("\n\n");
            continue;
        }
        question.check().with_context(|| format!("question '{}'", question.says))?;
        let number = question.says.split('.').next().unwrap_or_default();
        out += &question.folded(&format!("{page}-question-{number}"));
    }
    Ok(out + &text[end..])
}

/// Whether a line is the first line of a question, such as `2. Why?`.
fn is_numbered(line: &str) -> bool {
    line.split_once(". ").is_some_and(|(number, _)| {
        !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
    })
}

/// A question with possible answers.
struct Question {
    /// Number and text of the question.
    says: String,
    answers: Vec<Answer>,
}

#[derive(Default)]
struct Answer {
    says: String,
    reply: String,
    is_right: bool,
}

impl Question {
    /// Reads the lines of a question.
    fn of(lines: &[&str]) -> Self {
        let mut question = Self { says: String::new(), answers: Vec::new() };
        for line in lines.iter().map(|line| line.trim()) {
            let unchecked = line.strip_prefix("- [ ] ");
            if let Some(says) = unchecked.or(line.strip_prefix("- [x] ")) {
                let is_right = unchecked.is_none();
                question.answers.push(Answer { says: says.into(), is_right, ..Answer::default() });
                continue;
            }
            let reply = line.strip_prefix("> ");
            let into = match (question.answers.last_mut(), reply) {
                (None, _) => &mut question.says,
                (Some(answer), None) => &mut answer.says,
                (Some(answer), Some(_)) => &mut answer.reply,
            };
            if !into.is_empty() && !line.is_empty() {
                into.push(' ');
            }
            into.push_str(reply.unwrap_or(line));
        }
        question
    }

    fn check(&self) -> Result<()> {
        let right = self.answers.iter().filter(|answer| answer.is_right).count();
        ensure!(self.answers.len() >= 3 && right == 1, "it needs three answers, one of them right");
        for Answer { says, reply, .. } in &self.answers {
            ensure!(!reply.is_empty(), "the answer '{says}' has no reply");
        }
        Ok(())
    }

    /// Returns a fold with the answers. Only one of the folds with this `name` is open at a time.
    fn folded(&self, name: &str) -> String {
        // Without the backslash, Markdown would read the number as the beginning of a list.
        let says = self.says.replacen(". ", "\\. ", 1);
        let mut out = format!("<details class=\"quiz\"><summary>\n\n{says}\n\n</summary>\n\n");
        for Answer { says, reply, is_right } in &self.answers {
            out += &choice(name, says, *is_right, reply);
        }
        out + "</details>\n\n"
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::folded;

    const PAGE: &str = "# Lab\n\n1. No question.\n\n## Test your understanding\n\nTwo questions.\n\n\
        1. Why are\n   bins wide?\n\n   - [ ] For\n     fun.\n     > It is\n     > none.\n   - [x] They must be.\n     > Neighbours.\n   \
        - [ ] By chance.\n     > Not so.\n\nThen rest.\n\n## Go further\n\n1. More.\n";

    fn fold(text: &str, with_answers: bool) -> Result<String, String> {
        let folded = folded(Path::new("lab2.md"), text, with_answers);
        folded.map_err(|error| error.root_cause().to_string())
    }

    #[test]
    fn each_answer_has_a_fold_with_its_reply() {
        let page = fold(PAGE, true).unwrap();
        let order = [
            "1. No question.",
            "Two questions.",
            "<details class=\"quiz\"><summary>\n\n1\\. Why are bins wide?\n",
            "<details name=\"lab2-question-1\"><summary>\n\nFor fun.\n",
            "No. It is none.",
            "<details name=\"lab2-question-1\" class=\"is-right\"><summary>\n\nThey must be.\n",
            "Yes. Neighbours.",
            "No. Not so.",
            "Then rest.\n\n## Go further\n\n1. More.\n",
        ];
        let mut from = 0;
        for part in order {
            from += page[from..].find(part).unwrap_or_else(|| panic!("{part}: {page}"));
        }
        assert_eq!(page.matches("</details>").count(), 4);
        assert_eq!(fold("# A page\n", true).unwrap(), "# A page\n");
    }

    #[test]
    fn the_search_sees_the_questions_only() {
        let page = fold(PAGE, false).unwrap();
        assert!(page.contains("Two questions.\n\n1. Why are bins wide?\n\nThen rest."), "{page}");
    }

    #[test]
    fn a_question_without_a_right_answer_or_a_reply_is_an_error() {
        for (from, to, error) in [
            ("[x]", "[ ]", "it needs three answers, one of them right"),
            ("[ ] By", "[x] By", "it needs three answers, one of them right"),
            ("> Not so.", "Not so.", "the answer 'By chance. Not so.' has no reply"),
        ] {
            assert_eq!(fold(&PAGE.replace(from, to), true).unwrap_err(), error);
        }
    }
}
