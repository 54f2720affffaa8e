//! `index.html`: an overview of a class, in one file. The file has no scripts and loads no other
//! files.

mod bars;
mod submissions;

use std::collections::BTreeSet;

use maud::{DOCTYPE, Markup, PreEscaped, html};
use pulldown_cmark::html::push_html;
use pulldown_cmark::{Options, Parser};

use super::{Words, letter, points, scale, trouble};
use crate::record::Record;
use lab_kit::escape::line;

/// A matter that an instructor must attend to, and the students or submissions concerned.
type ToSeeTo = (&'static str, Vec<String>);

/// Writes the page.
pub(crate) fn page(records: &[Record], to_see_to: &[ToSeeTo], words: &Words) -> String {
    let counting: Vec<Record> = records.iter().filter(|record| record.counts()).cloned().collect();
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta http-equiv="Content-Security-Policy"
                    content="default-src 'none'; style-src 'unsafe-inline'";
                title { (words.lab) }
                style { (PreEscaped(include_str!("page.css"))) }
            }
            body {
                h1 { (words.lab) }
                (facts(records, &counting))
                @for (what, who) in to_see_to {
                    p { b { (what) ": " } (line(&who.join("; "))) }
                }
                (bars::histogram(&counting, scale(records)))
                (bars::tasks(&counting, words))
                (submissions::table(records))
                (details(records, words))
                (provenance(records))
            }
        }
    };
    page.into_string()
}

/// Writes the statistics of a class. Only submissions that count contribute points.
fn facts(records: &[Record], counting: &[Record]) -> Markup {
    let mut given: Vec<f64> = counting.iter().map(|record| record.marked.points).collect();
    given.sort_by(f64::total_cmp);
    let full = scale(records);
    let all = given.iter().filter(|points| **points >= full - 1e-9).count();
    let broken = records.iter().filter(|record| trouble(record.found.status).is_some()).count();
    let open = records.iter().filter(|record| record.open_points() > 0.0).count();
    html! {
        div.facts {
            (fact(records.len().to_string(), "submissions"))
            @if counting.len() < records.len() { (fact(counting.len().to_string(), "that count")) }
            @for (part, what) in [(0.25, "first quartile"), (0.5, "median"), (0.75, "third quartile")] {
                (fact(points(quantile(&given, part)), &format!("{what}, of {} points", points(full))))
            }
            (fact(all.to_string(), "with all points"))
            @if broken > 0 { (fact(broken.to_string(), "unreadable, empty or not compiling")) }
            @if open > 0 { (fact(open.to_string(), "with times not graded")) }
        }
    }
}

/// Writes a number and its meaning.
fn fact(value: String, what: &str) -> Markup {
    html! { div { b { (value) } span { (what) } } }
}

/// Returns a quantile of sorted numbers, interpolated linearly between neighbours.
fn quantile(sorted: &[f64], part: f64) -> f64 {
    let at = part * sorted.len().saturating_sub(1) as f64;
    let [below, above] =
        [at.floor(), at.ceil()].map(|at| sorted.get(at as usize).copied().unwrap_or(0.0));
    below + (above - below) * at.fract()
}

/// Writes each student's letter in a collapsed section. Text that is not the grader's own is
/// escaped for Markdown.
fn details(records: &[Record], words: &Words) -> Markup {
    let full = points(scale(records));
    html! {
        h2 { "One by one" }
        @for (number, record) in records.iter().enumerate() {
            @let given = format!("{} of {full} points", points(record.marked.points));
            details {
                summary { b { (line(&record.found.name)) } ", " (trouble(record.found.status).unwrap_or(&given)) }
                div id={ "s" (number) } { (rendered(&letter::body(record, words))) }
            }
        }
    }
}

/// Converts Markdown to HTML.
fn rendered(text: &str) -> PreEscaped<String> {
    let mut out = String::new();
    push_html(&mut out, Parser::new_ext(text, Options::ENABLE_TABLES));
    PreEscaped(out)
}

/// Lists the different values of a field.
fn distinct(records: &[Record], of: fn(&Record) -> &str) -> String {
    let all: BTreeSet<&str> = records.iter().map(of).collect();
    line(&all.into_iter().collect::<Vec<_>>().join("; "))
}

/// Writes the machines and compilers that the marks depend on, and whether there was a sandbox.
fn provenance(records: &[Record]) -> Markup {
    html! {
        p.soft {
            "Machine: " (distinct(records, |record| &record.found.machine)) ". "
            "Compiler: " (distinct(records, |record| &record.found.toolchain)) ". "
            @if records.iter().all(|record| record.found.sandboxed) {
                "All programs ran in a sandbox."
            } @else {
                "Programs ran without a sandbox: their authors could have reached the answers."
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use html5gum::{Token, Tokenizer};

    use super::quantile;
    use crate::record::{LeftOut, Record, Run, Status, Verdict};
    use crate::report::Words;

    fn page(records: &[Record], words: &Words) -> String {
        let evil = "<script>alert(1)</script>";
        super::page(records, &[("Handed in nothing", vec![evil.to_owned()])], words)
    }

    #[test]
    fn quartiles_lie_between_neighbours() {
        let points = [10.0, 20.0, 40.0, 80.0];
        assert_eq!([0.25, 0.5, 0.75].map(|part| quantile(&points, part)), [17.5, 30.0, 50.0]);
        assert_eq!((quantile(&[7.0], 0.25), quantile(&[], 0.5)), (7.0, 0.0));
    }

    fn hostile() -> Record {
        let mut record = Record::sample_of_speed(Verdict::Wrong);
        let evil = "</pre></details><script>alert(1)</script><img src=x onerror=\"a\">' \" &lt;";
        record.found.name = evil.into();
        record.tasks[1].message = evil.into();
        record.found.message = evil.into();
        record.found.left_out.push(LeftOut { path: evil.into(), reason: evil.into() });
        record.marked.measures[0].message = evil.into();
        record
    }

    /// Returns the tags of a page, with the names of their attributes.
    fn tags(page: &str) -> Vec<(String, Vec<String>)> {
        let tokens = Tokenizer::new(page).flatten();
        let mut tags = Vec::new();
        for token in tokens {
            if let Token::StartTag(tag) = token {
                let name = String::from_utf8_lossy(&tag.name).into_owned();
                let attributes = tag.attributes.keys();
                let attributes = attributes.map(|key| String::from_utf8_lossy(key).into_owned());
                tags.push((name, attributes.collect()));
            }
        }
        tags
    }

    #[test]
    fn nothing_that_a_student_writes_becomes_a_tag() {
        let text = page(&[hostile(), hostile()], &Words::default());
        for (tag, attributes) in tags(&text) {
            assert!(!["script", "img", "link", "iframe"].contains(&tag.as_str()), "{tag}");
            assert!(attributes.iter().all(|name| !name.starts_with("on")), "{attributes:?}");
        }
        assert!(text.contains("&lt;script&gt;alert(1)"));
    }

    #[test]
    fn a_page_holds_together_without_anybody() {
        let text = page(&[], &Words::default());
        assert!(text.contains("<b>0</b>") && text.ends_with("</html>"));
        let mut broken = hostile();
        broken.found.status = Status::Unreadable;
        broken.found.runs = Vec::<Run>::new();
        let text = page(&[broken], &Words::default());
        assert!(
            text.contains("<td class=\"ended\" colspan=\"3\">could not be read</td>"),
            "{text}"
        );
    }
}
