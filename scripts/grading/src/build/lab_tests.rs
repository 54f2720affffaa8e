//! The lab's own tests on a submission. They run in the submission's own process, so they can be
//! made to say anything: students read them, and no mark depends on them.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, ensure};
use serde_json::Value;
use tempfile::TempDir;

use super::cache::{Cache, copy};
use super::tree;
use crate::record::{Test, Tests};
use crate::sandbox::Sandbox;
use lab_keep::handout;
use lab_kit::harness::{Outcome, Verdict};
use lab_kit::process::run as run_process;
use lab_kit::submission::Sources;
use lab_kit::{Kit, Lab};

/// A build takes no longer; the first one compiles what the tests depend on.
const BUILD: Duration = Duration::from_secs(300);

/// All tests of a submission together take no longer.
const ALL: Duration = Duration::from_secs(90);

/// Of what a test says, so many characters are kept.
const KEPT: usize = 2000;

/// A tree in which the tests of one submission after another are built.
pub(crate) struct Bench {
    folder: TempDir,
    lab: Lab,
    /// The names of the tests that there are, and whether each runs by itself.
    tests: Vec<(String, bool)>,
    cache: Cache,
}

impl Bench {
    /// Lays the tree: a handout with the lab's tests and their oracle.
    pub(crate) fn lay(kit: &Kit, lab: Lab, sandbox: &Sandbox) -> Result<Self> {
        let folder = sandbox.folder()?;
        handout::lay(kit, lab, folder.path())?;
        let source = fs::read_to_string(kit.path(format!("tests/lab{lab}.rs")))
            .with_context(|| format!("lab {lab} has no tests"))?;
        tree::fetch(folder.path(), &format!("lab{lab}"));
        let cache = Cache::of(kit, "tests");
        cache.put_into(folder.path())?;
        Ok(Self { folder, lab, tests: tests(&source), cache })
    }

    /// Whether what the tests depend on is kept from another time.
    pub(crate) fn is_kept(&self) -> Result<bool> {
        self.cache.is_of(self.folder.path())
    }

    /// Compiles what the tests depend on, with the starter that the handout has, and keeps it for
    /// the next time.
    pub(crate) fn cache(&self, sandbox: &Sandbox) -> Result<()> {
        let built = run_process(&mut self.build(sandbox), BUILD)?;
        ensure!(built.status.is_some_and(|s| s.success()), "the tests: {}", built.stderr);
        tree::put(self.folder.path(), self.lab, &Sources::new())?;
        self.cache.keep(self.folder.path())
    }

    /// Another one, with all that is built in this.
    pub(crate) fn copy(&self, sandbox: &Sandbox) -> Result<Self> {
        let folder = sandbox.folder()?;
        copy(self.folder.path(), folder.path()).context("cannot copy a tree for tests")?;
        let (tests, cache) = (self.tests.clone(), self.cache.clone());
        Ok(Self { folder, lab: self.lab, tests, cache })
    }

    fn build(&self, sandbox: &Sandbox) -> Command {
        let name = format!("lab{}", self.lab);
        let mut cargo = sandbox.cargo(self.folder.path());
        cargo.args(["test", "--no-run", "--offline", "--package", &name, "--test", &name]);
        cargo.args(["--quiet", "--message-format=json-render-diagnostics"]);
        cargo
    }

    /// Runs the tests on these sources.
    pub(crate) fn run(&self, sandbox: &Sandbox, sources: &Sources) -> Result<Tests> {
        tree::put(self.folder.path(), self.lab, sources)?;
        let none = |message: &str| Tests {
            complete: false,
            message: message.chars().take(KEPT).collect(),
            ran: Vec::new(),
        };
        let name = format!("lab{}", self.lab);
        let built = run_process(&mut self.build(sandbox), BUILD)?;
        let Some(program) = program(&built.stdout, &name) else {
            return Ok(none(&format!("the tests do not compile: {}", built.stderr)));
        };
        let listed = run_process(
            self.command(sandbox, &program).args(["--list", "--format", "terse"]),
            sandbox.limit(),
        )?;
        let mut listed: Vec<_> =
            listed.stdout.lines().filter_map(|line| line.strip_suffix(": test")).collect();
        listed.sort_unstable();
        let start = Instant::now();
        let ran = self.tests.iter().filter(|(_, runs)| *runs).map(|(test, _)| {
            let not_run = Test { name: test.clone(), passed: None, message: String::new() };
            if start.elapsed() > ALL {
                return Ok(not_run);
            }
            let mut command = self.command(sandbox, &program);
            command.args(["--exact", "--nocapture", test]);
            let outcome = Outcome::read(test, &run_process(&mut command, sandbox.limit())?);
            let passed = Some(outcome.verdict == Verdict::Passed);
            let message = match outcome.verdict {
                Verdict::Passed | Verdict::Ignored => String::new(),
                Verdict::Crashed(how) => how,
                Verdict::TimedOut => format!("no end within {} s", sandbox.limit().as_secs()),
                Verdict::Failed | Verdict::Skipped => outcome.message.chars().take(KEPT).collect(),
            };
            Ok(Test { passed, message, ..not_run })
        });
        let ran = ran.collect::<Result<_>>()?;
        let complete = listed.iter().copied().eq(self.tests.iter().map(|(name, _)| name.as_str()));
        Ok(Tests { complete, message: String::new(), ran })
    }

    fn command(&self, sandbox: &Sandbox, program: &Path) -> Command {
        let folder = PathBuf::from(format!("labs/lab{}", self.lab));
        let environment =
            [("CARGO_MANIFEST_DIR", folder.clone()), ("INSTA_WORKSPACE_ROOT", PathBuf::new())];
        sandbox.test(self.folder.path(), program, &folder, &environment)
    }
}

/// The test program, relative to the tree: what cargo says of the one that it built last.
fn program(messages: &str, name: &str) -> Option<PathBuf> {
    let messages = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let mut tests = messages.filter(|message| {
        message["target"]["name"] == name && message["target"]["kind"][0] == "test"
    });
    let path = tests.next_back()?["executable"].as_str()?.to_owned();
    let (_, inside) = path.split_once("/target/")?;
    Some(Path::new("target").join(inside))
}

/// The tests that a source has, in the order of their names, and whether each runs by itself: an
/// ignored one is a part of another.
fn tests(source: &str) -> Vec<(String, bool)> {
    let mut tests = Vec::new();
    let (mut test, mut ignored) = (false, false);
    for line in source.lines().map(str::trim) {
        match line {
            "#[test]" => test = true,
            _ if line.starts_with("#[ignore") => ignored = true,
            _ if line.starts_with("#[") || line.starts_with("//") => {}
            _ => {
                if let Some(rest) = line.strip_prefix("fn ").filter(|_| test) {
                    let name = rest.split(['(', '<']).next().unwrap_or_default();
                    tests.push((name.to_owned(), !ignored));
                }
                (test, ignored) = (false, false);
            }
        }
    }
    tests.sort();
    tests
}

#[cfg(test)]
mod checks {
    use super::tests;

    #[test]
    fn tests_are_found_in_their_source() {
        let source = "#[test]\nfn b() {\n    let x = 1;\n}\n\n#[test]\n#[should_panic]\nfn a() {}\n\
                      #[test]\n#[ignore = \"a part of b\"]\nfn part() {}\nfn helper() {}\n";
        let found = tests(source);
        let found: Vec<_> = found.iter().map(|(name, runs)| (name.as_str(), *runs)).collect();
        assert_eq!(found, [("a", true), ("b", true), ("part", false)]);
    }
}
