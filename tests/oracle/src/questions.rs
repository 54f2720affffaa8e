//! The table of a lab's questions. The lab's tests, its grading and the order of both are derived
//! from the table.

use crate::asking::Judge;
#[cfg(unix)]
use crate::asking::Recorder;
#[cfg(unix)]
use crate::panics::name_the_lab;
use crate::{Question, Random};

/// Prints a table of questions for the tools, one per line: task, name, tasks needed, text.
pub fn print(questions: &[Question]) {
    // A test program prints the name of the test first, on the same line.
    println!();
    for Question { task, name, after, text } in questions {
        println!("question|{task}|{name}|{after}|{text}");
    }
}

/// Runs a submission: `answer QUESTION SEED` writes the answers to the standard input, which the
/// grader has connected to a socket.
///
/// # Panics
/// If the question does not exist, the answers cannot be written, or the submission panics.
#[cfg(unix)]
pub fn answer(questions: &[Question], ask: fn(&str, &mut Random, &mut Recorder) -> bool) {
    name_the_lab();
    let order = Order::read();
    let mut recorder = Recorder::to_grader().expect("the standard input can be replaced");
    order.ask(questions, |name, random| ask(name, random, &mut recorder));
    recorder.end();
}

/// Judges answers for the grader: `judge QUESTION SEED FILE SNAPSHOTS` prints the result; `judge`
/// alone prints the table. The paths of the lab's snapshots begin with `SNAPSHOTS`.
///
/// The result begins with three numbers: the number of requested answers, the number of correct
/// answers, and 1 if the answers broke off (0 if not). The error of the first wrong answer follows.
///
/// # Panics
/// If the question does not exist, or a file cannot be read.
pub fn judge(questions: &[Question], ask: fn(&str, &mut Random, &mut Judge) -> bool) {
    if std::env::args().len() == 1 {
        return print(questions);
    }
    let order = Order::read();
    let mut paths = std::env::args().skip(3);
    let mut path = || paths.next().expect("QUESTION SEED FILE SNAPSHOTS");
    let (file, snapshots) = (path(), path());
    let snapshot = format!("{snapshots}{}.snap", order.question.replace("::", "_"));
    // Only worked examples have a snapshot.
    let snapshot = std::fs::read_to_string(snapshot).unwrap_or_default();
    let mut judge = Judge::new(file.as_ref(), &snapshot).expect("the file of answers can be read");
    order.ask(questions, |name, random| ask(name, random, &mut judge));
    let verdict = judge.end();
    println!("{} {} {}", verdict.asked, verdict.right, u8::from(verdict.broke_off));
    print!("{}", verdict.wrong.unwrap_or_default());
}

/// A question and its seed, from the arguments of a program.
struct Order {
    question: String,
    seed: u64,
}

impl Order {
    /// Reads the first two arguments.
    fn read() -> Self {
        let mut arguments = std::env::args().skip(1);
        let mut next = || arguments.next().expect("QUESTION SEED");
        Self { question: next(), seed: next().parse().expect("the seed is a number") }
    }

    fn ask(&self, questions: &[Question], ask: impl FnOnce(&str, &mut Random) -> bool) {
        let question = questions.iter().find(|question| question.test() == self.question);
        let question = question.expect("the lab has this question");
        assert!(ask(&self.question, &mut Random::new(question.seed(self.seed))));
    }
}

/// Declares the table of a lab's questions.
///
/// ```ignore
/// oracle::questions! {
///     task_1_1 {
///         force_table => "Nine distances: the acceleration that a neighbour causes.",
///         forces => "Neighbours anywhere: the acceleration, `None` beyond the cutoff.",
///     }
///     task_1_3 {
///         steps after "1.1, 1.2" = |random, ask| steps(random, ask, "all-pairs") => "…",
///     }
/// }
/// ```
///
/// A row contains the question's name, the other tasks that the question needs, and the sentence
/// that a student reads. If the function that asks the question has a different name, the row also
/// contains this name. The function gets a `&mut Random` and an `&mut impl Ask`. The first question
/// of a task is its worked example.
#[macro_export]
macro_rules! questions {
    ($($task:ident {
        $($name:ident $(after $after:literal)? $(= $function:expr)? => $text:literal,)+
    })+) => {
        /// Questions, in the order in which their tests are reported.
        pub static QUESTIONS: &[$crate::Question] = &[$($($crate::Question {
            task: stringify!($task),
            name: stringify!($name),
            after: concat!("" $(, $after)?),
            text: $text,
        },)+)+];

        /// Asks the question that belongs to a test's name. Returns false if there is no such
        /// question.
        pub fn ask<A: $crate::Ask>(test: &str, random: &mut $crate::Random, ask: &mut A) -> bool {
            $($(if test == concat!(stringify!($task), "::", stringify!($name)) {
                $crate::questions!(@function $name $($function)?)(random, ask);
                return true;
            })+)+
            false
        }

        $(#[cfg(test)]
        mod $task {
            $(#[test]
            fn $name() {
                const TEST: &str = concat!(stringify!($task), "::", stringify!($name));
                let question = super::QUESTIONS.iter().find(|question| question.test() == TEST);
                $crate::in_test(question.expect("the question is in the table"), super::snapshot, |random, ask| {
                    super::ask(TEST, random, ask);
                });
            })+
        })+

        // A starter contains a copy of this file, but not the snapshots.
        #[cfg(test)]
        fn snapshot(name: &str, table: &str) {
            let mut settings = insta::Settings::clone_current();
            let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/snapshots");
            settings.set_snapshot_path(folder);
            settings.bind(|| insta::assert_snapshot!(name, table));
        }

        /// Prints the table, for `cargo lab`.
        #[cfg(test)]
        #[test]
        #[ignore = "prints the table of questions"]
        fn questions() {
            $crate::print_questions(QUESTIONS);
        }
    };
    (@function $name:ident) => { $name };
    (@function $name:ident $function:expr) => { ($function) };
}
