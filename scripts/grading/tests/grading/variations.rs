//! Who is right in other words, and who has not come to the end: nobody loses what is right. By hand, a lab at a time.

use std::time::Instant;

use crate::cheats::Cheat;
use crate::class::Class;
use crate::command::{TASKS, complaints, grade, run};
use crate::expected::{Expected, Times};
use crate::sources::{Files, solution};

/// What stands between two marks of a task in a file.
fn regions(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.split("// task ").skip(1).filter_map(|rest| {
        let (id, rest) = rest.split_once(": ")?;
        let (_, body) = rest.split_once('\n')?;
        Some((id, body.split_once("// end ")?.0))
    })
}

/// The solution with all its answers changed.
fn changed(lab: u8, change: impl Fn(&str, &str) -> String) -> Files {
    let mut files = solution(lab);
    for (path, text) in &mut files {
        if path.ends_with(".rs") {
            for (id, body) in regions(&text.clone()) {
                *text = text.replacen(body, &change(id, body), 1);
            }
        }
    }
    files
}

/// Names of variables of the solutions, and others.
const NAMES: [(&str, &str); 6] = [
    ("found", "what_i_found"),
    ("deal", "dealt"),
    ("lists", "to_send"),
    ("arrived", "came"),
    ("partners", "beside_me"),
    ("moved", "gone"),
];

/// A body in which a variable that it declares, and nothing else, has another name.
fn renamed(body: &str) -> String {
    let part_of_name = |c: char| c.is_alphanumeric() || "_.{".contains(c);
    NAMES.iter().fold(body.to_owned(), |body, (from, to)| {
        let is_declared = body.contains(&format!("let {from} = "));
        let is_field = body.contains(&format!("{from},")) || body.contains(&format!("{from} }}"));
        if !is_declared || is_field {
            return body;
        }
        let mut parts = body.split(from);
        let mut whole = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let inside = whole.ends_with(part_of_name) || part.starts_with(part_of_name);
            let method = part.starts_with('.') && !whole.ends_with(part_of_name);
            whole += if inside && !method { from } else { to };
            whole += part;
        }
        whole
    })
}

fn honest(lab: u8) -> Vec<Cheat> {
    let once = |what: &str, body: &str| {
        format!(
            "{{ static ONCE: std::sync::Once = std::sync::Once::new(); ONCE.call_once(|| {what}); }}\n{body}"
        )
    };
    let helped = |_: &str, body: &str| {
        format!("fn the_same<T>(value: T) -> T {{ value }}\nlet _ = the_same(0_u8);\n{body}")
    };
    let all = [
        ("prints", changed(lab, |id, body| once(&format!("println!(\"in {id}\")"), body))),
        ("complains", changed(lab, |id, body| once(&format!("eprintln!(\"in {id}\")"), body))),
        ("helper", changed(lab, helped)),
        ("names", changed(lab, |_, body| renamed(body))),
        ("clippy", changed(lab, |_, body| format!("#[allow(clippy::all)]\n{{}}\n{body}"))),
    ];
    all.map(|(name, files)| (name.to_owned(), files, Expected::full())).into()
}

/// Somebody who has not done these tasks.
fn half_done(lab: u8, tasks: &[&str]) -> Cheat {
    let is_one = |id: &str| tasks.contains(&id.trim_end_matches(char::is_alphabetic));
    let files = changed(lab, |id, body| match is_one(id) {
        true => format!("todo!(\"task {id}\")\n"),
        false => body.to_owned(),
    });
    (format!("half-done-{}", tasks[0]), files, Expected::loses(tasks, Times::Any))
}

fn graded(lab: u8, members: Vec<Cheat>) {
    let (class, start) = (Class::of(lab, members), Instant::now());
    let into = class.temporary().join("records");
    assert!(run(grade(&class, &into, TASKS)));
    let complaints = complaints(&class, &into);
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    println!("lab {lab}: {:.0} s", start.elapsed().as_secs_f64());
}

#[test]
#[ignore = "takes minutes; run it by hand"]
fn variations_of_lab_8() {
    let half = ["8.10", "8.11", "8.12", "8.13"];
    graded(8, honest(8).into_iter().chain([half_done(8, &half)]).collect());
}

#[test]
#[ignore = "takes minutes; run it by hand"]
fn variations_of_lab_9() {
    graded(9, honest(9).into_iter().chain([half_done(9, &["9.7", "9.8"])]).collect());
}

#[test]
#[ignore = "takes minutes; run it by hand"]
fn half_done_of_other_labs() {
    graded(1, [half_done(1, &["1.4", "1.5"]), half_done(1, &["1.5"])].into());
    graded(2, [half_done(2, &["2.8", "2.9"]), half_done(2, &["2.4", "2.5"])].into());
    graded(10, [half_done(10, &["10.4", "10.5", "10.6"])].into());
}
