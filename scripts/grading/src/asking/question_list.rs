//! Table of a lab's questions, as the grader's own program prints it.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, ensure};

/// One question of a lab.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Question {
    /// Task that the question is about, such as `3.2`.
    pub(crate) task: String,
    /// Name of the question and of its test, such as `task_3_2::forces`.
    pub(crate) test: String,
    /// Other tasks that the question needs.
    pub(crate) after: Vec<String>,
}

/// Reads the questions, in order.
pub(crate) fn read(judge: &Path) -> Result<Vec<Question>> {
    let output = Command::new(judge).output().context("the grader's own program does not start")?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let questions: Vec<Question> = text.lines().filter_map(question).collect();
    ensure!(!questions.is_empty(), "the lab has no table of questions");
    Ok(questions)
}

/// Parses a line `question|task_3_2|forces|3.1, 3.3|what a student reads`.
fn question(line: &str) -> Option<Question> {
    let mut fields = line.strip_prefix("question|")?.splitn(4, '|');
    let module = fields.next()?;
    let name = fields.next()?;
    let after = fields.next()?;
    let task = module.strip_prefix("task_")?.replacen('_', ".", 1);
    let after = after.split(',').map(str::trim).filter(|task| !task.is_empty());
    let after = after.map(String::from).collect();
    Some(Question { task, test: format!("{module}::{name}"), after })
}

#[cfg(test)]
mod tests {
    use super::{Question, question};

    #[test]
    fn a_row_is_read() {
        for (line, id, name, needed) in [
            (
                "task_3_12|forces|3.1, 3.3|What | is asked.",
                "3.12",
                "task_3_12::forces",
                &["3.1", "3.3"][..],
            ),
            ("task_1_1|a||x", "1.1", "task_1_1::a", &[]),
        ] {
            let Question { task, test, after } = question(&format!("question|{line}")).unwrap();
            assert_eq!([task, test], [id, name]);
            assert_eq!(after, needed);
        }
        assert_eq!(question("running 1 test"), None);
    }
}
