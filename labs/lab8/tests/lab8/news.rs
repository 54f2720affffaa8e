//! Questions about news: what partners tell each other, and how a rank uses it.

use std::collections::BTreeSet;

use hard_disc_ranks::{CandidateWire, Decisions};
use lab8::{hear, news_for};
use oracle::{Ask, Random, truth};
use solution7::{Candidate, order};

use super::candidates::{
    CANDIDATE, Found, NUMBERS, among, discs_of, of_value, sorted, value, words,
};

/// Numbers of discs in the scene; a rank has some of them.
const DISCS: [u32; 5] = [1, 3, 9, 33, 300];

/// Asks for the news that a partner receives.
pub(crate) fn news_for_partners(random: &mut Random, ask: &mut impl Ask) {
    for (case, discs) in DISCS.into_iter().cycle().take(200).enumerate() {
        let found = Found::drawn(random, discs + 2);
        let mut decisions = found.decisions();
        // Some of the found candidates are not open, or not the earliest of a disc.
        let all = sorted(found.candidates.clone());
        let (taken, open) = all.split_at(all.len() / 2);
        decisions.taken = taken.to_vec();
        decisions.front = open.iter().copied().filter(|_| random.below(3) > 0).collect();
        decisions.reported = random.below(taken.len() + 1);
        for partner in [0, 2] {
            let question = format!(
                "case {case}, {} taken candidates, {} of which are already reported, {} candidates in the front, news \
                 for rank {partner}: for each candidate in the news, {CANDIDATE}, and 1 if it is taken, 0 if it is \
                 open",
                taken.len(),
                decisions.reported,
                decisions.front.len()
            );
            ask.judge(
                &question,
                || news_for(&decisions, partner).iter().flat_map(numbers).collect(),
                |news| {
                    let found_words: Vec<String> = news.chunks(NUMBERS + 1).map(in_words).collect();
                    same(&found_words, &right_news(&found, &decisions, partner))
                },
            );
        }
    }
}

fn numbers(wire: &CandidateWire) -> Vec<f64> {
    [value(&wire.into()).as_slice(), &[truth(wire.is_taken())]].concat()
}

/// Describes a piece of news in words.
fn in_words(numbers: &[f64]) -> String {
    let Some((taken, candidate)) = numbers.split_last().filter(|_| numbers.len() > NUMBERS) else {
        return "nothing".into();
    };
    named(&of_value(candidate), *taken != 0.0)
}

fn named(candidate: &Candidate, is_taken: bool) -> String {
    format!(
        "{:?} at {}, {}",
        candidate.hit,
        candidate.time,
        if is_taken { "taken" } else { "open" }
    )
}

fn right_news(found: &Found, decisions: &Decisions, partner: usize) -> Vec<String> {
    // The discs that both ranks have.
    let slots = (0..found.numbers.len()).filter(|&slot| found.reach[slot].contains(partner));
    let shared: BTreeSet<u32> = slots.map(|slot| found.numbers[slot]).collect();
    let concerns = |c: &&Candidate| discs_of(c).any(|disc| shared.contains(&disc));
    let unreported = decisions.taken.iter().skip(decisions.reported).filter(concerns);
    let open = decisions.front.iter().filter(concerns);
    unreported.map(|c| named(c, true)).chain(open.map(|c| named(c, false))).collect()
}

/// Compares two lists in words, and shows the first item that differs.
fn same(found: &[String], right: &[String]) -> Result<(), String> {
    let most = found.len().max(right.len());
    let Some(k) = (0..most).find(|&k| found.get(k) != right.get(k)) else { return Ok(()) };
    let item = |list: &[String]| list.get(k).map_or("nothing".to_owned(), String::clone);
    Err(format!(
        "entry {k} of the news, counted from 0\n     found: {}\n  expected: {}",
        item(found),
        item(right)
    ))
}

/// Asks for a rank's state after each of three messages with news of open and of taken candidates.
pub(crate) fn news_from_ranks(random: &mut Random, ask: &mut impl Ask) {
    for (case, discs) in DISCS.into_iter().cycle().take(200).enumerate() {
        let found = Found::drawn(random, discs + 2);
        let all_news: Vec<Vec<News>> = (0..3).map(|time| drawn(random, discs, time)).collect();
        let lengths: Vec<usize> = all_news.iter().map(Vec::len).collect();
        let question = format!(
            "case {case}, {} discs. News arrives three times, with {lengths:?} candidates. After each arrival, for \
             each disc: 1 if it is free, 0 if not; then {CANDIDATE} of its rival, or only -1 if it has no rival",
            found.numbers.len()
        );
        let answer = || {
            let mut decisions = found.decisions();
            let mut answer = Vec::new();
            for news in &all_news {
                let news: Vec<CandidateWire> = news.iter().map(News::wire).collect();
                hear(&mut decisions, &news);
                answer.extend(known(&decisions.free, &decisions.rivals));
            }
            answer
        };
        ask.judge(&question, answer, |answer| are_known(&found, &all_news, answer));
    }
}

/// A candidate that another rank reports.
struct News {
    candidate: Candidate,
    is_taken: bool,
}

impl News {
    fn wire(&self) -> CandidateWire {
        match self.is_taken {
            true => CandidateWire::taken(&self.candidate),
            false => CandidateWire::from(&self.candidate),
        }
    }
}

fn drawn(random: &mut Random, discs: u32, time: usize) -> Vec<News> {
    let numbers: Vec<u32> = (0..2 * discs + 6).collect();
    let mut all = among(random, &numbers);
    // The last message contains almost nothing, and old rivals are forgotten.
    all.truncate(if time == 2 { random.below(2) } else { all.len() });
    let mut news = |candidate| News { candidate, is_taken: random.below(3) == 0 };
    all.into_iter().map(&mut news).collect()
}

fn known(free: &[bool], rivals: &[Option<Candidate>]) -> Vec<f64> {
    let mut numbers = Vec::new();
    for (free, rival) in free.iter().zip(rivals) {
        numbers.push(truth(*free));
        numbers.extend(rival.map_or([-1.0; NUMBERS], |rival| value(&rival)));
    }
    numbers
}

fn are_known(found: &Found, all_news: &[Vec<News>], answer: &[f64]) -> Result<(), String> {
    let mut after = answer.chunks(1 + NUMBERS);
    let mut gone: BTreeSet<u32> = BTreeSet::new();
    for (time, news) in (1..).zip(all_news) {
        for &disc in &found.numbers {
            if of(news, disc, true).next().is_some() {
                gone.insert(disc);
            }
            let rival = of(news, disc, false).min_by(order);
            let right = known(&[!gone.contains(&disc)], &[rival]);
            let found = after.next().unwrap_or_default();
            if found != right {
                return Err(format!(
                    "arrival {time} of news, disc {disc}\n     found: {}\n  expected: {}",
                    disc_words(found),
                    disc_words(&right)
                ));
            }
        }
    }
    Ok(())
}

/// Returns the candidates of a disc that are taken, or the candidates that are open.
fn of(news: &[News], disc: u32, is_taken: bool) -> impl Iterator<Item = Candidate> {
    let has = move |news: &&News| discs_of(&news.candidate).any(|other| other == disc);
    let all = news.iter().filter(move |news| news.is_taken == is_taken);
    all.filter(has).map(|news| news.candidate)
}

fn disc_words(numbers: &[f64]) -> String {
    let Some((free, rival)) = numbers.split_first().filter(|_| numbers.len() > NUMBERS) else {
        return "nothing".into();
    };
    let free = if *free != 0.0 { "free" } else { "not free" };
    match rival[1] < 0.0 {
        true => format!("{free}, no rival"),
        false => format!("{free}, rival {}", words(&of_value(rival))),
    }
}
