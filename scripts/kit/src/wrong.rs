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
    ///
    /// # Errors
    /// The solution cannot be read.
    pub fn in_solution(&self, kit: &Kit, lab: Lab) -> Result<Sources> {
        let mut sources = of_solution(kit, lab)?;
        for file in answers::read_solution(kit, lab)? {
            if !file.marked.regions().any(|region| region.id == self.region) {
                continue;
            }
            let parts = file.marked.parts.iter().map(|part| match part {
                Part::Answer(region) if region.id == self.region => self.body.as_str(),
                Part::Answer(region) => region.body.as_str(),
                Part::Given(text) | Part::AnswerOnly(text) => text.as_str(),
            });
            let text = rename(&parts.collect::<String>(), lab);
            sources.insert(file.path.to_string_lossy().into_owned(), text.into_bytes());
        }
        Ok(sources)
    }
}

fn parse(lab: Lab, name: &str, text: &str) -> Result<Wrong> {
    let file = format!("tests/wrong/lab{lab}/{name}.rs");
    let (mut region, mut fails, mut story) = (None, Vec::new(), None);
    let mut loses = Vec::new();
    let mut body = String::new();
    for (line, number) in text.lines().zip(1..) {
        let error = |what: String| anyhow!("{file}:{number}: {what}");
        let field = line
            .strip_prefix("// ")
            .filter(|_| body.is_empty())
            .and_then(|rest| rest.split_once(':'));
        match field {
            Some(("region", id)) => {
                let id: RegionId = id.trim().parse().map_err(error)?;
                ensure!(id.task.lab == lab, error(format!("task {id} is not of lab {lab}")));
                region = Some(id);
            }
            Some(("fails", tests)) => {
                fails.extend(
                    tests
                        .split(',')
                        .map(str::trim)
                        .filter(|test| !test.is_empty())
                        .map(String::from),
                );
            }
            Some(("loses", tasks)) => {
                for task in tasks.split(',').map(str::trim) {
                    loses.push(task.parse().map_err(error)?);
                }
            }
            Some(("story", text)) => story = Some(text.trim().to_owned()),
            _ => {
                body.push_str(line);
                body.push('\n');
            }
        }
    }
    let missing = |what: &str| format!("{file}:1: the line '// {what}' is missing");
    let region = region.with_context(|| missing("region: 2.4"))?;
    let story = story.filter(|story| !story.is_empty());
    let story = story.with_context(|| missing("story: what is wrong"))?;
    ensure!(!fails.is_empty(), missing("fails: task_2_4_…"));
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
