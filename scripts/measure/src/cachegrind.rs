//! Counts events of a processor by simulation, with valgrind's tool cachegrind.

use std::array::from_fn;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::{Context, Result, ensure};
use clap::Args;
use serde::{Deserialize, Serialize};

/// Cachegrind's names of the events in [`Counts`], each with its index there.
///
/// A first-level miss is a miss when data are read or written, even if the last-level cache
/// contains the data.
const EVENTS: [(&str, usize); 8] = [
    ("Ir", 0),
    ("D1mr", 1),
    ("D1mw", 1),
    ("DLmr", 2),
    ("DLmw", 2),
    ("ILmr", 2),
    ("Bcm", 3),
    ("Bim", 3),
];

/// The simulated caches, with lines of 64 bytes. The first level has 8 ways, the last level 16.
#[derive(Args, Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Caches {
    /// KiB of the first-level cache of data: a power of two
    #[arg(long, default_value_t = 32, value_name = "KIB", value_parser = power_of_two)]
    first_level: u32,
    /// KiB of the last-level cache: a power of two
    #[arg(long, default_value_t = 8192, value_name = "KIB", value_parser = power_of_two)]
    last_level: u32,
}

/// Instructions, first-level misses, last-level misses, mispredicted branches.
pub(crate) type Counts = [f64; 4];

/// Counts of a run by the location in the program: a file with a function or a line.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Profile(BTreeMap<String, Counts>);

/// The kind of the locations in a [`Profile`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum By {
    /// Functions that are not inlined, with the file that a part of them comes from
    Function,
    /// Lines of the source
    Line,
}

/// The command that makes valgrind count.
const COUNTING: [&str; 5] =
    ["valgrind", "--quiet", "--tool=cachegrind", "--cache-sim=yes", "--branch-sim=yes"];

impl Caches {
    /// Returns the bytes of the last-level cache.
    pub(crate) fn second_level(&self) -> usize {
        1024 * self.last_level as usize
    }

    /// Returns the words that make valgrind count a program's events. They precede the program's
    /// command line.
    ///
    /// The counts are in files named `counts.…` in `folder`.
    pub(crate) fn tool(&self, folder: &Path) -> Result<Vec<String>> {
        let Self { first_level, last_level } = self;
        ensure!(first_level <= last_level, "the last level cannot be smaller than the first");
        let there = Command::new("valgrind").arg("--version").stdout(Stdio::null()).status();
        there.ok().filter(|status| status.success()).context(
            "there is no valgrind, which counts: install it, on Debian and Ubuntu with 'sudo apt install valgrind'",
        )?;
        let mut words: Vec<String> =
            same_addresses().iter().chain(&COUNTING).map(|word| (*word).into()).collect();
        for (name, kib, ways) in [("I1", &32, 8), ("D1", first_level, 8), ("LL", last_level, 16)] {
            words.push(format!("--{name}={},{ways},64", 1024 * kib));
        }
        words.push(format!("--cachegrind-out-file={}/counts.%p", folder.display()));
        Ok(words)
    }
}

/// Returns the words before a program's command line that give it the same addresses in each run,
/// on which misses and mispredictions depend; empty if the system cannot fix addresses.
fn same_addresses() -> &'static [&'static str] {
    const WORDS: [&str; 2] = ["setarch", "--addr-no-randomize"];
    let tried = Command::new(WORDS[0]).args([WORDS[1], "true"]).stderr(Stdio::null()).status();
    if tried.is_ok_and(|status| status.success()) { &WORDS } else { &[] }
}

impl Profile {
    /// Reads the files that the processes of a run left in `folder`.
    pub(crate) fn take(folder: &Path, by: By) -> Result<Self> {
        let mut profile = Self::default();
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            if path.file_name().is_some_and(|name| name.to_string_lossy().starts_with("counts.")) {
                profile
                    .read(&fs::read_to_string(&path)?, by)
                    .context("valgrind wrote odd counts")?;
                fs::remove_file(&path)?;
            }
        }
        Ok(profile)
    }

    /// Adds the contents of a file of cachegrind.
    ///
    /// The file lists the names of events, then files (`fl`, or `fi` and `fe` for inlined code) and
    /// functions (`fn`). Below each function are lines with a line number of the source and its
    /// counts.
    fn read(&mut self, text: &str, by: By) -> Option<()> {
        let mut events: Vec<Option<usize>> = Vec::new();
        let mut file = "";
        let mut function = "";
        for line in text.lines() {
            if let Some(names) = line.strip_prefix("events: ") {
                events.clear();
                for name in names.split(' ') {
                    events.push(EVENTS.iter().find(|event| event.0 == name).map(|event| event.1));
                }
            } else if let Some((b'f', name)) = line.as_bytes().first().zip(line.get(3..))
                && line.get(2..3) == Some("=")
            {
                if line.starts_with("fn") { function = name } else { file = end_of(name) }
            } else if line.starts_with(|c: char| c.is_ascii_digit()) {
                let (number, counted) = line.split_once(' ')?;
                let mut counts = Counts::default();
                for (event, count) in events.iter().zip(counted.split(' ')) {
                    let count: u64 = if count == "." { 0 } else { count.parse().ok()? };
                    event.iter().for_each(|at| counts[*at] += count as f64);
                }
                let within = if by == By::Line { number } else { function };
                let there = self.0.entry(format!("{file}:{within}")).or_default();
                *there = from_fn(|at| there[at] + counts[at]);
            }
        }
        (!events.is_empty()).then_some(())
    }

    /// Returns the sums over all locations.
    pub(crate) fn total(&self) -> Counts {
        from_fn(|at| self.0.values().map(|counts| counts[at]).sum())
    }

    /// Subtracts the counts of a shorter run with the same beginning.
    pub(crate) fn beyond(&self, shorter: &Self) -> Self {
        let mut beyond = Self::default();
        for (location, counts) in &self.0 {
            let before = shorter.0.get(location).copied().unwrap_or_default();
            beyond.0.insert(location.clone(), from_fn(|at| counts[at] - before[at]));
        }
        beyond
    }

    /// Returns the `most` locations with the most instructions, in descending order.
    pub(crate) fn first(&self, most: usize) -> Vec<(&str, Counts)> {
        let mut locations: Vec<_> =
            self.0.iter().map(|(location, counts)| (&**location, *counts)).collect();
        locations.sort_by(|(_, a), (_, b)| b[0].total_cmp(&a[0]));
        locations.truncate(most);
        locations
    }
}

/// Returns the last three names of a path.
fn end_of(path: &str) -> &str {
    path.rmatch_indices('/').nth(2).map_or(path, |(at, _)| &path[at + 1..])
}

fn power_of_two(text: &str) -> Result<u32, String> {
    let size = text.parse().ok().filter(|kib: &u32| kib.is_power_of_two() && *kib <= 1 << 20);
    size.ok_or_else(|| format!("'{text}' is no power of two up to {}", 1 << 20))
}

#[cfg(test)]
mod tests {
    use super::*;

    const LONG: &str = "desc: D1 cache: 32768 B\ncmd: solution2 --steps 20\n\
        events: Ir I1mr ILmr Dr D1mr DLmr Dw D1mw DLmw Bc Bcm Bi Bim\n\
        fl=src/force.rs\nfn=pair\n7 100 0 0 9 5 1 9 2 0 9 4 9 1\n8 50 . . . . . . . . . . . .\nfi=src/grid.rs\n\
        7 10 0 0 0 0 0 0 0 0 0 0 0 0\nfl=/kit/solutions/lab2/src/grid.rs\nfn=bin\n7 1 0 0 0 0 0 0 0 0 0 0 0 0\nsummary: 161\n";

    fn read(text: &str, by: By) -> Profile {
        let mut profile = Profile::default();
        profile.read(text, by).unwrap();
        profile
    }

    #[test]
    fn counts_are_added_up_by_function_and_by_line() {
        let profile = read(LONG, By::Function);
        assert_eq!(profile.total(), [161.0, 7.0, 1.0, 5.0]);
        let first = profile.first(2);
        assert_eq!(first[0], ("src/force.rs:pair", [150.0, 7.0, 1.0, 5.0]));
        assert_eq!(first[1], ("src/grid.rs:pair", [10.0, 0.0, 0.0, 0.0]));
        let lines = read(LONG, By::Line);
        assert_eq!(lines.first(3)[2], ("src/grid.rs:7", [10.0, 0.0, 0.0, 0.0]));
        assert_eq!(lines.first(4)[3], ("lab2/src/grid.rs:7", [1.0, 0.0, 0.0, 0.0]));
        assert_eq!(Profile::default().read("no counts", By::Line), None);
    }

    #[test]
    fn what_a_shorter_run_has_too_does_not_count() {
        let long = read(LONG, By::Line);
        let short = read(&LONG.replace("7 100", "7 60"), By::Line);
        assert_eq!(long.beyond(&short).total(), [40.0, 0.0, 0.0, 0.0]);
        assert_eq!(long.beyond(&Profile::default()), long);
    }

    #[test]
    fn a_cache_is_a_power_of_two() {
        assert_eq!(power_of_two("512"), Ok(512));
        assert!(power_of_two("0").is_err() && power_of_two("48").is_err());
    }
}
