//! Parses the marks of one file.

use std::path::Path;

use anyhow::{Error, Result, anyhow};

use super::RegionId;

const ANSWER_ONLY: &str = "answer only";

/// A part of a file. Its text consists of whole lines.
#[derive(Debug)]
pub enum Part {
    /// Given code.
    Given(String),
    /// A task's answer.
    Answer(Region),
    /// Items that only an answer needs.
    AnswerOnly(String),
}

impl Part {
    /// Returns the text of the part, without marks.
    pub fn text(&self) -> &str {
        match self {
            Self::Given(text) | Self::AnswerOnly(text) => text,
            Self::Answer(region) => &region.body,
        }
    }
}

/// A task's answer.
#[derive(Debug)]
pub struct Region {
    /// The task and its letter.
    pub id: RegionId,
    /// Title after the colon of the opening mark.
    pub title: String,
    /// Line of the opening mark, from 1.
    pub line: usize,
    /// Lines between the marks.
    pub body: String,
    /// Whether the answer ends its block, so that its last expression is the block's value.
    pub tail: bool,
}

/// A mark that one line contains.
enum Mark {
    Task(RegionId, String),
    AnswerOnly,
    End(String),
}

impl Mark {
    /// Returns the name that the matching `end` mark must have.
    fn name(&self) -> String {
        match self {
            Self::Task(id, _) => id.to_string(),
            Self::AnswerOnly => ANSWER_ONLY.into(),
            Self::End(name) => name.clone(),
        }
    }
}

/// Makes the error for an invalid mark: the file, the line from 1, and the fault.
pub(super) fn wrong_mark(file: &Path, line: usize, what: &str) -> Error {
    anyhow!("{}:{line}: {what}", file.display())
}

/// Splits a file into parts. Joining the parts and marks gives the file again.
///
/// `file` is the name of the file in errors.
///
/// # Errors
/// If a mark is invalid.
pub fn parse(file: &Path, text: &str) -> Result<Vec<Part>> {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let mut marks = Vec::new();
    for (index, line) in lines.iter().enumerate() {
        let found = mark(line).map_err(|what| wrong_mark(file, index + 1, &what))?;
        marks.extend(found.map(|mark| (index, mark)));
    }
    let mut parts = Vec::new();
    let mut begin = 0;
    let mut marks = marks.into_iter();
    while let Some((open, mark)) = marks.next() {
        let end = closing(&lines, (open, &mark), marks.next())
            .map_err(|(index, what)| wrong_mark(file, index + 1, &what))?;
        parts.push(Part::Given(lines[begin..open].concat()));
        let body = lines[open + 1..end].concat();
        begin = end + 1;
        parts.push(match mark {
            Mark::Task(id, title) => {
                let tail = ends_block(&lines[begin..]);
                Part::Answer(Region { id, title, line: open + 1, body, tail })
            }
            _ => Part::AnswerOnly(body),
        });
    }
    parts.push(Part::Given(lines[begin..].concat()));
    Ok(parts)
}

/// Finds the line, from 0, of the mark that closes the mark in line `open`.
///
/// The error is the faulty line and its fault.
fn closing(
    lines: &[&str],
    (open, mark): (usize, &Mark),
    next: Option<(usize, Mark)>,
) -> Result<usize, (usize, String)> {
    let name = mark.name();
    if matches!(mark, Mark::End(_)) {
        return Err((open, format!("'// end {name}' has no opening mark")));
    }
    if matches!(mark, Mark::Task(..)) && indent(lines[open]) == 0 {
        return Err((open, "a task's answer is the body of a function: this is outside".into()));
    }
    let Some((at, next)) = next else { return Err((open, format!("there is no '// end {name}'"))) };
    let Mark::End(end) = next else {
        return Err((at, format!("a mark inside {name}, which began on line {}", open + 1)));
    };
    if end != name {
        return Err((at, format!("'// end {end}' where '// end {name}' belongs")));
    }
    if indent(lines[at]) != indent(lines[open]) {
        return Err((at, format!("'// end {name}' is indented unlike its beginning")));
    }
    if !lines[open + 1..at].iter().any(|line| is_code(line)) {
        return Err((at, format!("there is nothing between the marks of {name}")));
    }
    Ok(at)
}

/// Parses the mark in a line; `None` if the line is not a mark.
///
/// A comment that only resembles a mark is an error, because it would reveal an answer in the
/// starter.
fn mark(line: &str) -> Result<Option<Mark>, String> {
    let Some(comment) = line.trim().strip_prefix("//") else { return Ok(None) };
    let comment = comment.trim();
    if comment == ANSWER_ONLY {
        return Ok(Some(Mark::AnswerOnly));
    }
    if let Some(rest) = comment.strip_prefix("task").filter(|rest| is_digit_first(rest)) {
        let parts = rest.split_once(':').map(|(id, title)| (id.trim().parse(), title.trim()));
        let Some((Ok(id), title)) = parts else {
            return Err(format!("'// {comment}' is no mark: write '// task 3.2: title'"));
        };
        if title.is_empty() || title.contains(['"', '\\', '{', '}']) {
            return Err(format!("the title of task {id} must be plain text"));
        }
        return Ok(Some(Mark::Task(id, title.into())));
    }
    match comment.strip_prefix("end").map(str::trim) {
        Some(ANSWER_ONLY) => Ok(Some(Mark::End(ANSWER_ONLY.into()))),
        Some(rest) if is_digit_first(rest) => match rest.parse::<RegionId>() {
            Ok(id) => Ok(Some(Mark::End(id.to_string()))),
            Err(_) => Err(format!("'// {comment}' is no mark: write '// end 3.2'")),
        },
        _ => Ok(None),
    }
}

fn is_digit_first(text: &str) -> bool {
    text.trim_start().starts_with(|c: char| c.is_ascii_digit())
}

/// Returns the number of spaces before a line's text.
pub(crate) fn indent(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

fn is_code(line: &str) -> bool {
    let line = line.trim();
    !line.is_empty() && !line.starts_with("//")
}

/// Whether the next code in `lines` closes a block.
fn ends_block(lines: &[&str]) -> bool {
    lines.iter().find(|line| is_code(line)).is_some_and(|line| line.trim().starts_with('}'))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{Part, parse};

    #[test]
    fn a_file_comes_apart_at_its_marks() {
        let text = "\
fn f() -> u8 {
    // task 1.2: the answer
    41 + 1
    // end 1.2
}
// answer only
fn helper() {}
// end answer only
fn g() {
    // task 1.3b: more
    work();
    // end 1.3b

    // given
    done();
}
";
        let parts = parse(Path::new("x.rs"), text).unwrap();
        let [
            Part::Given(a),
            Part::Answer(first),
            Part::Given(b),
            Part::AnswerOnly(c),
            Part::Given(d),
            Part::Answer(second),
            Part::Given(e),
        ] = &parts[..]
        else {
            panic!("{parts:?}");
        };
        assert_eq!([a, b, c], ["fn f() -> u8 {\n", "}\n", "fn helper() {}\n"]);
        assert_eq!([d, e], ["fn g() {\n", "\n    // given\n    done();\n}\n"]);
        assert_eq!((first.id.to_string(), first.line, first.tail), ("1.2".into(), 2, true));
        assert_eq!((&*first.title, &*first.body), ("the answer", "    41 + 1\n"));
        assert_eq!((second.id.to_string(), second.line, second.tail), ("1.3b".into(), 10, false));
    }

    #[test]
    fn malformed_marks_are_found_at_their_line() {
        for (text, message) in [
            ("| // task 1.2: a| x|", "2: there is no '// end 1.2'"),
            (" // task 1.2 a|", "1: '// task 1.2 a' is no mark: write '// task 3.2: title'"),
            (" // task 1.2:|", "1: the title of task 1.2 must be plain text"),
            (" // task 1.2: a| x| // end 1.3|", "3: '// end 1.3' where '// end 1.2' belongs"),
            (" // task 1.2: a| x|// end 1.2|", "3: '// end 1.2' is indented unlike its beginning"),
            (" // task 1.2: a| // x| // end 1.2|", "3: there is nothing between the marks of 1.2"),
            (" // task 1.2: a| x| // task 1.3: b|", "3: a mark inside 1.2, which began on line 1"),
            (" // end 1.2|", "1: '// end 1.2' has no opening mark"),
            (" // end 1.2.3|", "1: '// end 1.2.3' is no mark: write '// end 3.2'"),
            ("// end answer only|", "1: '// end answer only' has no opening mark"),
            ("// task 1.2: a|", "1: a task's answer is the body of a function: this is outside"),
        ] {
            let error = parse(Path::new("src/x.rs"), &text.replace('|', "\n")).unwrap_err();
            assert_eq!(error.to_string(), format!("src/x.rs:{message}"));
        }
    }

    #[test]
    fn other_comments_are_left_alone() {
        let text =
            "// tasks: see the table\n// the end of it\n//! Task 1.2: docs\n// end of file\n";
        let parts = parse(Path::new("x.rs"), text).unwrap();
        assert!(matches!(&parts[..], [Part::Given(all)] if all == text), "{parts:?}");
    }
}
