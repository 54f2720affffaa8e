//! Foreign text in pages of ours.
//!
//! Names of submissions and panic messages are a student's to choose. Nothing of them may become
//! markup, a formula of a spreadsheet, or a command to a terminal.

/// The beginning of a foreign text: nobody reads megabytes.
pub(crate) fn cut(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}\u{2026}", &text[..end]),
        None => text.to_owned(),
    }
}

/// The text without what steers terminals or turns the direction of writing: U+FFFD stands there.
pub(crate) fn plain(text: &str) -> String {
    let steers = |c: char| {
        (c.is_control() && c != '\n' && c != '\t')
            || matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    let kept = text.chars().filter(|c| *c != '\r');
    kept.map(|c| if steers(c) { '\u{fffd}' } else { c }).collect()
}

/// The text on one line.
pub(crate) fn line(text: &str) -> String {
    plain(text).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Within a line of Markdown, not at its beginning: what could be markup or a link is taken for
/// itself.
pub(crate) fn markdown(text: &str) -> String {
    let text = line(text);
    let mut out = String::with_capacity(text.len());
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        let next = rest.peek().copied().unwrap_or(' ');
        let marks = match c {
            // Of a sentence; within a word, part of an address that would become a link.
            '.' | ':' => !next.is_whitespace() && !next.is_ascii_digit(),
            ',' | '-' | '+' | '%' | ';' | '?' | '/' | '"' | '\'' => false,
            c => c.is_ascii_punctuation(),
        };
        if marks {
            out.push('\\');
        }
        out.push(c);
    }
    out
}

/// A block of code in Markdown, whatever backticks are in the text.
pub(crate) fn fenced(text: &str) -> String {
    let text = plain(text);
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest.max(2) + 1);
    format!("{fence}text\n{}\n{fence}\n", text.trim_end())
}

/// A cell of a table. What a spreadsheet would compute gets an apostrophe before it. In many countries a semicolon
/// ends a cell, so the words behind one are guarded too.
pub(crate) fn cell(text: &str) -> String {
    let text = line(text);
    let guarded = text.split(';').map(|part| {
        let (blank, rest) = part.split_at(part.len() - part.trim_start().len());
        let guard = if rest.starts_with(['=', '+', '-', '@']) { "'" } else { "" };
        format!("{blank}{guard}{rest}")
    });
    guarded.collect::<Vec<_>>().join(";")
}

#[cfg(test)]
mod tests {
    use super::{cell, fenced, line, markdown};

    #[test]
    fn markup_is_text() {
        assert_eq!(markdown("[a](http://b) *c*\n# d"), "\\[a\\]\\(http\\://b\\) \\*c\\* \\# d");
    }

    #[test]
    fn a_fence_is_longer_than_any_within() {
        assert_eq!(fenced("a\n````\n<b>"), "`````text\na\n````\n<b>\n`````\n");
        assert_eq!(fenced(""), "```text\n\n```\n");
    }

    #[test]
    fn spreadsheets_compute_nothing() {
        for formula in ["=HYPERLINK(\"x\")", "+1+1", "-2", "@SUM(A1)", "\t=1+1", "\r\n =1"] {
            let field = cell(formula);
            assert!(field.starts_with('\''), "{field}");
        }
        assert_eq!(cell("a,b\nc"), "a,b c");
        assert_eq!(cell("ada;=1+1; -2;b"), "ada;'=1+1; '-2;b");
    }

    #[test]
    fn terminals_are_not_steered() {
        assert_eq!(line("\u{1b}[31mred\u{202e}der\r\n"), "\u{fffd}[31mred\u{fffd}der");
    }
}
