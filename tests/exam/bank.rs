//! The exam questions, as they stand in the book.
//!
//! ```markdown
//! ## 3.1 A sum (3 points)
//!
//! <details class="answer"><summary>Answer</summary>
//!
//! The speed-up is **1.90**.
//!
//! *Outcome 4. Taught in* [Rebinning by one](../../lab3.md#rebinning-by-one).
//!
//! </details>
//! ```

use anyhow::{Context, Result};

use lab_kit::files::read_text;
use lab_kit::{Kit, Lab};

pub(crate) struct Question {
    /// Lab and number, such as `3.1`.
    pub(crate) id: String,
    pub(crate) points: u32,
    /// Learning outcome that the question tests.
    pub(crate) outcome: String,
    /// Section of the book that teaches the answer: a chapter's file, and the section's anchor.
    pub(crate) page: String,
    pub(crate) anchor: String,
    /// Computed numbers of the answer: the numbers in bold.
    pub(crate) numbers: Vec<String>,
}

/// Returns the questions about a lab.
pub(crate) fn read(kit: &Kit, lab: Lab) -> Result<Vec<Question>> {
    let text = read_text(&kit.path(format!("book/src/instructor/exam/lab{lab}.md")))?;
    let question_of = |part: &str| question(part).with_context(|| part.to_owned());
    text.split("\n## ").skip(1).map(question_of).collect()
}

fn question(text: &str) -> Option<Question> {
    let (heading, rest) = text.split_once('\n')?;
    let (title, points) = heading.strip_suffix(" points)")?.rsplit_once(" (")?;
    let (_, answer) = rest.split_once("<details class=\"answer\"><summary>Answer</summary>\n")?;
    let (answer, taught) = answer.split_once("\n*Outcome ")?;
    let (outcome, link) = taught.split_once(". Taught in* [")?;
    let (page, anchor) = link.split_once("](../../")?.1.split_once(')')?.0.split_once('#')?;
    Some(Question {
        id: title.split_once(' ')?.0.into(),
        points: points.parse().ok()?,
        outcome: outcome.into(),
        page: page.into(),
        anchor: anchor.into(),
        numbers: answer.split("**").skip(1).step_by(2).flat_map(numbers).collect(),
    })
}

/// Returns the numbers of a text in bold, such as `(3, 4), −1.5` or `120,000`.
fn numbers(bold: &str) -> Vec<String> {
    let words = bold.split(|c: char| c.is_whitespace() || "()".contains(c));
    let plain = words.map(|word| word.trim_end_matches(',').replace(',', "").replace('−', "-"));
    plain.filter(|word| !word.is_empty()).collect()
}

/// Returns the rows of a page's tables, without their headings.
pub(crate) fn rows(page: &str) -> impl Iterator<Item = Vec<&str>> {
    let rows = page.lines().filter_map(|line| line.strip_prefix("| ")?.strip_suffix(" |"));
    rows.map(|row| row.split(" | ").map(str::trim).collect())
}
