//! Known-wrong solutions: `tests/wrong/labN/*.rs`, or `*.wgsl` for a region of a shader.
//!
//! Each is another body for one region, below three lines that say which, what must fail on it,
//! and what is wrong:
//!
//! ```text
//! // region: 2.4
//! // fails: task_2_4_forces_reach_all_eight_neighbours
//! // story: The four corner bins are forgotten.
//! ```
//!
//! It loses the marks of its task. Where that task's function is needed to ask about another, a line
//! `// loses: 2.7` names whose marks are lost with it.

use std::path::PathBuf;

use anyhow::{Context, Result, anyhow, ensure};

use crate::answers::{self, Part, RegionId, Task};
use crate::files::{files_below, read_text};
use crate::kit::Kit;
use crate::lab::Lab;
use crate::starter::rename;
use crate::submission::{Sources, of_solution};

/// A wrong answer to a task.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// What it is called: the name of its file.
    pub name: String,
    /// The region that it stands for.
    pub region: RegionId,
    /// The tests that must fail on it.
    pub fails: Vec<String>,
    /// Other tasks that cannot be asked without this one, and whose marks go with it.
    pub loses: Vec<Task>,
    /// What is wrong with it.
    pub story: String,
    /// The code.
    pub body: String,
}

/// Reads all wrong solutions of a lab.
pub fn read(kit: &Kit, lab: Lab) -> Result<Vec<Wrong>> {
    let paths: Vec<PathBuf> = files_below(&kit.path(format!("tests/wrong/lab{lab}")))?;
    let sources =
        paths.iter().filter(|path| path.extension().is_some_and(|e| e == "rs" || e == "wgsl"));
    sources
        .map(|path| {
            let name = path.file_stem().unwrap_or_default().to_string_lossy();
            parse(lab, &name, &read_text(path)?)
        })
        .collect()
}

impl Wrong {
    /// The solution with this answer in it, as if it had been handed in.
    pub fn in_solution(&self, kit: &Kit, lab: Lab) -> Result<Sources> {
        let mut sources = of_solution(kit, lab)?;
        for file in answers::read_solution(kit, lab)? {
            if !file.regions().any(|region| region.id == self.region) {
                continue;
            }
            let parts = file.parts.iter().map(|part| match part {
                Part::Answer(region) if region.id == self.region => self.body.as_str(),
                other => other.text(),
            });
            let text = rename(&parts.collect::<String>(), lab);
            sources.insert(file.path.to_string_lossy().into_owned(), text.into_bytes());
        }
        Ok(sources)
    }
}

/// What a line above the code may begin with.
const FIELDS: [&str; 4] = ["// region:", "// fails:", "// loses:", "// story:"];

fn parse(lab: Lab, name: &str, text: &str) -> Result<Wrong> {
    let file = format!("tests/wrong/lab{lab}/{name}.rs");
    let is_field = |line: &&str| FIELDS.iter().any(|field| line.starts_with(field));
    let head: Vec<&str> = text.lines().take_while(is_field).collect();
    let body: String = text.split_inclusive('\n').skip(head.len()).collect();
    let field = |name: &str| head.iter().find_map(|line| line.strip_prefix(name)).map(str::trim);
    let needed = |name: &str, such_as: &str| {
        let said = field(name).filter(|text| !text.is_empty());
        said.with_context(|| format!("{file}:1: the line '{name} {such_as}' is missing"))
    };
    let list = |text: &str| text.split(',').map(|part| part.trim().to_owned()).collect::<Vec<_>>();
    let error = |what: String| anyhow!("{file}:1: {what}");

    let region: RegionId = needed("// region:", "2.4")?.parse().map_err(error)?;
    ensure!(region.task.lab == lab, error(format!("task {region} is not of lab {lab}")));
    let fails = list(needed("// fails:", "task_2_4_…")?);
    let loses = field("// loses:").map(list).unwrap_or_default();
    let loses = loses.iter().map(|task| task.parse().map_err(error)).collect::<Result<_>>()?;
    let story = needed("// story:", "what is wrong")?.into();
    ensure!(!body.trim().is_empty(), "{file}:1: there is no code in it");
    Ok(Wrong { name: name.into(), region, fails, loses, story, body })
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn a_wrong_solution_is_read() {
        let text = "// region: 2.4b\n// fails: task_2_4_a, task_2_5_b\n// story: One: two.\n// why\nreturn 1;\n";
        let wrong = parse("2".parse().unwrap(), "corner", text).unwrap();
        assert_eq!((wrong.region.to_string(), &*wrong.story), ("2.4b".into(), "One: two."));
        assert_eq!(wrong.fails, ["task_2_4_a", "task_2_5_b"]);
        assert!(wrong.loses.is_empty());
        assert_eq!(wrong.body, "// why\nreturn 1;\n");
    }

    #[test]
    fn whose_marks_go_with_it_is_read() {
        let text = "// region: 2.2\n// fails: task_2_2_a\n// loses: 2.4, 2.7\n// story: x\ny\n";
        let wrong = parse("2".parse().unwrap(), "near", text).unwrap();
        let lost: Vec<String> = wrong.loses.iter().map(ToString::to_string).collect();
        assert_eq!(lost, ["2.4", "2.7"]);
    }

    #[test]
    fn what_is_missing_is_named() {
        let head = "// region: 2.4\n// fails: task_2_4_a\n// story: x\n";
        for (text, message) in [
            (head.to_owned(), "tests/wrong/lab2/x.rs:1: there is no code in it"),
            (
                head.replace("// fails: task_2_4_a\n", "") + "y",
                "tests/wrong/lab2/x.rs:1: the line '// fails: task_2_4_…' is missing",
            ),
            (
                head.replace("2.4\n", "3.4\n") + "y",
                "tests/wrong/lab2/x.rs:1: task 3.4 is not of lab 2",
            ),
            (
                head.replace("2.4\n", "two\n") + "y",
                "tests/wrong/lab2/x.rs:1: 'two' is not the number of a task, such as 3.2 or 3.2b",
            ),
        ] {
            assert_eq!(parse("2".parse().unwrap(), "x", &text).unwrap_err().to_string(), message);
        }
    }
}
