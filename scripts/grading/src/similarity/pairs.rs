//! What two submissions share.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::ops::RangeInclusive;

use serde::Serialize;

use super::prints::{self, Print, RUN};
use super::tokens::{Token, tokens};
use lab_kit::files::digest;
use lab_kit::submission::Sources;

/// A submission, taken apart.
#[derive(Debug)]
pub(super) struct Suspect {
    pub(super) name: String,
    /// Whether it is of a class before this one: those are not compared with each other.
    pub(super) before: bool,
    pub(super) files: Vec<File>,
    tokens: Vec<Token>,
    /// Which tokens are the starter's.
    given: Vec<bool>,
    prints: Vec<Print>,
}

/// A source, and what it was handed in as.
#[derive(Debug)]
pub(super) struct File {
    pub(super) path: String,
    pub(super) text: String,
    /// SHA-256.
    digest: String,
}

/// The same tokens in two submissions.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Passage {
    /// How many tokens.
    pub(super) tokens: usize,
    /// Where in the first: file, and lines.
    pub(super) first: (String, RangeInclusive<u32>),
    /// Where in the second.
    pub(super) second: (String, RangeInclusive<u32>),
}

/// Two submissions and what they share.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Pair {
    pub(super) first: String,
    pub(super) second: String,
    /// Of the first's own tokens, the share that the second has too; 0 to 1.
    pub(super) of_first: f64,
    /// Of the second's.
    pub(super) of_second: f64,
    /// The passages, longest first.
    pub(super) passages: Vec<Passage>,
}

/// What everybody was given.
#[derive(Debug, Default)]
pub(super) struct Starter {
    /// The hashes of all runs.
    runs: HashSet<u64>,
    digests: HashSet<String>,
}

impl Starter {
    pub(super) fn new(sources: &Sources) -> Self {
        let files = rust_files(sources);
        let runs = files.iter().flat_map(|file| prints::hashes(&tokens(&file.text, 0, 0)));
        Self { runs: runs.collect(), digests: files.iter().map(|f| f.digest.clone()).collect() }
    }
}

fn rust_files(sources: &Sources) -> Vec<File> {
    let rust = sources.iter().filter(|(path, _)| path.ends_with(".rs"));
    let file = |(path, bytes): (&String, &Vec<u8>)| File {
        path: path.clone(),
        text: String::from_utf8_lossy(bytes).into_owned(),
        digest: digest(bytes),
    };
    rust.map(file).collect()
}

impl Suspect {
    /// Takes a submission apart; `number` is its number in the cohort.
    pub(super) fn new(name: String, number: u32, sources: &Sources, starter: &Starter) -> Self {
        let files = rust_files(sources);
        let all = (0..).zip(&files).flat_map(|(at, file)| tokens(&file.text, at, number));
        let all: Vec<Token> = all.collect();
        let hashes = prints::hashes(&all);
        let given = prints::given(&hashes, all.len(), &starter.runs);
        let prints = prints::winnow(&hashes).into_iter();
        let prints = prints.filter(|print| !starter.runs.contains(&print.hash)).collect();
        Self { name, before: false, files, tokens: all, given, prints }
    }

    /// How many tokens are the student's own.
    fn own(&self) -> usize {
        self.given.iter().filter(|given| !**given).count()
    }

    fn place(&self, from: usize, length: usize) -> (String, RangeInclusive<u32>) {
        let (first, last) = (&self.tokens[from], &self.tokens[from + length - 1]);
        (self.files[usize::from(first.file)].path.clone(), first.line..=last.line)
    }
}

/// All pairs of a cohort that share something, most first.
pub(super) fn pairs(cohort: &[Suspect]) -> Vec<Pair> {
    let common = common(cohort);
    let mut pairs = Vec::new();
    for (index, first) in cohort.iter().enumerate() {
        let others = cohort[index + 1..].iter().filter(|second| !(first.before && second.before));
        pairs.extend(others.filter_map(|second| compare(first, second, &common)));
    }
    let most = |pair: &Pair| pair.of_first.max(pair.of_second);
    pairs.sort_by(|a, b| most(b).total_cmp(&most(a)));
    pairs
}

/// Files that are equal to the byte and not the starter's: by those who have them, more than one.
pub(super) fn equal(cohort: &[Suspect], starter: &Starter) -> BTreeMap<Vec<String>, Vec<String>> {
    let mut files: BTreeMap<&str, (&str, Vec<String>)> = BTreeMap::new();
    for suspect in cohort {
        for file in suspect.files.iter().filter(|file| !starter.digests.contains(&file.digest)) {
            let (_, names) = files.entry(&file.digest).or_insert((&file.path, Vec::new()));
            names.push(suspect.name.clone());
        }
    }
    let mut groups: BTreeMap<Vec<String>, Vec<String>> = BTreeMap::new();
    for (path, names) in files.into_values().filter(|(_, names)| names.len() > 1) {
        groups.entry(names).or_default().push(path.to_owned());
    }
    groups
}

/// What more than half of a cohort wrote, and more than five: the obvious way to write it. Who hands in
/// another's file wrote nothing, so that equal files count once.
fn common(cohort: &[Suspect]) -> HashSet<u64> {
    let mut written: HashMap<u64, HashSet<&str>> = HashMap::new();
    for suspect in cohort {
        for print in &suspect.prints {
            let file = &suspect.files[usize::from(suspect.tokens[print.at].file)];
            written.entry(print.hash).or_default().insert(&file.digest);
        }
    }
    let limit = (cohort.len() / 2).max(5);
    written.into_iter().filter(|(_, files)| files.len() > limit).map(|(hash, _)| hash).collect()
}

fn compare(first: &Suspect, second: &Suspect, common: &HashSet<u64>) -> Option<Pair> {
    let mut places: HashMap<u64, Vec<usize>> = HashMap::new();
    for print in &second.prints {
        places.entry(print.hash).or_default().push(print.at);
    }
    let mut found = BTreeSet::new();
    for print in first.prints.iter().filter(|print| !common.contains(&print.hash)) {
        for &at in places.get(&print.hash).into_iter().flatten() {
            found.extend(stretch(first, second, print.at, at));
        }
    }
    // The longest come first; nothing counts twice.
    let mut found: Vec<_> = found.into_iter().collect();
    found.sort_by_key(|&(length, a, b)| (std::cmp::Reverse(length), a, b));
    let (mut in_first, mut in_second) =
        (vec![false; first.tokens.len()], vec![false; second.tokens.len()]);
    let mut passages = Vec::new();
    for (length, a, b) in found {
        if in_first[a..a + length].contains(&true) || in_second[b..b + length].contains(&true) {
            continue;
        }
        in_first[a..a + length].fill(true);
        in_second[b..b + length].fill(true);
        let (first, second) = (first.place(a, length), second.place(b, length));
        passages.push(Passage { tokens: length, first, second });
    }
    let shared: usize = passages.iter().map(|passage| passage.tokens).sum();
    (shared > 0).then(|| Pair {
        first: first.name.clone(),
        second: second.name.clone(),
        of_first: shared as f64 / first.own().max(1) as f64,
        of_second: shared as f64 / second.own().max(1) as f64,
        passages,
    })
}

/// The longest equal stretch around the runs at `a` and `b`, as (length, from, from); none if the
/// hashes only met by chance. It ends where the starter's code begins.
fn stretch(first: &Suspect, second: &Suspect, a: usize, b: usize) -> Option<(usize, usize, usize)> {
    let same = |a: usize, b: usize| {
        first.tokens[a].code == second.tokens[b].code && !first.given[a] && !second.given[b]
    };
    // A run may begin or end with what is given; what lies between is the student's own.
    let within = (0..RUN).find(|&i| same(a + i, b + i))?;
    let (a, b) = (a + within, b + within);
    let room = (first.tokens.len() - a).min(second.tokens.len() - b);
    let after = (0..room).take_while(|&i| same(a + i, b + i)).count();
    let before = (1..=a.min(b)).take_while(|&i| same(a - i, b - i)).count();
    let length = before + after;
    (length >= RUN / 2).then_some((length, a - before, b - before))
}
