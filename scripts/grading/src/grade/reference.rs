//! The solution, as submissions are compared with it.

use anyhow::Result;
use tempfile::TempDir;

use super::grader::Grader;
use super::probe::{self, Answer};
use super::tree::Tree;

/// The solution's programs and what they say.
pub(super) struct Reference {
    pub(super) programs: TempDir,
    /// By task, in the order of the rubric.
    pub(super) answers: Vec<(String, Vec<Answer>)>,
}

impl Reference {
    /// Builds the solution, and asks it everything if answers are to be `judged`.
    ///
    /// # Errors
    /// It cannot be built, or cannot answer.
    pub(super) fn build(grader: &Grader<'_>, tree: &Tree, judged: bool) -> Result<Self> {
        let programs = tree.reference(grader.kit, grader.sandbox)?;
        let tasks = grader.rubric.tasks.keys().filter(|_| judged);
        let answers = tasks.map(|task| {
            let said = probe::reference(grader.sandbox, programs.path(), task, grader.seed)?;
            Ok((task.clone(), said))
        });
        let answers = answers.collect::<Result<_>>()?;
        Ok(Self { programs, answers })
    }
}
