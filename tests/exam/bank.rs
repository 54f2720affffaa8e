//! The exam questions of the book.
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

use crate::numbers::draw::Shown;
use lab_kit::files::read_text;
use lab_kit::{Kit, Lab};

/// A question with its answer.
pub struct Question {
    /// Lab and number, such as `3.1`.
    pub id: String,
    /// Kind and subject, such as `A sum: Amdahl's law`.
    pub title: String,
    /// Points for the full answer.
    pub points: u32,
    /// Learning outcome that the question tests.
    pub outcome: String,
    /// File of the chapter that teaches the answer.
    pub page: String,
    /// Anchor of the section that teaches the answer.
    pub anchor: String,
    /// Question, as Markdown.
    pub text: String,
    /// Answer, as Markdown.
    pub answer: String,
    /// Numbers in bold in the answer. They are computed.
    pub numbers: Vec<String>,
}

/// Returns the questions about a lab.
///
/// # Errors
/// If the page cannot be read, or if a part of a question is missing.
pub fn read(kit: &Kit, lab: Lab) -> Result<Vec<Question>> {
    let text = read_text(&kit.path(format!("book/src/instructor/exam/lab{lab}.md")))?;
    let question_of = |part: &str| question(part).with_context(|| part.to_owned());
    text.split("\n## ").skip(1).map(question_of).collect()
}

fn question(text: &str) -> Option<Question> {
    let (heading, rest) = text.split_once('\n')?;
    let (title, points) = heading.strip_suffix(" points)")?.rsplit_once(" (")?;
    let (text, answer) =
        rest.split_once("<details class=\"answer\"><summary>Answer</summary>\n")?;
    let (answer, taught) = answer.split_once("\n*Outcome ")?;
    let (id, title) = title.split_once(' ')?;
    let (outcome, link) = taught.split_once(". Taught in* [")?;
    let (page, anchor) = link.split_once("](../../")?.1.split_once(')')?.0.split_once('#')?;
    Some(Question {
        id: id.into(),
        title: title.into(),
        points: points.parse().ok()?,
        outcome: outcome.into(),
        page: page.into(),
        anchor: anchor.into(),
        text: text.trim().into(),
        answer: answer.trim().into(),
        numbers: answer.split("**").skip(1).step_by(2).flat_map(numbers).collect(),
    })
}

/// Returns the numbers in a bold text, such as `(3, 4), −1.5` or `120,000`.
pub fn numbers(bold: &str) -> Vec<String> {
    let words = bold.split(|c: char| c.is_whitespace() || "()".contains(c));
    let plain = words.map(|word| plain(word.trim_end_matches(',')));
    plain.filter(|word| !word.is_empty()).collect()
}

/// Converts a number of the book to the form that Rust parses.
fn plain(number: &str) -> String {
    number.replace(',', "").replace('−', "-")
}

/// Returns the named numbers of a question: `5<!--share--> %` is the number 5 called `3.1 share`.
pub fn named(id: &str, text: &str) -> Shown {
    let parts: Vec<&str> = text.split("<!--").collect();
    let number = |pair: &[&str]| {
        let (name, _) = pair[1].split_once("-->")?;
        let start = pair[0].rfind(|c: char| !is_digit(c)).map_or(0, |at| at + 1);
        Some((format!("{id} {name}"), plain(pair[0].get(start..)?).parse().ok()?))
    };
    parts.windows(2).filter_map(number).collect()
}

/// Whether a character is part of a number.
pub fn is_digit(c: char) -> bool {
    c.is_ascii_digit() || ",.".contains(c)
}

/// Returns the rows of a page's tables, without their headings.
pub fn rows(page: &str) -> impl Iterator<Item = Vec<&str>> {
    let rows = page.lines().filter_map(|line| line.strip_prefix("| ")?.strip_suffix(" |"));
    rows.map(|row| row.split(" | ").map(str::trim).collect())
}

/// Expands a list of tasks: `1.2–1.4, 2.1` is tasks 1.2, 1.3, 1.4 and 2.1.
///
/// # Panics
/// If a word is neither a task nor a range of tasks.
pub fn each(list: &str) -> Vec<String> {
    let words = list.split(", ").filter(|word| word.contains('.'));
    let run = |word: &str| {
        let (first, last) = word.split_once('–').unwrap_or((word, word));
        let ((lab, first), (_, last)) = (first.split_once('.')?, last.split_once('.')?);
        let (first, last): (u32, u32) = (first.parse().ok()?, last.parse().ok()?);
        Some((first..=last).map(|task| format!("{lab}.{task}")).collect::<Vec<_>>())
    };
    words
        .flat_map(|word| run(word).unwrap_or_else(|| panic!("{word} is no run of tasks")))
        .collect()
}
