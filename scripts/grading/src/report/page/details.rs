//! Each submission in words.

use crate::escape::{html, line};
use crate::record::Record;
use crate::report::{Words, points, trouble, words};

/// What went wrong, folded, in words.
pub(crate) fn details(records: &[Record], words: &Words) -> String {
    let mut out = String::from("<h2>One by one</h2>\n");
    for (number, record) in records.iter().enumerate() {
        let state = trouble(record.status).map_or_else(
            || format!("{} of {} points", points(record.points), points(record.out_of)),
            |trouble| trouble.to_owned(),
        );
        out += &format!(
            "<details><summary><b>{}</b>, {state}</summary>\n<div id=\"s{number}\">\n",
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
                let said = html(&line(&words::measured(measure)));
                out += &format!("<p><b>{head}.</b> {said}</p>\n");
            }
            for sentence in words::speed(record) {
                out += &format!("<p class=\"soft\">{}</p>\n", code(&html(&line(&sentence))));
            }
        }
        for left in &record.left_out {
            let (path, reason) = (html(&line(&left.path)), html(&line(&left.reason)));
            out += &format!("<p class=\"soft\">Not taken: {path}: {reason}</p>\n");
        }
        out += "</div>\n</details>\n";
    }
    out
}

/// What stands between two backticks, as code.
fn code(html: &str) -> String {
    let parts: Vec<&str> = html.split('`').collect();
    let part = |(at, part): (usize, &&str)| match at % 2 {
        1 if at + 1 < parts.len() => format!("<code>{part}</code>"),
        1 => format!("`{part}"),
        _ => (*part).to_owned(),
    };
    parts.iter().enumerate().map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::code;

    #[test]
    fn only_pairs_of_backticks_are_code() {
        assert_eq!(code("`crew` with 2 threads"), "<code>crew</code> with 2 threads");
        assert_eq!(code("one ` alone"), "one ` alone");
        assert_eq!(code("`a` and `b"), "<code>a</code> and `b");
    }
}
