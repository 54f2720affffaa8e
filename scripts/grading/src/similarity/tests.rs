//! Copies are found however they are dressed up; independent solutions are left in peace.

use std::collections::{BTreeMap, HashSet};

use ra_ap_rustc_lexer::{FrontmatterAllowed, TokenKind, tokenize};

use super::pairs::{self, Pair, Starter, Suspect};
use lab_kit::Kit;
use lab_kit::starter;
use lab_kit::submission::{Sources, collect};

fn whole_kit() -> Kit {
    Kit::find().unwrap()
}

fn given(lab: &str) -> Sources {
    let files = starter::generate(&whole_kit(), lab.parse().unwrap()).unwrap().into_iter();
    files.map(|(path, bytes)| (path.to_str().unwrap().to_owned(), bytes)).collect()
}

fn solution(lab: &str) -> Sources {
    collect(&whole_kit().solution(lab.parse().unwrap())).unwrap().files
}

fn compare(lab: &str, submissions: &[&Sources]) -> Vec<Pair> {
    compare_beside(&Starter::new(&given(lab)), submissions)
}

fn compare_beside(starter: &Starter, submissions: &[&Sources]) -> Vec<Pair> {
    pairs::pairs(&cohort(starter, submissions))
}

fn cohort(starter: &Starter, submissions: &[&Sources]) -> Vec<Suspect> {
    let cohort = submissions.iter().enumerate().map(|(number, sources)| {
        Suspect::new(format!("s{number}"), number as u32, sources, starter)
    });
    cohort.collect()
}

/// Every name another one, every comment gone, all on one line after another.
fn renamed(source: &str) -> String {
    let keep = ["self", "Self", "crate", "super"];
    let mut out = String::new();
    let mut at = 0;
    for token in tokenize(source, FrontmatterAllowed::No) {
        let text = &source[at..at + token.len as usize];
        at += text.len();
        match token.kind {
            TokenKind::LineComment { .. } | TokenKind::BlockComment { .. } => {}
            TokenKind::Whitespace => out.push('\n'),
            TokenKind::Ident
                if !keep.contains(&text) && text.len() > 3 && text != "impl" && text != "move" =>
            {
                let keyword =
                    super::tokens::tokens(text, 0, 0)[0] != super::tokens::tokens("x", 0, 0)[0];
                out.push_str(&if keyword { text.to_owned() } else { format!("my_{text}") });
            }
            _ => out.push_str(text),
        }
    }
    out
}

fn text(files: &[(&str, &str)]) -> Sources {
    files.iter().map(|(path, text)| ((*path).into(), text.as_bytes().to_vec())).collect()
}

#[test]
fn a_renamed_copy_is_a_copy() {
    let original = solution("2");
    let copy: Sources = original
        .iter()
        .map(|(path, bytes)| {
            let text = renamed(std::str::from_utf8(bytes).unwrap());
            (path.replace("src/", "src/my_"), text.into_bytes())
        })
        .collect();
    let pairs = compare("2", &[&original, &copy]);
    assert!(pairs[0].of_first > 0.95 && pairs[0].of_second > 0.95, "{pairs:?}");
}

#[test]
fn the_starter_does_not_count() {
    let starter = given("2");
    assert!(compare("2", &[&starter, &starter]).is_empty());
}

const FUNCTIONS: [&str; 3] = [
    "pub fn fold(x: f64, size: f64) -> f64 {
    let period = 2.0 * size;
    let folded = x.rem_euclid(period);
    if folded <= size { folded } else { period - folded }
}
",
    "pub fn nearest(all: &[f64], x: f64) -> Option<usize> {
    let mut best = None;
    for (index, y) in all.iter().enumerate() {
        let distance = (x - y).abs();
        if best.is_none_or(|(_, least)| distance < least) {
            best = Some((index, distance));
        }
    }
    best.map(|(index, _)| index)
}
",
    "pub fn count(all: &[f64], from: f64, to: f64) -> usize {
    let mut count = 0;
    for x in all {
        if *x >= from && *x < to {
            count += 1;
        }
    }
    count
}
",
];

#[test]
fn functions_in_another_order_are_the_same_functions() {
    let [a, b, c] = FUNCTIONS;
    let original = text(&[("src/lib.rs", &format!("{a}{b}{c}"))]);
    let copy = text(&[("src/one.rs", &renamed(&format!("{c}{a}"))), ("src/two.rs", &renamed(b))]);
    let pairs = compare_beside(&Starter::default(), &[&original, &copy]);
    assert!(pairs[0].of_first > 0.9 && pairs[0].of_second > 0.9, "{pairs:?}");
    let places: HashSet<_> = pairs[0].passages.iter().map(|p| p.second.0.as_str()).collect();
    assert_eq!(places, HashSet::from(["src/one.rs", "src/two.rs"]));
}

/// The same three functions, thought of by somebody else.
const INDEPENDENT: &str = "
pub fn fold(x: f64, size: f64) -> f64 {
    let mut x = x;
    while !(0.0..=size).contains(&x) {
        x = if x < 0.0 { -x } else { 2.0 * size - x };
    }
    x
}

pub fn nearest(all: &[f64], x: f64) -> Option<usize> {
    (0..all.len()).min_by(|&i, &j| (all[i] - x).abs().total_cmp(&(all[j] - x).abs()))
}

pub fn count(all: &[f64], from: f64, to: f64) -> usize {
    all.iter().filter(|x| (from..to).contains(*x)).count()
}
";

#[test]
fn an_independent_solution_is_left_in_peace() {
    let original = text(&[("src/lib.rs", &FUNCTIONS.concat())]);
    let other = text(&[("src/lib.rs", INDEPENDENT)]);
    let pairs = compare_beside(&Starter::default(), &[&original, &other]);
    let most = pairs.iter().map(|pair| pair.of_first.max(pair.of_second)).fold(0.0, f64::max);
    assert!(most < 0.4, "{pairs:?}");
}

/// Labs 2 and 7 are written by the same people in the same style.
#[test]
fn programs_of_the_same_kind_are_not_the_same() {
    let pairs = compare_beside(&Starter::default(), &[&solution("2"), &solution("7")]);
    let most = pairs.iter().map(|pair| pair.of_first.max(pair.of_second)).fold(0.0, f64::max);
    assert!(most < 0.4, "{most}");
}

#[test]
fn what_everybody_wrote_is_nobodys_copy() {
    let class: Vec<Sources> = (0..12)
        .map(|number| text(&[("src/lib.rs", &format!("// {number}\n{}", FUNCTIONS.concat()))]))
        .collect();
    let class: Vec<&Sources> = class.iter().collect();
    assert!(compare_beside(&Starter::default(), &class).is_empty());
}

#[test]
fn equal_files_are_seen_however_many_have_them() {
    let same = text(&[("src/lib.rs", &FUNCTIONS.concat()), ("src/given.rs", "fn given() {}\n")]);
    let starter = Starter::new(&text(&[("src/given.rs", "fn given() {}\n")]));
    let other = text(&[("src/lib.rs", INDEPENDENT)]);
    let class: Vec<&Sources> = (0..12).map(|at| if at < 7 { &same } else { &other }).collect();
    let cohort = cohort(&starter, &class);
    let whole = |pair: &&Pair| pair.of_first.min(pair.of_second) > 0.9;
    assert_eq!(pairs::pairs(&cohort).iter().filter(whole).count(), 7 * 6 / 2 + 5 * 4 / 2);
    let names =
        |range: std::ops::Range<usize>| range.map(|at| format!("s{at}")).collect::<Vec<_>>();
    let groups: Vec<_> = pairs::equal(&cohort, &starter).into_keys().collect();
    assert_eq!(groups, [names(0..7), names(7..12)]);
}

#[test]
fn a_class_before_is_compared_with_this_one_alone() {
    let same = text(&[("src/lib.rs", &FUNCTIONS.concat())]);
    let mut cohort = cohort(&Starter::default(), &[&same, &same, &same]);
    cohort[1..].iter_mut().for_each(|suspect| suspect.before = true);
    let pairs = pairs::pairs(&cohort);
    let seconds: Vec<&str> = pairs.iter().map(|pair| pair.second.as_str()).collect();
    assert_eq!(seconds, ["s1", "s2"]);
    let page = super::page::page("Lab 1", &cohort, &pairs, &BTreeMap::new());
    assert_eq!(page.matches("let period = 2.0 * size;").count(), 4, "{page}");
}
