//! Width of the output.

use std::io::{IsTerminal, stdout};

/// Number of columns of a page, and of a terminal whose width is unknown.
pub(crate) const WIDTH: usize = 80;

/// Returns the number of columns of the terminal.
pub fn columns() -> usize {
    let column_count = rustix::termios::tcgetwinsize(stdout()).map_or(0, |size| size.ws_col);
    if column_count == 0 { WIDTH } else { column_count.into() }
}

/// Formats `text` after `head`, folded to the width of the terminal.
///
/// Further lines are indented to the first word of the text. Without a terminal, the result is one
/// line.
pub fn folded(head: &str, text: &str) -> String {
    fold(head, text, if stdout().is_terminal() { columns() } else { usize::MAX })
}

/// Formats `text` after `head`, folded to `columns` columns.
pub fn fold(head: &str, text: &str, columns: usize) -> String {
    let (spaces, text) = text.split_at(text.len() - text.trim_start().len());
    let mut out = head.to_owned() + spaces;
    let indent = out.chars().count();
    let mut at = indent;
    for (number, word) in text.split(' ').enumerate() {
        let width = word.chars().count();
        if number > 0 && at + 1 + width > columns {
            out += &format!("\n{:indent$}", "");
            at = indent;
        } else if number > 0 {
            out.push(' ');
            at += 1;
        }
        out += word;
        at += width;
    }
    out + "\n"
}

#[cfg(test)]
mod tests {
    use super::fold;

    #[test]
    fn words_go_on_below_where_they_began() {
        assert_eq!(fold("lab 3    well: ", "it is", 80), "lab 3    well: it is\n");
        let text = "particle 3 is lost at once";
        assert_eq!(fold("  - ", text, 16), "  - particle 3\n    is lost at\n    once\n");
        let deeper = format!("  {text}");
        assert_eq!(fold("  ", &deeper, 16), "    particle 3\n    is lost at\n    once\n");
        assert_eq!(fold("  ", "n   2   3", 80), "  n   2   3\n", "a table stays one");
    }
}
