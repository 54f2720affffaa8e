//! Changes of one line in a student's own code: known mistakes, and small mutations.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::Result;
use ra_ap_rustc_lexer::{FrontmatterAllowed, TokenKind, tokenize};
use similar::{DiffTag, TextDiff};

use lab_kit::answers::{self, Task};
use lab_kit::starter::{self, todo};
use lab_kit::submission::Sources;
use lab_kit::{Kit, Lab, wrong};

/// A line that a student wrote.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Line {
    /// File, by its path below the lab's folder.
    pub(super) path: String,
    /// Number of the line, from 0.
    pub(super) at: usize,
    /// Line without its indent.
    pub(super) text: String,
    /// Task whose `todo!` the line replaces; `None` in the student's own functions.
    pub(super) task: Option<Task>,
}

/// A different text for one line.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Change {
    pub(super) line: Line,
    /// New text; empty if the line is removed.
    pub(super) new: String,
    /// Description of the mistake, if it is a known one.
    pub(super) story: Option<String>,
}

/// Operators and calls that a mutation replaces.
const SWAPS: [(&str, &str); 15] = [
    (" < ", " <= "),
    (" <= ", " < "),
    (" > ", " >= "),
    (" >= ", " > "),
    (" + 1", ""),
    (" - 1", ""),
    (" + ", " - "),
    (" - ", " + "),
    (" += ", " -= "),
    ("..=", ".."),
    (" && ", " || "),
    (".min(", ".max("),
    (".max(", ".min("),
    ("Release", "Relaxed"),
    (".par_iter_mut()", ".iter_mut()"),
];

/// Words of the language, which no student can rename.
const WORDS: [&str; 12] =
    ["as", "else", "for", "if", "in", "let", "match", "move", "mut", "return", "self", "while"];

/// Returns the lines of code that differ from the lab's starter.
pub(super) fn own_lines(kit: &Kit, lab: Lab, sources: &Sources) -> Result<Vec<Line>> {
    let given = starter::given(kit, lab)?;
    let mut lines = Vec::new();
    for (path, bytes) in sources {
        let before = given.get(Path::new(path)).map_or(&[][..], Vec::as_slice);
        let [before, after] = [before, bytes].map(String::from_utf8_lossy);
        // Indents differ where a student added a block.
        let old: Vec<&str> = before.lines().map(str::trim).collect();
        let new: Vec<&str> = after.lines().map(str::trim).collect();
        for change in TextDiff::from_slices(&old, &new).ops() {
            if change.tag() == DiffTag::Equal {
                continue;
            }
            let task = old[change.old_range()].iter().find_map(|line| Some(todo(line)?.0.task));
            let is_code = |at: &usize| !new[*at].is_empty() && !new[*at].starts_with("//");
            for at in change.new_range().filter(is_code) {
                let text = new[at].to_owned();
                lines.push(Line { path: path.clone(), at, text, task });
            }
        }
    }
    Ok(lines)
}

/// Returns all changes of a student's lines, known mistakes first.
pub(super) fn changes(kit: &Kit, lab: Lab, lines: &[Line]) -> Result<Vec<Change>> {
    let files = answers::read_solution(kit, lab)?;
    let mut changes = Vec::new();
    for known in wrong::read(kit, lab)? {
        let mut regions = files.iter().flat_map(|file| file.regions());
        let Some(region) = regions.find(|region| region.id == known.region) else { continue };
        let Some((old, new)) = only_change(&region.body, &known.body) else { continue };
        let places = lines.iter().filter(|line| line.task == Some(known.region.task));
        let renamed = places.filter_map(|line| Some((line, renamed(old, new, &line.text)?)));
        if let [(line, new)] = &renamed.collect::<Vec<_>>()[..] {
            let story = Some(known.story.clone());
            changes.push(Change { line: (*line).clone(), new: new.clone(), story });
        }
    }
    for line in lines.iter().filter(|line| !line.text.contains('"')) {
        let swapped = SWAPS.iter().filter(|(from, _)| line.text.contains(from));
        let swapped = swapped.map(|(from, to)| line.text.replacen(from, to, 1));
        let removed = is_whole(&line.text).then(String::new);
        for new in swapped.chain(removed) {
            changes.push(Change { line: line.clone(), new, story: None });
        }
    }
    Ok(changes)
}

/// Returns the only line that differs, and its new text; `None` if several differ.
fn only_change<'a>(old: &'a str, new: &'a str) -> Option<(&'a str, &'a str)> {
    let lines = |text: &'a str| -> Vec<&'a str> {
        let code = text.lines().map(str::trim);
        code.filter(|line| !line.is_empty() && !line.starts_with("//")).collect()
    };
    let (old, new) = (lines(old), lines(new));
    let same = old.iter().zip(&new).take_while(|(old, new)| old == new).count();
    match (&old[same..], &new[same..]) {
        ([old, rest @ ..], after) if rest == after => Some((old, "")),
        ([old, rest @ ..], [new, after @ ..]) if rest == after => Some((old, new)),
        _ => None,
    }
}

/// Whether a line is a statement that can be removed.
fn is_whole(line: &str) -> bool {
    let count = |open, close| line.matches(open).count() == line.matches(close).count();
    let starts = ["let ", "return", "use ", ".", "}", ")"];
    line.ends_with(';')
        && !starts.iter().any(|start| line.starts_with(start))
        && count('(', ')')
        && count('{', '}')
}

/// Returns `new` with a student's names, if `own` is the line `old` with different names.
fn renamed(old: &str, new: &str, own: &str) -> Option<String> {
    let (old, own) = (tokens(old), tokens(own));
    let mut names = BTreeMap::new();
    let same = old.len() == own.len()
        && old.iter().zip(&own).all(|(old, own)| match (old, own) {
            ((old, true), (own, true)) => names.entry(*old).or_insert(*own) == own,
            (old, own) => old == own,
        });
    let text = |(text, is_name): (&str, bool)| {
        let name = names.get(text).filter(|_| is_name);
        name.map_or(text, |name| name).to_owned()
    };
    same.then(|| tokens(new).into_iter().map(text).collect())
}

/// Returns the tokens of a line, and whether each is the name of a variable.
fn tokens(line: &str) -> Vec<(&str, bool)> {
    let (mut all, mut at): (Vec<(&str, bool)>, _) = (Vec::new(), 0);
    for token in tokenize(line, FrontmatterAllowed::No) {
        let text = &line[at..at + token.len as usize];
        at += text.len();
        let before = all.last().map_or("", |(text, _)| *text);
        let is_name = token.kind == TokenKind::Ident
            && text.starts_with(|c: char| c.is_lowercase() || c == '_')
            && !WORDS.contains(&text)
            && ![".", ":"].contains(&before)
            && !line[at..].starts_with(['(', ':', '!']);
        all.push((text, is_name));
    }
    all
}

impl Change {
    /// Returns the sources with the change.
    pub(super) fn applied(&self, sources: &Sources) -> Sources {
        let mut sources = sources.clone();
        let Line { path, at, .. } = &self.line;
        if let Some(bytes) = sources.get_mut(path) {
            let text = String::from_utf8_lossy(bytes).into_owned();
            let mut lines: Vec<&str> = text.lines().collect();
            lines[*at] = &self.new;
            *bytes = (lines.join("\n") + "\n").into_bytes();
        }
        sources
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{Change, Line, changes, only_change, own_lines, renamed};
    use crate::record::number;
    use lab_kit::Kit;
    use lab_kit::files::read_text;
    use lab_kit::submission::{Sources, of_solution};

    #[test]
    fn a_known_mistake_fits_a_line_with_different_names() {
        let new = "for (particle, a) in own.iter_mut().zip(&self.all) {";
        let old = "for (particle, a) in own.iter_mut().zip(&mut all) {";
        let own = "for (disc, pull) in bin.iter_mut().zip(&mut rest) {";
        let found = renamed(old, new, own).unwrap();
        assert_eq!(found, "for (disc, pull) in bin.iter_mut().zip(&self.all) {");
        assert_eq!(renamed("a.push(b);", "", "a.pop(b);"), None);
        assert_eq!(renamed("a + a", "", "x + y"), None);
        let body = "a;\n\n// why\nb;\nc;\n";
        assert_eq!(only_change(body, "a;\nx;\nc;\n"), Some(("b;", "x;")));
        assert_eq!(only_change(body, "a;\nc;\n"), Some(("b;", "")));
        assert_eq!(only_change(body, "x;\nb;\ny;\n"), None);
    }

    #[test]
    fn a_change_replaces_its_line() {
        let sources: Sources = [("src/a.rs".into(), b"a\n  b\nc\n".to_vec())].into();
        let line = Line { path: "src/a.rs".into(), at: 1, text: "b".into(), task: None };
        let change = Change { line, new: "x".into(), story: None };
        assert_eq!(change.applied(&sources)["src/a.rs"], b"a\nx\nc\n");
    }

    /// The sources of questions are those of a whole sheet, so no program is built here.
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
        let rows = page.lines().map(|line| line.split(" | ").map(str::trim).collect::<Vec<_>>());
        for row in rows.filter(|row| row[0].trim_matches(['|', ' ']).parse::<u8>().is_ok()) {
            // Tasks such as `3.1, 3.3–3.12`.
            let runs: Vec<_> = row[2].split(", ").map(|run| run.split_once('–').unwrap_or((run, run))).collect();
            let is_of = |task: &String| {
                runs.iter().any(|(first, last)| (number(first)..=number(last)).contains(&number(task)))
            };
            assert!(asked.iter().any(is_of), "{row:?}");
            outcomes += 1;
        }
        assert_eq!(outcomes, 18);
    }
}
