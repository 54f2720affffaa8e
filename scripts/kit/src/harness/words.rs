//! Rewrites the output of a failed test in a student's words.
//!
//! `assert_eq!` writes *left* and *right*, and insta writes *old* and *new*. The graders put the
//! lab's result on the left and the expected result on the right.

/// Beginnings of lines that do not help a student.
const FOR_AUTHORS: [&str; 7] = [
    "Source: ",
    "Expression: ",
    "Snapshot: ",
    "Snapshot file: ",
    "To update snapshots run ",
    "Stopped on the first failure.",
    "snapshot assertion for ",
];

/// Rewrites a message with *found* and *expected*, without lines that only the author of a test
/// needs.
pub(crate) fn of_a_failure(message: &str) -> String {
    const EQUAL: &str = "assertion `left == right` failed";
    let compared = message.contains(EQUAL);
    let mut lines = Vec::new();
    for line in message.lines() {
        let line = match line.strip_prefix(EQUAL) {
            Some(rest) => rest.strip_prefix(": ").unwrap_or("the two should be equal"),
            None => line,
        };
        let left = line.strip_prefix("  left: ");
        let right = line.strip_prefix(" right: ");
        match (line, left, right) {
            ("-old snapshot", ..) => lines.push("- expected".to_owned()),
            ("+new results", ..) => lines.push("+ found".to_owned()),
            (_, Some(found), _) if compared => lines.push(format!("     found: {found}")),
            (_, _, Some(expected)) if compared => lines.push(format!("  expected: {expected}")),
            _ if FOR_AUTHORS.iter().any(|begin| line.starts_with(begin)) || is_frame(line) => {}
            // This line stands for rows of a snapshot's table that are left out.
            _ if line.starts_with('┈') => lines.push("…".to_owned()),
            _ if difference(line).is_some() => lines.extend(difference(line)),
            ("", ..) if lines.last().is_some_and(String::is_empty) => {}
            _ => lines.push(line.to_owned()),
        }
    }
    lines.join("\n").trim_end().to_owned()
}

/// Whether a line is a part of the frame around a snapshot's table, or the frame's title.
fn is_frame(line: &str) -> bool {
    let rest = line.replace(" Snapshot Summary ", "");
    !line.is_empty() && rest.chars().all(|c| "─━┬┴".contains(c))
}

/// Removes the line numbers from a line of a snapshot's table, because with them many tables are
/// wider than a terminal. Adds a space after the mark, so that `-` does not look like a minus sign.
///
/// For example, `    2       │-0.003` becomes `- 0.003`.
fn difference(line: &str) -> Option<String> {
    let (numbers, text) = line.split_once('│')?;
    let (mark, rest) = text.split_at_checked(1)?;
    let is_number = numbers.chars().all(|c| c.is_ascii_digit() || c == ' ');
    (is_number && ["-", "+", " "].contains(&mark)).then(|| format!("{mark} {rest}"))
}

#[cfg(test)]
mod tests {
    use super::of_a_failure;

    #[test]
    fn the_sides_of_a_comparison_have_names() {
        let failure = "assertion `left == right` failed: from x = 1.25 in a box of 1\n  \
                    left: (1.25, 2.0)\n right: (0.75, -2.0)";
        let words =
            "from x = 1.25 in a box of 1\n     found: (1.25, 2.0)\n  expected: (0.75, -2.0)";
        assert_eq!(of_a_failure(failure), words);
        let bare = "assertion `left == right` failed\n  left: 1\n right: 2";
        assert!(of_a_failure(bare).starts_with("the two should be equal\n"), "{bare}");
        let other = "the halo came from the left:\n  left: rank 0\n right: rank 2";
        assert_eq!(of_a_failure(other), other, "not of an assertion");
    }

    #[test]
    fn the_sides_of_a_snapshot_have_names() {
        let failure = "━━━━ Snapshot Summary ━━━━\nSnapshot file: x.snap\nSnapshot: x\nSource: tests/lab1.rs:28\n────\n-old snapshot\n+new results\n────┬────\n    1       │-ax  10\n          \
                    1 │+ax  -10\n┈┈┈┈┼┈┈┈┈\n    9     9 │ ay\n────┴────\nTo update snapshots run `cargo insta review`\nStopped on \
                    the first failure. Run `cargo insta test` to run all snapshots.\n\n\nsnapshot \
                    assertion for 'x' failed in line 29";
        let words = "- expected\n+ found\n- ax  10\n+ ax  -10\n…\n  ay";
        assert_eq!(of_a_failure(failure), words);
    }
}
