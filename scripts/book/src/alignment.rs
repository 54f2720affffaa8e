//! Aligns columns of numbers to the right, so that their digits line up.

/// Returns the page with its columns of numbers aligned to the right.
///
/// A column is not changed if its table sets an alignment for it.
pub(crate) fn aligned(text: &str) -> String {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let mut out = String::with_capacity(text.len());
    let mut in_code = false;
    for (at, line) in lines.iter().enumerate() {
        in_code ^= line.starts_with("```");
        if !in_code && is_rule(line) && at > 0 && lines[at - 1].starts_with('|') {
            let rows = lines[at + 1..].iter().take_while(|line| line.starts_with('|'));
            out += &with_alignment(line, &rows.map(|row| cells(row)).collect::<Vec<_>>());
        } else {
            out += line;
        }
    }
    out
}

/// Whether a line is the line of dashes below the head of a table.
fn is_rule(line: &str) -> bool {
    line.starts_with('|') && line.contains("---") && line.trim().chars().all(|c| "|-: ".contains(c))
}

/// Returns the line of dashes with a colon for each column of numbers.
fn with_alignment(rule: &str, rows: &[Vec<&str>]) -> String {
    let mut out = String::from("|");
    for (column, dashes) in cells(rule).into_iter().enumerate() {
        let below = rows.iter().filter_map(|row| row.get(column));
        let mut filled = below.filter(|cell| !is_empty(cell)).peekable();
        let numbers = filled.peek().is_some() && filled.all(|cell| is_number(cell));
        out += dashes;
        out += if numbers && !dashes.contains(':') { ":|" } else { "|" };
    }
    out + "\n"
}

/// Returns the cells of a row of a table, without the spaces around them.
fn cells(row: &str) -> Vec<&str> {
    let mut cells = Vec::new();
    let mut begin = 1;
    let mut in_code = false;
    for (at, c) in row.char_indices().skip(1) {
        in_code ^= c == '`';
        if c == '|' && !in_code && row.as_bytes()[at - 1] != b'\\' {
            cells.push(row[begin..at].trim());
            begin = at + 1;
        }
    }
    cells
}

fn is_empty(cell: &str) -> bool {
    ["", "–", "-", "—"].contains(&cell)
}

/// Whether a cell is a number, with or without a unit or a second number, such as `36 to 43`.
fn is_number(cell: &str) -> bool {
    let cell = cell.trim_matches(['*', '(', ')', '~', '<', '>', '−', '-', '+', '×', ' ']);
    let words = cell.split(|c: char| !c.is_alphabetic());
    cell.starts_with(|c: char| c.is_ascii_digit())
        && words.into_iter().all(|word| word.chars().count() <= 3)
}

#[cfg(test)]
mod tests {
    use super::aligned;

    #[test]
    fn columns_of_numbers_are_right_aligned() {
        let table = "| program | n | time | of | note |\n|---|---|---|:---|---|\n\
                     | `a\\|b` | 1,000 | 36 to 43 | 1 | 2 threads |\n| b | 10,000 | – | 2 | none |\n";
        let right = table.replace("|---|---|---|:---|---|", "|---|---:|---:|:---|---|");
        assert_eq!(aligned(table), right);
        let code = format!("```\n{table}```\n");
        assert_eq!(aligned(&code), code);
    }

    #[test]
    fn a_column_without_numbers_stays() {
        let table = "| a | b |\n|---|---|\n| [2.1](x.md) | – |\n";
        assert_eq!(aligned(table), table);
    }
}
