//! Who cheats how, and what must come of it.
//!
//! Every cheat is the solution with something added, so whoever does not get full marks has lost
//! them by the cheat, and whoever gets them has tried in vain.

use crate::code::{
    BEFORE_MAIN, DEADLOCK, EARLY_ANSWER, ENDLESS_LOOP, ENDLESS_OUTPUT, EXIT, FORGED, FORK_BOMB,
    LET_OUT, MEMORY, MORE_THREADS, OWN_TIME, SKIPS_WHEN_TIMED, SLOW_AND_BOASTS, SLOW_UNLESS_TIMED,
    WORKS_WHEN_PROBED,
};
use crate::expected::{Expected, NOT_BUILT, REFUSED, Times};
use crate::sources::{Files, kit, with};

/// A lab, as far as a cheat must know it.
pub(crate) struct Course {
    /// Its number.
    pub(crate) lab: u8,
    /// A task that is asked by itself, whose function is reached through `call`, and its file.
    pub(crate) task: &'static str,
    call: &'static str,
    file: &'static str,
    /// Those who run: code before the answers of some tasks, and the tasks that it costs.
    runners: &'static [Runner],
}

struct Runner {
    name: &'static str,
    code: &'static [(&'static str, &'static str)],
    lost: &'static [&'static str],
    times: Times,
}

const LAB1: Course = Course {
    lab: 1,
    task: "1.1",
    call: "pair_acceleration(d)",
    file: "force.rs",
    runners: &[
        Runner {
            name: "exits",
            code: &[("1.1", EXIT), ("1.2", FORGED), ("1.4", OWN_TIME), ("1.5", EXIT)],
            lost: &["1.1", "1.2", "1.3", "1.4", "1.5"],
            times: Times::Nothing,
        },
        Runner {
            name: "bombs",
            code: &[("1.1", FORK_BOMB), ("1.4", ENDLESS_LOOP)],
            lost: &["1.1", "1.3", "1.4"],
            times: Times::Nothing,
        },
        Runner {
            name: "hangs",
            code: &[("1.4", DEADLOCK), ("1.5", ENDLESS_OUTPUT)],
            lost: &["1.4", "1.5"],
            times: Times::Nothing,
        },
        Runner { name: "hogs", code: &[("1.5", MEMORY)], lost: &["1.5"], times: Times::Any },
    ],
};

const LAB3: Course = Course {
    lab: 3,
    task: "3.2",
    call: "own_rows(worker, workers, rows)",
    file: "rows.rs",
    runners: &[
        Runner {
            name: "exits",
            code: &[("3.2", EXIT), ("3.3", FORGED), ("3.5", OWN_TIME), ("3.6", EXIT)],
            lost: &["3.2", "3.3", "3.5", "3.6"],
            times: Times::Nothing,
        },
        Runner {
            name: "bombs",
            code: &[("3.4", FORK_BOMB), ("3.7", ENDLESS_LOOP)],
            lost: &["3.4", "3.7"],
            times: Times::Nothing,
        },
        Runner {
            name: "hangs",
            code: &[("3.6", ENDLESS_OUTPUT), ("3.8", DEADLOCK)],
            lost: &["3.6", "3.8"],
            times: Times::Nothing,
        },
        Runner { name: "hogs", code: &[("3.5", MEMORY)], lost: &["3.5"], times: Times::Any },
        // Right in every task, and false when their time is taken.
        Runner {
            name: "prints-its-own-time",
            code: &[("3.8", SLOW_AND_BOASTS)],
            lost: &[],
            times: Times::Slow(75.0),
        },
        Runner {
            name: "skips-when-timed",
            code: &[("3.8", SKIPS_WHEN_TIMED)],
            lost: &[],
            times: Times::Nothing,
        },
        Runner {
            name: "answers-before-it-knows",
            code: &[("3.2", EARLY_ANSWER)],
            lost: &[],
            times: Times::Nothing,
        },
        Runner {
            name: "works-when-probed",
            code: &[("3.7", WORKS_WHEN_PROBED)],
            lost: &[],
            times: Times::Nothing,
        },
        Runner {
            name: "slow-unless-timed",
            code: &[("3.2", SLOW_UNLESS_TIMED)],
            lost: &[],
            times: Times::Any,
        },
    ],
};

/// The lab of the quick test: no other is compiled sooner.
pub(crate) const QUICK: Course = LAB1;

/// The lab of the mixed class, which has times.
pub(crate) const TIMED: Course = LAB3;

/// A cheat: its name, its sources, its end.
pub(crate) type Cheat = (String, Files, Expected);

impl Course {
    /// The lab's tasks, in the order of the record.
    pub(crate) fn tasks(&self) -> Vec<String> {
        let rubric = std::fs::read_to_string(kit().join("tests/rubric.toml")).unwrap();
        let head = format!("[lab{}.tasks]", self.lab);
        let lines = rubric.lines().skip_while(|line| *line != head).skip(1);
        let tasks = lines.map_while(|line| line.strip_prefix('"')?.split('"').next());
        let mut tasks: Vec<String> = tasks.map(String::from).collect();
        tasks.sort();
        tasks
    }

    /// Those who run: early ends, what would go on for ever, and false times.
    pub(crate) fn runners(&self) -> Vec<Cheat> {
        let cheats = self.runners.iter().map(|runner| {
            let files = with(self.lab, runner.code);
            (runner.name.to_owned(), files, Expected::loses(runner.lost, runner.times))
        });
        let mut cheats: Vec<Cheat> = cheats.collect();
        let mut files = with(self.lab, &[(self.task, LET_OUT)]);
        if let Some(crew) = files.values_mut().find(|text| text.contains(MORE_THREADS.0)) {
            *crew = crew.replace(MORE_THREADS.0, MORE_THREADS.1);
            let end = Expected::loses(&[], Times::NoScaling);
            cheats.push(("more-threads".to_owned(), files, end));
        }
        cheats
    }

    /// Those who take what is not theirs, and find that it is not there.
    pub(crate) fn takers(&self) -> Vec<Cheat> {
        let Self { lab, task, call, file, .. } = self;
        let snapshots = std::fs::read_dir(kit().join("tests/snapshots")).unwrap().flatten();
        let mut snapshots = snapshots.map(|entry| entry.file_name().into_string().unwrap());
        let mark = format!("lab{lab}__");
        let snapshot = snapshots.find(|name| name.starts_with(&mark)).unwrap();
        let stolen = |path: &str| format!("#[path = \"{path}\"] mod stolen; stolen::f();");
        let own = kit().join(format!("solutions/lab{lab}/src/{file}"));
        let solved = format!("solutions/lab{lab}");
        let environment = "unsafe { std::env::set_var(\"INSTA_FORCE_PASS\", \"1\") };";
        let cheats = [
            ("passwd", "const _: &str = include_str!(\"/etc/passwd\");".into(), "/etc/passwd"),
            (
                "snapshot",
                format!("const _: &str = include_str!(\"../../../tests/snapshots/{snapshot}\");"),
                &mark,
            ),
            (
                "solution",
                format!("if true {{ return solution{lab}::{call}; }}"),
                &format!("solution{lab}"),
            ),
            ("reach-out", stolen(&format!("../../../../../{solved}/src/{file}")), &solved),
            ("reach-home", stolen(own.to_str().unwrap()), &solved),
            ("oracle", stolen("../../../../../tests/oracle/src/model.rs"), "model.rs"),
            ("environment", environment.into(), "unsafe"),
        ];
        let cheat = |(name, code, message): (&str, String, &str)| {
            let files = with(*lab, &[(task, &code)]);
            (name.to_owned(), files, Expected::ends(NOT_BUILT, message))
        };
        cheats.map(cheat).into()
    }

    /// Those whose code would run before `main`, or in place of another's. They are not compiled.
    pub(crate) fn early(&self) -> Vec<Cheat> {
        let cheat = |(name, code, what): (&str, &str, &str)| {
            let files = with(self.lab, &[(self.task, code)]);
            (name.to_owned(), files, Expected::ends(REFUSED, what))
        };
        BEFORE_MAIN.map(cheat).into()
    }
}
