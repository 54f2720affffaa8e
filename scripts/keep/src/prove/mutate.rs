//! Builds all wrong answers into a solution at once.
//!
//! Compiling a lab once for each wrong answer would take an hour. So each answer with wrong
//! versions becomes a chain: `if chosen() == 1 { wrong } else if … else { the answer }`. An
//! environment variable chooses the answer when the tests run.

use std::path::{Path, PathBuf};

use anyhow::{Result, ensure};

use lab_kit::Lab;
use lab_kit::answers::{MarkedFile, Part, Region};
use lab_kit::wrong::Wrong;

/// Returns the files of a solution with all wrong answers built in, by path in the solution's
/// folder.
pub(crate) fn mutate(
    lab: Lab,
    files: &[MarkedFile],
    wrongs: &[Wrong],
) -> Result<Vec<(PathBuf, String)>> {
    for Wrong { name, region, .. } in wrongs {
        let is_known = files.iter().flat_map(MarkedFile::regions).any(|known| known.id == *region);
        ensure!(is_known, "tests/wrong/lab{lab}/{name}.rs: lab {lab} has no region {region}");
    }
    let mut mutants = Vec::new();
    for file in files {
        let mut text = String::new();
        for part in &file.parts {
            text += &match part {
                Part::Answer(region) if file.is_shader() => alternatives(region, wrongs),
                Part::Answer(region) => chain(region, wrongs),
                given if file.is_shader() => given.text().to_owned(),
                given => choosing_sources(given.text()),
            };
        }
        if file.path == Path::new("src/lib.rs") {
            text += &chooser(lab);
        }
        mutants.push((file.path.clone(), text));
    }
    Ok(mutants)
}

/// Returns the wrong answers to a region, with their numbers.
fn numbered<'w>(region: &Region, wrongs: &'w [Wrong]) -> impl Iterator<Item = (usize, &'w str)> {
    let id = region.id;
    let all = (1..=wrongs.len()).zip(wrongs).filter(move |(_, wrong)| wrong.region == id);
    all.map(|(number, wrong)| (number, wrong.body.as_str()))
}

fn chain(region: &Region, wrongs: &[Wrong]) -> String {
    let mut chain = String::new();
    for (number, body) in numbered(region, wrongs) {
        chain += &format!("if crate::chosen_wrong::number() == {number} {{\n{body}}} else ");
    }
    let answer = &region.body;
    if chain.is_empty() { answer.clone() } else { format!("{chain}{{\n{answer}}}\n") }
}

/// Writes the wrong answers of a shader, which is compiled when the lab runs.
///
/// The answers are marked in the text: below a line `//= 3` is the answer of wrong solution 3,
/// below `//= 0` the right answer, and `//= end` ends them.
fn alternatives(region: &Region, wrongs: &[Wrong]) -> String {
    let all = [(0, region.body.as_str())].into_iter().chain(numbered(region, wrongs));
    let all: String = all.map(|(number, body)| format!("//= {number}\n{body}")).collect();
    all + "//= end\n"
}

/// Returns the environment variable and the value that choose wrong solution `index` of `lab`.
pub(super) fn environment(lab: Lab, index: usize) -> (String, String) {
    (variable(lab), (index + 1).to_string())
}

/// Returns the name of a lab's variable. Each lab has its own variable, because a lab may depend on
/// another lab's code.
fn variable(lab: Lab) -> String {
    format!("CUTOFF_WRONG_{lab}")
}

/// Passes every shader's source through `source` of the module that [`chooser`] writes.
fn choosing_sources(text: &str) -> String {
    text.split_inclusive('\n')
        .map(|line| match line.find("include_str!(").zip(line.find(".wgsl\")")) {
            Some((first, last)) => {
                let (before, rest) = line.split_at(first);
                let (include, after) = rest.split_at(last + ".wgsl\")".len() - first);
                format!("{before}crate::chosen_wrong::source({include}){after}")
            }
            None => line.to_owned(),
        })
        .collect()
}

/// Writes the module that the chains call. Innermost loops call it too, so it only loads one
/// number.
fn chooser(lab: Lab) -> String {
    let variable = variable(lab);
    format!(
        "
mod chosen_wrong {{
    use std::collections::BTreeMap;
    use std::sync::atomic::{{AtomicU32, Ordering::Relaxed}};

    const UNREAD: u32 = u32::MAX;
    static NUMBER: AtomicU32 = AtomicU32::new(UNREAD);

    #[inline]
    pub(crate) fn number() -> u32 {{
        match NUMBER.load(Relaxed) {{
            UNREAD => read(),
            number => number,
        }}
    }}

    /// A shader with the chosen one of its answers.
    #[allow(dead_code)]
    pub(crate) fn source(all: &'static str) -> &'static str {{
        let number = number().to_string();
        let mut chosen = String::new();
        for region in all.split_inclusive(\"//= end\\n\") {{
            let mut answers = region.split(\"//= \");
            chosen += answers.next().unwrap_or_default();
            let answers: BTreeMap<_, _> = answers.filter_map(|one| one.split_once('\\n')).collect();
            chosen += answers.get(&*number).or(answers.get(\"0\")).copied().unwrap_or_default();
        }}
        chosen.leak()
    }}

    #[cold]
    fn read() -> u32 {{
        let number = std::env::var(\"{variable}\").ok().and_then(|n| n.parse().ok()).unwrap_or(0);
        NUMBER.store(number, Relaxed);
        number
    }}
}}
"
    )
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
            passes: vec![],
            loses: vec![],
            story: "x".into(),
            body: body.into(),
        }
    }

    fn files() -> Vec<MarkedFile> {
        let parts = parse(Path::new("src/a.rs"), SOURCE).unwrap();
        vec![MarkedFile { path: "src/a.rs".into(), parts }]
    }

    #[test]
    fn wrong_answers_become_a_chain() {
        let wrongs = [wrong("a", "1.2", "1\n"), wrong("b", "1.2", "// two\n2\n")];
        let mutants = mutate("1".parse().unwrap(), &files(), &wrongs).unwrap();
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
        assert_eq!(mutants, [("src/a.rs".into(), expected.to_owned())]);
    }

    #[test]
    fn a_wrong_answer_to_nothing_is_refused() {
        let error =
            mutate("1".parse().unwrap(), &files(), &[wrong("a", "1.4", "1\n")]).err().unwrap();
        assert_eq!(error.to_string(), "tests/wrong/lab1/a.rs: lab 1 has no region 1.4");
    }
}
