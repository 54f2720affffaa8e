//! Escapes foreign text for pages, letters, tables and the terminal.
//!
//! Students choose the names of submissions and the messages of panics. This text must not become
//! markup, a spreadsheet formula, or a terminal command.

/// Returns the beginning of a foreign text, at most `most` characters. The text may be megabytes
/// long.
pub fn cut(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}\u{2026}", &text[..end]),
        None => text.to_owned(),
    }
}

/// Replaces terminal control characters and marks of writing direction by U+FFFD.
pub fn plain(text: &str) -> String {
    text.replace('\r', "").replace(steers, "\u{fffd}")
}

fn steers(c: char) -> bool {
    (c.is_control() && c != '\n' && c != '\t')
        || matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Puts a text on one line.
pub fn line(text: &str) -> String {
    plain(text).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Escapes a text for the middle of a line of Markdown, so that it contains no markup and no link.
pub fn markdown(text: &str) -> String {
    let text = line(text);
    let mut out = String::with_capacity(text.len());
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        let next = rest.peek().copied().unwrap_or(' ');
        let marks = match c {
            // Dots and colons are harmless at the end of a sentence. Inside a word they may form an
            // address, which would become a link.
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

/// Escapes a text for HTML and SVG, between tags and in quoted attributes.
pub fn html(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

/// Makes a code block in Markdown, even if the text contains backticks.
pub fn fenced(text: &str) -> String {
    let text = plain(text);
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest.max(2) + 1);
    format!("{fence}text\n{}\n{fence}\n", text.trim_end())
}

/// Escapes a table cell. A possible formula gets an apostrophe before it.
///
/// In many countries a semicolon ends a cell, so the text after a semicolon is escaped too.
pub fn cell(text: &str) -> String {
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
    use super::{cell, fenced, html, line, markdown};

    #[test]
    fn markup_is_text() {
        assert_eq!(html("<a href=\"b&c\">"), "&lt;a href=&quot;b&amp;c&quot;>");
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
