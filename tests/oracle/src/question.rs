//! A question about a task.

/// One question about one task: a row of a lab's table of questions.
#[derive(Debug)]
pub struct Question {
    /// Task as an identifier, `task_3_2` for 3.2.
    pub task: &'static str,
    /// Name of the question.
    pub name: &'static str,
    /// Other tasks that the question depends on, such as `"3.1, 3.2"`. Grading asks the question
    /// only if these tasks are correct, so that a mistake costs one task.
    pub after: &'static str,
    /// Sentence that a student reads.
    pub text: &'static str,
}

impl Question {
    /// Returns the name of the question's test: `task_3_2::forces`.
    pub fn test(&self) -> String {
        format!("{}::{}", self.task, self.name)
    }

    /// Returns a separate seed for the question, derived from a seed for all questions.
    pub(crate) fn seed(&self, seed: u64) -> u64 {
        // FNV-1a.
        let mix = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        self.test().bytes().fold(0xcbf2_9ce4_8422_2325 ^ seed, mix)
    }
}
