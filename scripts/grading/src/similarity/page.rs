//! The page: passages of two submissions side by side.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use maud::{Markup, html};

use super::SHOWN;
use super::pairs::{Pair, Suspect};
use crate::escape::{line, plain};
use crate::report::document;

/// What pairs share, and which files are equal.
pub(super) fn page(
    title: &str,
    cohort: &[Suspect],
    pairs: &[Pair],
    equal: &BTreeMap<Vec<String>, Vec<String>>,
) -> String {
    let body = html! {
        p.soft {
            "The percentages say how much of each student's own tokens the other has too. Names, numbers, \
             comments and layout make no difference. They are no verdict: read the passages."
        }
        @if !equal.is_empty() {
            h2 { "Equal files" }
            ul.equal {
                @for (names, files) in equal {
                    li { b { (line(&files.join(", "))) } " of " (line(&names.join(", "))) }
                }
            }
        }
        h2 { "Pairs" }
        @for pair in pairs { (details(cohort, pair)) }
    };
    document(title, body)
}

fn details(cohort: &[Suspect], pair: &Pair) -> Markup {
    let share = |share: f64| format!("{:.0} %", 100.0 * share);
    html! {
        details {
            summary {
                b { (line(&pair.first)) } " " (share(pair.of_first)) ", "
                b { (line(&pair.second)) } " " (share(pair.of_second))
            }
            @for passage in pair.passages.iter().take(SHOWN) {
                div.sides {
                    (side(cohort, &pair.first, &passage.first))
                    (side(cohort, &pair.second, &passage.second))
                }
            }
            @if pair.passages.len() > SHOWN {
                p.soft { "And " (pair.passages.len() - SHOWN) " shorter passages." }
            }
        }
    }
}

fn side(cohort: &[Suspect], name: &str, (path, lines): &(String, RangeInclusive<u32>)) -> Markup {
    let own = cohort.iter().find(|suspect| suspect.name == name);
    let file = own.and_then(|own| own.files.iter().find(|file| file.path == *path));
    let (from, to) = (*lines.start() as usize, *lines.end() as usize);
    let text = file.map_or("", |file| file.text.as_str()).lines();
    let text: Vec<&str> = text.skip(from.saturating_sub(1)).take(to + 1 - from).collect();
    html! {
        div {
            p.soft { (line(name)) ": " (line(path)) ", " (from) "\u{2013}" (to) }
            pre { (plain(&text.join("\n"))) }
        }
    }
}
