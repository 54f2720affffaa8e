//! `index.html`: a class at a glance. One file, no scripts, nothing loaded from elsewhere.

use super::escape::{html, line};
use super::{Words, points, trouble, words};
use crate::grade::record::{Measure, Record, Task, Verdict};

/// Bars of the histogram.
const BARS: usize = 10;

/// The page.
pub(super) fn page(records: &[Record], words: &Words) -> String {
    let title = html(&words.lab);
    let mut out = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" \
         content=\"default-src 'none'; style-src 'unsafe-inline'\">\n\
         <title>{title}</title>\n<style>\n{}</style>\n</head>\n<body>\n<h1>{title}</h1>\n",
        include_str!("overview.css")
    );
    out += &facts(records);
    out += &histogram(records);
    out += &tasks(records, words);
    out += &table(records);
    out += &details(records, words);
    out += &provenance(records);
    out + "</body>\n</html>\n"
}

/// What of the points that could be had was given, 0 to 1.
fn share(record: &Record) -> f64 {
    if record.out_of > 0.0 { (record.points / record.out_of).clamp(0.0, 1.0) } else { 0.0 }
}

fn facts(records: &[Record]) -> String {
    let mut shares: Vec<f64> = records.iter().map(share).collect();
    shares.sort_by(f64::total_cmp);
    let median = match shares.len() {
        0 => 0.0,
        n => 0.5 * (shares[(n - 1) / 2] + shares[n / 2]),
    };
    let full = shares.iter().filter(|share| **share >= 1.0 - 1e-9).count();
    let broken = records.iter().filter(|record| trouble(record.status).is_some()).count();
    let open = records.iter().filter(|record| record.open_points() > 0.0).count();
    let mut out = String::from("<div class=\"facts\">\n");
    let mut fact = |value: String, what: &str| {
        out += &format!("<div><b>{value}</b><span>{what}</span></div>\n");
    };
    fact(records.len().to_string(), "submissions");
    fact(format!("{:.0} %", 100.0 * median), "median of the points");
    fact(full.to_string(), "with all points");
    if broken > 0 {
        fact(broken.to_string(), "unreadable, empty or not compiling");
    }
    if open > 0 {
        fact(open.to_string(), "with times not graded");
    }
    out + "</div>\n"
}

fn histogram(records: &[Record]) -> String {
    let mut counts = [0_usize; BARS];
    for record in records {
        counts[((share(record) * BARS as f64) as usize).min(BARS - 1)] += 1;
    }
    let most = counts.iter().copied().max().unwrap_or(0).max(1) as f64;
    let mut out = String::from(
        "<h2>Points</h2>\n<svg viewBox=\"0 0 320 120\" role=\"img\" \
         aria-label=\"How many submissions got which share of the points\">\n\
         <line x1=\"0\" x2=\"320\" y1=\"100\" y2=\"100\"/>\n",
    );
    for (bar, count) in counts.iter().enumerate() {
        let (x, height) = (bar * 32, 80.0 * *count as f64 / most);
        if *count > 0 {
            let y = 100.0 - height;
            out += &format!(
                "<rect x=\"{}\" y=\"{y:.1}\" width=\"26\" height=\"{height:.1}\"/>\n\
                 <text x=\"{}\" y=\"{:.1}\" text-anchor=\"middle\">{count}</text>\n",
                x + 3,
                x + 16,
                y - 4.0
            );
        }
        out += &format!("<text x=\"{x}\" y=\"115\">{}</text>\n", 100 / BARS * bar);
    }
    out + "<text x=\"320\" y=\"115\" text-anchor=\"end\">%</text>\n</svg>\n"
}

/// How many have each task.
fn tasks(records: &[Record], words: &Words) -> String {
    let Some(first) = records.first() else { return String::new() };
    let mut out = String::from("<h2>Tasks</h2>\n<ul class=\"bars\">\n");
    for task in first.tasks_in_order() {
        let has = |record: &&Record| record.tasks.iter().any(|own| own.id == task.id && own.passed);
        let (have, all) = (records.iter().filter(has).count(), records.len());
        out += &format!(
            "<li><span>{}</span><span class=\"bar\"><i style=\"width:{:.0}%\"></i></span>\
             <span class=\"count\">{have} of {all}</span></li>\n",
            html(&words.task(&task.id)),
            100.0 * have as f64 / all as f64
        );
    }
    out + "</ul>\n"
}

fn table(records: &[Record]) -> String {
    let Some(first) = records.first() else { return String::new() };
    let mut out = String::from(
        "<h2>Submissions</h2>\n<div class=\"wide\"><table>\n<thead><tr><th>name</th><th>points</th>",
    );
    for task in first.tasks_in_order() {
        out += &format!("<th>{}</th>", html(&task.id));
    }
    for measure in &first.measures {
        out += &format!("<th>{}</th>", measure.kind.name());
    }
    out += "</tr></thead>\n<tbody>\n";
    for (number, record) in records.iter().enumerate() {
        let name = html(&line(&record.name));
        out += &format!(
            "<tr><td title=\"{name}\"><a href=\"#s{number}\">{name}</a></td>\
             <td class=\"points\">{} of {}<span class=\"bar\"><i style=\"width:{:.0}%\"></i></span></td>",
            points(record.points),
            points(record.out_of),
            100.0 * share(record)
        );
        for task in first.tasks_in_order() {
            out += &cell(record.tasks.iter().find(|own| own.id == task.id));
        }
        for measure in &first.measures {
            out += &grade(record.measures.iter().find(|own| own.kind == measure.kind));
        }
        out += "</tr>\n";
    }
    out + "</tbody>\n</table></div>\n<p class=\"soft\">\u{2713} right, \u{2717} not right, ? not \
           graded. A number is the grade of a measure, of 100.</p>\n"
}

fn cell(task: Option<&Task>) -> String {
    match task {
        Some(task) if task.passed => "<td><span class=\"good\">\u{2713}</span></td>".into(),
        Some(task) => format!(
            "<td><span class=\"bad\" title=\"{}\">\u{2717}</span></td>",
            html(&line(&task.message))
        ),
        None => "<td></td>".into(),
    }
}

fn grade(measure: Option<&Measure>) -> String {
    let Some(measure) = measure else { return "<td></td>".into() };
    let (class, text) = match (measure.verdict, measure.grade) {
        (Verdict::Graded, Some(grade)) => {
            (if grade >= 75.0 { "good" } else { "bad" }, format!("{grade:.0}"))
        }
        (Verdict::Wrong, _) => ("bad", "\u{2717}".into()),
        _ => ("open", "?".into()),
    };
    let why = html(&line(&measure.message));
    format!("<td><span class=\"{class}\" title=\"{why}\">{text}</span></td>")
}

/// What went wrong, folded, in words.
fn details(records: &[Record], words: &Words) -> String {
    let mut out = String::from("<h2>One by one</h2>\n");
    for (number, record) in records.iter().enumerate() {
        let state = trouble(record.status).map_or_else(
            || format!("{} of {} points", points(record.points), points(record.out_of)),
            |trouble| trouble.to_owned(),
        );
        out += &format!(
            "<details id=\"s{number}\"><summary><b>{}</b>, {state}</summary>\n",
            html(&line(&record.name))
        );
        if !record.message.is_empty() {
            out += &format!("<pre>{}</pre>\n", html(&record.message));
        }
        if trouble(record.status).is_none() {
            let lost = record.tasks_in_order().into_iter().filter(|task| !task.passed);
            for task in lost {
                out += &format!(
                    "<p>\u{2717} {}</p><pre>{}</pre>\n",
                    html(&words.task(&task.id)),
                    html(&task.message)
                );
            }
            for measure in &record.measures {
                let head = html(&line(&words::heading(measure)));
                out += &format!("<p><b>{head}.</b> {}.</p>\n", html(&line(&measure.message)));
            }
            for sentence in words::speed(record) {
                out += &format!("<p class=\"soft\">{}</p>\n", html(&line(&sentence)));
            }
        }
        for left in &record.left_out {
            let (path, reason) = (html(&line(&left.path)), html(&line(&left.reason)));
            out += &format!("<p class=\"soft\">Not taken: {path}: {reason}</p>\n");
        }
        out += "</details>\n";
    }
    out
}

/// What the marks rest on.
fn provenance(records: &[Record]) -> String {
    let distinct = |of: fn(&Record) -> String| {
        let mut all: Vec<String> = records.iter().map(of).collect();
        all.sort();
        all.dedup();
        html(&all.join("; "))
    };
    let sandboxed = records.iter().all(|record| record.sandboxed);
    format!(
        "<p class=\"soft\">Machine: {}. Compiler: {}. {}</p>\n",
        distinct(|record| record.machine.clone()),
        distinct(|record| record.toolchain.clone()),
        if sandboxed {
            "All programs ran in a sandbox."
        } else {
            "Programs ran without a sandbox: whoever wrote them could have reached the answers."
        }
    )
}

#[cfg(test)]
mod tests {
    use html5gum::{Token, Tokenizer};

    use super::page;
    use crate::grade::record::{Kind, LeftOut, Measure, Record, Run, Status, Verdict};
    use crate::grade::report::Words;

    fn hostile() -> Record {
        let mut record: Record =
            serde_json::from_str(include_str!("../../../tests/record.json")).unwrap();
        let evil = "</pre></details><script>alert(1)</script><img src=x onerror=\"a\">' \" &lt;";
        record.name = evil.into();
        record.tasks[1].message = evil.into();
        record.message = evil.into();
        record.left_out.push(LeftOut { path: evil.into(), reason: evil.into() });
        record.measures.push(Measure {
            kind: Kind::Speed,
            variant: "sorted".into(),
            verdict: Verdict::Wrong,
            message: evil.into(),
            grade: Some(0.0),
            points: 0.0,
            out_of: 20.0,
        });
        record
    }

    /// The tags of a page, with their attributes.
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
        assert!(text.contains("<b>0</b>") && text.ends_with("</html>\n"));
        let mut broken = hostile();
        broken.status = Status::Unreadable;
        broken.runs = Vec::<Run>::new();
        assert!(page(&[broken], &Words::default()).contains("could not be read"));
    }
}
