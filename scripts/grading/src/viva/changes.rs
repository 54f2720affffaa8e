//! Changes of one line in a student's own code: known mistakes, and small mutations.

use std::path::Path;

use anyhow::Result;
use similar::{DiffTag, TextDiff};

use lab_kit::answers::{self, Task};
use lab_kit::sources::Sources;
use lab_kit::starter::{self, todo};
use lab_kit::{Kit, Lab, wrong};

/// A line that a student wrote.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Line {
    /// File, by its path below the lab's folder.
    pub(super) path: String,
    /// Number of the line, counted from 0.
    pub(super) at: usize,
    /// Line without its indent.
    pub(super) text: String,
    /// Task whose `todo!` the line replaces; `None` in the student's own functions.
    pub(super) task: Option<Task>,
    /// Whether the previous line ends a statement or begins a block.
    pub(super) begins: bool,
}

/// A different text for one line.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Change {
    pub(super) line: Line,
    /// New text; empty if the line is removed.
    pub(super) new: String,
    /// Description of the mistake; `None` if the change is not a known mistake.
    pub(super) story: Option<String>,
}

/// Operators and calls that a mutation replaces, each with its replacement.
const SWAPS: [(&str, &str); 12] = [
    (" < ", " <= "),
    (" <= ", " < "),
    (" > ", " >= "),
    (" + 1", ""),
    (" + ", " - "),
    (" - ", " + "),
    (" == ", " != "),
    (" += ", " = "),
    (" && ", " || "),
    (".min(", ".max("),
    ("Release", "Relaxed"),
    (".par_iter_mut()", ".iter_mut()"),
];

/// Returns the lines of code that differ from the lab's starter.
pub(super) fn own_lines(kit: &Kit, lab: Lab, sources: &Sources) -> Result<Vec<Line>> {
    let given = starter::given(kit, lab)?;
    let mut lines = Vec::new();
    for (path, bytes) in sources {
        let before = given.get(Path::new(path)).map_or(&[][..], Vec::as_slice);
        let [before, after] = [before, bytes].map(String::from_utf8_lossy);
        // Lines are compared without their indents, because these differ inside an added block.
        let [old, new] =
            [&before, &after].map(|text| text.lines().map(str::trim).collect::<Vec<_>>());
        let mut task = None;
        for change in TextDiff::from_slices(&old, &new).ops() {
            let replaced = &old[change.old_range()];
            // Lines that are the same in the starter, such as braces, may be in the middle of an
            // answer. They end the answer only if a function begins in them.
            if change.tag() == DiffTag::Equal && replaced.iter().any(|line| is_head(line)) {
                task = None;
            }
            task = replaced.iter().find_map(|line| Some(todo(line)?.0.task)).or(task);
            let changed = change.new_range().filter(|_| change.tag() != DiffTag::Equal);
            for at in changed.filter(|at| is_code(new[*at])) {
                let last = new[..at].iter().rfind(|line| is_code(line));
                let begins = last.is_none_or(|line| line.ends_with(['{', '}', ';']));
                lines.push(Line { path: path.clone(), at, text: new[at].to_owned(), task, begins });
            }
        }
    }
    Ok(lines)
}

/// Whether a line without its indent is neither empty nor a comment.
fn is_code(line: &str) -> bool {
    !line.is_empty() && !line.starts_with("//")
}

/// Whether a line begins a function.
pub(super) fn is_head(line: &str) -> bool {
    line.split_whitespace().take(3).any(|word| word == "fn")
}

/// Returns all changes of a student's lines: mutations, and known mistakes where a line equals the
/// solution's.
pub(super) fn changes(kit: &Kit, lab: Lab, lines: &[Line]) -> Result<Vec<Change>> {
    let files = answers::read_solution(kit, lab)?;
    let mut changes = Vec::new();
    for known in wrong::read(kit, lab)? {
        let mut regions = files.iter().flat_map(|file| file.regions());
        let Some(region) = regions.find(|region| region.id == known.region) else { continue };
        let Some((nth, old, new)) = only_change(&region.body, &known.body) else { continue };
        let own = lines.iter().filter(|line| line.task == Some(known.region.task));
        let equal: Vec<&Line> = own.filter(|line| line.text == old).collect();
        // The mistake changes only one of the lines with this text. If the student's answer has
        // more or fewer of these lines, the line to change is not known.
        let count = region.body.lines().filter(|line| line.trim() == old).count();
        let own = equal.get(nth).filter(|_| equal.len() == count);
        changes.extend(own.map(|line| Change {
            line: (*line).clone(),
            new: new.to_owned(),
            story: Some(known.story.clone()),
        }));
    }
    for line in lines.iter().filter(|line| !line.text.contains('"')) {
        let text = &line.text;
        let swaps = SWAPS.iter().filter(|(from, _)| text.contains(from));
        let swapped = swaps.map(|(from, to)| text.replacen(from, to, 1));
        let is_call = line.begins && text.ends_with(");") && !text.contains('=');
        for new in swapped.chain(is_call.then(String::new)) {
            changes.push(Change { line: line.clone(), new, story: None });
        }
    }
    Ok(changes)
}

/// Finds the only line that differs. Returns the number of earlier lines in `old` with the same
/// text, the old text of the line, and its new text; `None` if several lines differ.
fn only_change<'a>(old: &'a str, new: &'a str) -> Option<(usize, &'a str, &'a str)> {
    let [old, new] = [old, new]
        .map(|text| text.lines().map(str::trim).filter(|line| is_code(line)).collect::<Vec<_>>());
    let same = old.iter().zip(&new).take_while(|(old, new)| old == new).count();
    let (line, rest) = old[same..].split_first()?;
    let nth = old[..same].iter().filter(|other| *other == line).count();
    match &new[same..] {
        after if rest == after => Some((nth, line, "")),
        [new, after @ ..] if rest == after => Some((nth, line, new)),
        _ => None,
    }
}

impl Change {
    /// Makes the change.
    pub(super) fn apply(&self, sources: &mut Sources) {
        if let Some(bytes) = sources.get_mut(&self.line.path) {
            let text = String::from_utf8_lossy(bytes).into_owned();
            let mut lines: Vec<&str> = text.lines().collect();
            lines[self.line.at] = &self.new;
            *bytes = (lines.join("\n") + "\n").into_bytes();
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{Change, Line, changes, only_change, own_lines};
    use exam::bank::{each, rows};
    use lab_kit::Kit;
    use lab_kit::files::read_text;
    use lab_kit::sources::{Sources, of_solution};

    #[test]
    fn a_known_mistake_of_one_line_is_found() {
        let body = "a;\n\n// why\nb;\nc;\n";
        assert_eq!(only_change(body, "a;\nx;\nc;\n"), Some((0, "b;", "x;")));
        assert_eq!(only_change(body, "a;\nc;\n"), Some((0, "b;", "")));
        assert_eq!(only_change("a;\nb;\na;\n", "a;\nb;\n"), Some((1, "a;", "")));
        assert_eq!(only_change(body, "x;\nb;\ny;\n"), None);
    }

    #[test]
    fn a_change_replaces_its_line() {
        let mut sources: Sources = [("src/a.rs".into(), b"a\n  b\nc\n".to_vec())].into();
        let path = "src/a.rs".into();
        let text = "b".into();
        let line = Line { path, at: 1, text, task: None, begins: false };
        Change { line, new: "x".into(), story: None }.apply(&mut sources);
        assert_eq!(sources["src/a.rs"], b"a\nx\nc\n");
    }

    /// The test reads the changes from which sheets are made, so it builds no program.
    #[test]
    fn each_outcome_has_an_oral_question_about_a_core_task() {
        let kit = Kit::find().unwrap();
        let mut asked = BTreeSet::new();
        for lab in kit.solutions() {
            let lines = own_lines(&kit, lab, &of_solution(&kit, lab).unwrap()).unwrap();
            let facts = kit.facts(lab).unwrap();
            for change in changes(&kit, lab, &lines).unwrap() {
                let task = change.line.task.map(|task| task.to_string()).unwrap_or_default();
                asked.extend(facts.tasks.get(&task).filter(|task| !task.optional).map(|_| task));
            }
        }
        let mut outcomes = 0;
        let page = read_text(&kit.path("book/src/instructor/outcomes.md")).unwrap();
        for row in rows(&page).filter(|row| row[0].parse::<u8>().is_ok()) {
            assert!(each(row[2]).iter().any(|task| asked.contains(task)), "{row:?}");
            outcomes += 1;
        }
        assert_eq!(outcomes, 18);
    }
}
