//! A solution with all its wrong answers in it at once.
//!
//! To compile a lab once per wrong answer would take an hour. So each answer that somebody got
//! wrong becomes a chain: `if chosen() == 1 { wrong } else if … else { the answer }`, and the
//! environment chooses when the tests run.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};

use super::choice::{chooser, choosing_sources};
use lab_kit::Lab;
use lab_kit::answers::{MarkedFile, Part, Region};
use lab_kit::wrong::Wrong;

/// A file of the mutated solution.
pub(crate) struct Mutant {
    /// Relative to the solution's folder.
    pub(crate) path: PathBuf,
    /// Its text.
    pub(crate) text: String,
    /// Where in it the wrong answers are.
    pub(crate) places: Vec<Place>,
}

/// The lines of a wrong answer in a mutated file.
pub(crate) struct Place {
    /// Its index among the lab's wrong solutions.
    pub(crate) wrong: usize,
    first: usize,
    last: usize,
}

impl Place {
    /// Whether the line, from 1, is one of it.
    pub(crate) fn holds(&self, line: usize) -> bool {
        (self.first..=self.last).contains(&line)
    }
}

/// Builds the wrong answers into the files of a solution. Those in `without` stay out.
pub(crate) fn mutate(
    lab: Lab,
    files: &[MarkedFile],
    wrongs: &[Wrong],
    without: &[usize],
) -> Result<Vec<Mutant>> {
    for wrong in wrongs {
        let mut regions = files.iter().flat_map(|file| file.marked.regions());
        if !regions.any(|region| region.id == wrong.region) {
            bail!(
                "tests/wrong/lab{lab}/{}.rs: lab {lab} has no region {}",
                wrong.name,
                wrong.region
            );
        }
    }
    let mutants = files.iter().map(|file| {
        let mut mutant =
            Mutant { path: file.path.clone(), text: String::new(), places: Vec::new() };
        for part in &file.marked.parts {
            match part {
                Part::Given(text) | Part::AnswerOnly(text) if file.is_shader() => {
                    mutant.text.push_str(text);
                }
                Part::Given(text) | Part::AnswerOnly(text) => {
                    mutant.text.push_str(&choosing_sources(text));
                }
                Part::Answer(region) if file.is_shader() => {
                    alternatives(&mut mutant.text, region, wrongs);
                }
                Part::Answer(region) => chain(&mut mutant, region, wrongs, without),
            }
        }
        if mutant.path == Path::new("src/lib.rs") {
            mutant.text.push_str(&chooser(lab));
        }
        mutant
    });
    Ok(mutants.collect())
}

fn chain(mutant: &mut Mutant, region: &Region, wrongs: &[Wrong], without: &[usize]) {
    let mut any = false;
    for (index, wrong) in wrongs.iter().enumerate() {
        if wrong.region != region.id || without.contains(&index) {
            continue;
        }
        let number = index + 1;
        let before = if any { "} else " } else { "" };
        any = true;
        mutant.text.push_str(&format!("{before}if crate::chosen_wrong::number() == {number} {{\n"));
        let first = mutant.text.lines().count() + 1;
        mutant.text.push_str(&wrong.body);
        let last = mutant.text.lines().count();
        mutant.places.push(Place { wrong: index, first, last });
    }
    if any {
        mutant.text.push_str("} else {\n");
        mutant.text.push_str(&region.body);
        mutant.text.push_str("}\n");
    } else {
        mutant.text.push_str(&region.body);
    }
}

/// A shader is compiled when the lab runs, so its wrong answers are told apart as text: below a line
/// `//= 3` stands the answer that wrong solution 3 gives, below `//= 0` the right one, and `//= end`
/// ends them.
fn alternatives(text: &mut String, region: &Region, wrongs: &[Wrong]) {
    let mine = wrongs.iter().enumerate().filter(|(_, wrong)| wrong.region == region.id);
    let mut all = vec![(0, region.body.as_str())];
    all.extend(mine.map(|(index, wrong)| (index + 1, wrong.body.as_str())));
    for (number, body) in all {
        text.push_str(&format!("//= {number}\n{body}"));
    }
    text.push_str("//= end\n");
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::mutate;
    use lab_kit::answers::{MarkedFile, parse};
    use lab_kit::wrong::Wrong;

    const SOURCE: &str = "\
fn f() -> u8 {
    // task 1.2: the answer
    42
    // end 1.2
}
fn g() {
    // task 1.3: more
    work();
    // end 1.3
}
";

    fn wrong(name: &str, region: &str, body: &str) -> Wrong {
        let region = region.parse().unwrap();
        Wrong {
            name: name.into(),
            region,
            fails: vec![],
            loses: vec![],
            story: "x".into(),
            body: body.into(),
        }
    }

    fn files() -> Vec<MarkedFile> {
        let marked = parse(Path::new("src/a.rs"), SOURCE).unwrap();
        vec![MarkedFile { path: "src/a.rs".into(), marked }]
    }

    #[test]
    fn wrong_answers_become_a_chain() {
        let wrongs =
            [wrong("a", "1.2", "1\n"), wrong("b", "1.2", "// two\n2\n"), wrong("c", "1.2", "3\n")];
        let mutants = mutate("1".parse().unwrap(), &files(), &wrongs, &[2]).unwrap();
        let expected = "\
fn f() -> u8 {
if crate::chosen_wrong::number() == 1 {
1
} else if crate::chosen_wrong::number() == 2 {
// two
2
} else {
    42
}
}
fn g() {
    work();
}
";
        assert_eq!(mutants[0].text, expected);
        let places: Vec<_> = mutants[0].places.iter().map(|p| (p.wrong, p.first, p.last)).collect();
        assert_eq!(places, [(0, 3, 3), (1, 5, 6)]);
    }

    #[test]
    fn a_wrong_answer_to_nothing_is_refused() {
        let error =
            mutate("1".parse().unwrap(), &files(), &[wrong("a", "1.4", "1\n")], &[]).err().unwrap();
        assert_eq!(error.to_string(), "tests/wrong/lab1/a.rs: lab 1 has no region 1.4");
    }
}
