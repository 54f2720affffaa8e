//! Cheats, and their expected results.
//!
//! Every cheat is the solution with an addition. So a cheat without full marks has lost marks
//! because of its addition. A cheat with full marks has gained nothing.

use crate::code::{
    BEFORE_MAIN, DEADLOCK, EARLY_ANSWER, ENDLESS_LOOP, ENDLESS_OUTPUT, EXIT, FORGED, FORK_BOMB,
    KNOWS_THE_SIZES, LET_OUT, MEMORY, MORE_THREADS, OWN_TIME, PRINT, READS_QUESTIONS, READS_STUB,
    SERIAL, SKIPS_WHEN_TIMED, SLOW_AND_BOASTS, SLOW_AT_RANDOM, SLOW_UNLESS_TIMED, SMALL_MAIL,
    WORKS_WHEN_ANSWERING, WORKS_WHEN_ASKED,
};
use crate::expected::{Expected, NOT_BUILT, REFUSED, Times};
use crate::solution::{Files, kit, with, wrong};

/// Lab of the quick tests, which compiles fastest. It is not timed.
pub(crate) const QUICK: u8 = 1;

/// A task of this lab whose questions need no other task.
pub(crate) const TASK: &str = "1.1";

/// Lab of the mixed class, which is timed.
pub(crate) const TIMED: u8 = 3;

/// A cheat: its name, its sources, its expected result.
pub(crate) type Cheat = (String, Files, Expected);

/// Returns all cheats that are not about times.
pub(crate) fn quick() -> Vec<Cheat> {
    [runners(), takers(), vec![early(), hides(), drives()]].into_iter().flatten().collect()
}

/// Adds code to tasks of the quick lab.
fn cheat(name: &str, code: &[(&str, &str)], lost: &[&str]) -> Cheat {
    (name.to_owned(), with(QUICK, code), Expected::loses(lost, Times::Any))
}

/// Returns programs that end early or run endlessly. Printing loses no points.
fn runners() -> Vec<Cheat> {
    let exits = [("1.1", EXIT), ("1.2", FORGED), ("1.4", OWN_TIME), ("1.5", EXIT)];
    let bombs = [("1.1", FORK_BOMB), ("1.4", ENDLESS_LOOP)];
    vec![
        cheat("exits", &exits, &["1.1", "1.2", "1.3", "1.4", "1.5"]),
        cheat("bombs", &bombs, &["1.1", "1.3", "1.4"]),
        cheat("hangs", &[("1.4", DEADLOCK), ("1.5", ENDLESS_OUTPUT)], &["1.4", "1.5"]),
        cheat("hogs", &[("1.5", MEMORY)], &["1.5"]),
        cheat("prints", &[("1.2", PRINT)], &[]),
        cheat("works-when-asked", &[("1.3", WORKS_WHEN_ASKED)], &["1.3"]),
        cheat("knows-the-sizes", &[("1.3", KNOWS_THE_SIZES)], &["1.3"]),
    ]
}

/// Returns the cheat of a student who hides a function. The message must not show how the function
/// would have been called.
fn hides() -> Cheat {
    let mut files = with(QUICK, &[]);
    let motion = files.get_mut("src/motion.rs").expect("the lab has it");
    *motion = motion
        .replace("size: f64) -> (f64, f64)", "size: f64, _: u8) -> (f64, f64)")
        .replace("particle.vx, size);", "particle.vx, size, 0);")
        .replace("particle.vy, size);", "particle.vy, size, 0);");
    ("hides".to_owned(), files, Expected::ends(NOT_BUILT, "the grader cannot call it"))
}

/// Returns the cheat of a student who changes provided code. The change has no effect, and the page
/// reports it.
fn drives() -> Cheat {
    let mut files = with(QUICK, &[]);
    replace(&mut files, ("pub static VARIANTS", "static OWN"));
    let lost = Vec::new();
    let expected = Expected::Graded { lost, left_out: &["src/lib.rs"], times: Times::Any };
    ("drives".to_owned(), files, expected)
}

/// Replaces a text in the file that contains it.
fn replace(files: &mut Files, (from, to): (&str, &str)) {
    let text = files.values_mut().find(|text| text.contains(from));
    let text = text.unwrap_or_else(|| panic!("no file of the lab has '{from}'"));
    *text = text.replace(from, to);
}

/// Returns wrong programs that also change the code that would reveal the mistake.
pub(crate) fn blinders() -> Vec<Cheat> {
    let cheats = [
        (
            "open-barrier",
            "no_barrier_before_the_arrivals",
            ("state.waiting + 1 >= state.members || state.broken", "true"),
        ),
        (
            "sleeps-in-pool",
            "rest_to_the_last",
            (
                "    ThreadPoolBuilder::new()",
                "    std::thread::sleep(std::time::Duration::from_secs(100));\n    ThreadPoolBuilder::new()",
            ),
        ),
    ];
    let cheats = cheats.map(|(name, mistake, change)| {
        let (mut files, lost) = wrong(TIMED, mistake);
        replace(&mut files, change);
        (name.to_owned(), files, Expected::Graded { lost, left_out: &["src/"], times: Times::Any })
    });
    cheats.into()
}

/// Returns code that calls a function of a stolen file.
fn stolen(path: &str) -> String {
    format!("#[path = \"{path}\"] mod stolen; stolen::f();")
}

/// Returns programs that try to read forbidden files. The files must not exist in the sandbox.
fn takers() -> Vec<Cheat> {
    let snapshots = std::fs::read_dir(kit().join("tests/snapshots")).unwrap().flatten();
    let mut snapshots = snapshots.map(|entry| entry.file_name().into_string().unwrap());
    let snapshot = snapshots.find(|name| name.starts_with("lab1__")).unwrap();
    let own = kit().join("solutions/lab1/src/force.rs");
    let cheats = [
        ("passwd", "const _: &str = include_str!(\"/etc/passwd\");".into(), "/etc/passwd"),
        (
            "snapshot",
            format!("const _: &str = include_str!(\"../../../tests/snapshots/{snapshot}\");"),
            "lab1__",
        ),
        ("solution", "if true { return solution1::pair_acceleration(d); }".into(), "solution1"),
        ("questions", READS_QUESTIONS.into(), "couldn't read"),
        ("stub", READS_STUB.into(), "evaluation panicked: fn main() {}"),
        ("reach-out", stolen("../../../../../solutions/lab1/src/force.rs"), "solutions/lab1"),
        ("reach-home", stolen(own.to_str().unwrap()), "solutions/lab1"),
        ("oracle", stolen("../../../tests/oracle/src/model.rs"), "cannot find function `f`"),
        (
            "environment",
            "unsafe { std::env::set_var(\"INSTA_FORCE_PASS\", \"1\") };".into(),
            "unsafe",
        ),
    ];
    let cheats = cheats.map(|(name, code, message): (&str, String, _)| {
        let files = with(QUICK, &[(TASK, &code)]);
        (name.to_owned(), files, Expected::ends(NOT_BUILT, message))
    });
    cheats.into()
}

/// Returns a cheat whose code would run before `main`. The grader does not compile it.
fn early() -> Cheat {
    let files = with(QUICK, &[(TASK, BEFORE_MAIN)]);
    ("constructor".to_owned(), files, Expected::ends(REFUSED, "unsafe("))
}

/// Returns programs that answer every question correctly but cheat when they are timed.
///
/// If the whole program of a cheat is wrong, the cheat loses the points of the program's last task.
pub(crate) fn timed() -> Vec<Cheat> {
    let cheats: [(&str, &str, &str, &[&str], Times); 9] = [
        ("prints-its-own-time", "3.9", SLOW_AND_BOASTS, &[], Times::Slow(75.0)),
        ("skips-when-timed", "3.10", SKIPS_WHEN_TIMED, &["3.11"], Times::Nothing),
        ("answers-before-it-knows", "3.3", EARLY_ANSWER, &["3.7"], Times::Nothing),
        ("works-when-answering", "3.9", WORKS_WHEN_ANSWERING, &["3.11"], Times::Nothing),
        ("small-mail", "3.9", SMALL_MAIL, &["3.11"], Times::Nothing),
        ("slow-unless-timed", "3.11", SLOW_UNLESS_TIMED, &[], Times::Any),
        ("more-threads", "3.3", LET_OUT, &[], Times::Any),
        ("slow-at-random", "3.11", SLOW_AT_RANDOM, &[], Times::Slow(90.0)),
        ("serial-team", "3.3", "", &[], Times::Any),
    ];
    let cheats = cheats.map(|(name, task, code, lost, times)| {
        let mut files = with(TIMED, &[(task, code)]);
        match name {
            "more-threads" => replace(&mut files, MORE_THREADS),
            "serial-team" => replace(&mut files, SERIAL),
            _ => {}
        }
        (name.to_owned(), files, Expected::loses(lost, times))
    });
    cheats.into()
}
