//! Examination papers: questions from the bank, with different numbers in each paper.
//!
//! All papers have questions of the same kinds, and the same number of points.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Context, Result};
use oracle::Random;

use crate::bank::{self, Question, is_digit};
use crate::numbers;
use crate::numbers::draw::{Draw, Inputs, Shown};
use lab_kit::table::with_commas;
use lab_kit::{Kit, Lab};

/// Kinds of the questions in a paper. A question's title begins with its kind.
pub const KINDS: [&str; 7] = ["A sum", "A sum", "Trace", "Trace", "Find", "Predict", "Design"];

/// Points of a paper. A student has about two minutes for each point.
pub const POINTS: u32 = 31;

/// Number of attempts to draw questions with the right number of points.
const ATTEMPTS: usize = 100_000;

/// A paper and its key.
pub struct Paper {
    /// Numbers of the questions in the bank, such as `3.1`.
    pub ids: Vec<String>,
    /// Questions, as Markdown.
    pub questions: String,
    /// Answers, as Markdown.
    pub key: String,
}

/// Draws a paper about these labs. The same seed gives the same paper.
///
/// # Errors
/// If the bank cannot be read, or if the labs have too few questions.
pub fn draw(kit: &Kit, labs: &[Lab], seed: u64) -> Result<Paper> {
    let mut bank = Vec::new();
    for lab in labs {
        bank.extend(bank::read(kit, *lab)?);
    }
    let mut random = Random::new(seed);
    let chosen = (0..ATTEMPTS).find_map(|_| chosen(&bank, labs.len(), &mut random));
    let chosen = chosen.context("these labs have too few questions for a paper")?;
    let mut inputs = Inputs::of(Draw::Seeded(random));
    let answers = numbers::all(&mut inputs);
    Ok(printed(&chosen, seed, &inputs.shown, &answers))
}

/// Draws a question of each kind. `None` if the questions do not make a paper of [`POINTS`] points.
///
/// The questions are about as many different labs as possible.
fn chosen<'a>(bank: &'a [Question], labs: usize, random: &mut Random) -> Option<Vec<&'a Question>> {
    let mut chosen: Vec<&Question> = Vec::new();
    for kind in KINDS {
        let of_kind = bank.iter().filter(|question| {
            // A sum must contain randomly drawn numbers, so that it differs from paper to paper.
            question.title.starts_with(kind) && (kind != "A sum" || question.text.contains("<!--"))
        });
        let of_kind: Vec<&Question> = of_kind.collect();
        chosen.push(of_kind.get(random.below(of_kind.len().max(1))).copied()?);
    }
    let ids: BTreeSet<&str> = chosen.iter().map(|question| &*question.id).collect();
    let topics: BTreeSet<&str> = ids.iter().filter_map(|id| Some(id.split_once('.')?.0)).collect();
    let points: u32 = chosen.iter().map(|question| question.points).sum();
    let fits = ids.len() == KINDS.len() && topics.len() >= labs.min(KINDS.len());
    (fits && points == POINTS).then_some(chosen)
}

/// Writes a paper and its key.
fn printed(
    chosen: &[&Question],
    seed: u64,
    shown: &Shown,
    answers: &BTreeMap<&str, Vec<f64>>,
) -> Paper {
    let mut questions = format!("# Examination\n\nPaper {seed}: {POINTS} points, an hour.\n\n");
    let mut key = format!("# Key to paper {seed}\n\n");
    let mut ids = Vec::new();
    for (number, question) in (1..).zip(chosen) {
        let Question { id, title, points, outcome, .. } = question;
        let heading = format!("## {number}. {title} ({points} points)\n\n");
        let values = answers.get(&**id).map_or(&[][..], Vec::as_slice);
        questions +=
            &format!("{heading}{}\n\n", with_named(id, &without_hidden(&question.text), shown));
        let answer = with_named(id, &with_computed(&question.answer, values), shown);
        key += &format!("{heading}{answer}\n\nQuestion {id} of the bank, outcome {outcome}.\n\n");
        ids.push(id.clone());
    }
    Paper { ids, questions, key }
}

/// Removes the lines of code that only the compiler needs.
fn without_hidden(text: &str) -> String {
    let shown = text.lines().filter(|line| !line.starts_with("# "));
    shown.collect::<Vec<_>>().join("\n")
}

/// Replaces the named numbers of a text by the numbers in `shown`.
fn with_named(id: &str, text: &str, shown: &Shown) -> String {
    let mut out = String::new();
    let mut parts = text.split("<!--");
    let mut before = parts.next().unwrap_or_default();
    for part in parts {
        let (name, after) = part.split_once("-->").unwrap_or_default();
        let value = shown.get(&format!("{id} {name}")).copied().unwrap_or_default();
        out += before.trim_end_matches(is_digit);
        // Rounding to ten decimals removes the rounding error of binary numbers.
        let number = format!("{value:.10}");
        let number = number.trim_end_matches('0').trim_end_matches('.');
        out += &format!("{}<!--{name}-->", as_in_the_book(number));
        before = after;
    }
    out + before
}

/// Replaces the numbers in bold by `values`, with as many decimals as before.
fn with_computed(answer: &str, values: &[f64]) -> String {
    let mut values = values.iter();
    let mut out = String::new();
    for (index, part) in answer.split("**").enumerate() {
        if index % 2 == 0 {
            out += part;
            continue;
        }
        let words = part.split_inclusive(|c: char| c.is_whitespace() || "()".contains(c));
        let replaced = words.map(|word| {
            let core = word.trim_end_matches(|c: char| !c.is_ascii_digit());
            let Some(value) =
                Some(&core).filter(|core| !core.is_empty()).and_then(|_| values.next())
            else {
                return word.to_owned();
            };
            let decimals = core.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            as_in_the_book(&format!("{value:.decimals$}")) + &word[core.len()..]
        });
        out += &format!("**{}**", replaced.collect::<String>());
    }
    out
}

/// Writes a number as the book does: `12,500` and `−1.5`.
fn as_in_the_book(number: &str) -> String {
    with_commas(number).replace('-', "−")
}
