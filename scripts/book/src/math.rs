//! Renders formulas, `$…$` and `$$…$$`, as MathML, so that a page needs neither a script nor the
//! network.

use std::ops::Range;

use anyhow::{Context, Result};
use pulldown_cmark::{Event, Options, Parser as Markdown};
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser as Latex, Storage, push_mathml};

/// The Markdown that mdBook understands.
const DIALECT: Options = Options::ENABLE_TABLES
    .union(Options::ENABLE_FOOTNOTES)
    .union(Options::ENABLE_STRIKETHROUGH)
    .union(Options::ENABLE_TASKLISTS)
    .union(Options::ENABLE_HEADING_ATTRIBUTES);

/// Punctuation that stays on the line of the next formula.
const OPENING: [char; 2] = ['(', '“'];
/// Punctuation that stays on the line of the previous formula.
const CLOSING: [char; 7] = [',', '.', ';', ':', '?', ')', '”'];

/// Renders every formula of a chapter. Code and `\$` stay as they are.
///
/// # Errors
/// A formula is not valid LaTeX; the message quotes it.
pub(crate) fn render(markdown: &str) -> Result<String> {
    let formulas: Vec<(Range<usize>, String)> =
        Markdown::new_ext(markdown, DIALECT | Options::ENABLE_MATH)
            .into_offset_iter()
            .filter_map(|(event, range)| match event {
                Event::InlineMath(tex) => Some((range, tex, DisplayMode::Inline)),
                Event::DisplayMath(tex) => Some((range, tex, DisplayMode::Block)),
                _ => None,
            })
            .map(|(range, tex, mode)| Ok((range, formula(&tex, mode)?)))
            .collect::<Result<_>>()?;
    let mut out = String::with_capacity(markdown.len());
    let mut done = 0;
    for (range, mathml) in formulas {
        // Without the enclosing tag, a browser could break the line between a formula and its
        // punctuation.
        let before = markdown[done..range.start].trim_end_matches(OPENING);
        let after = markdown[range.end..].trim_start_matches(CLOSING);
        let from = done + before.len();
        let to = markdown.len() - after.len();
        out.push_str(before);
        if (from, to) == (range.start, range.end) {
            out.push_str(&mathml);
        } else {
            let opened = &markdown[from..range.start];
            let closed = &markdown[range.end..to];
            out.push_str(&format!("<span class=\"glued\">{opened}{mathml}{closed}</span>"));
        }
        done = to;
    }
    out.push_str(&markdown[done..]);
    Ok(out)
}

const STRUT: &str = "<mspace height=\"0.75em\" depth=\"0.1em\"/>";

fn formula(tex: &str, display_mode: DisplayMode) -> Result<String> {
    let storage = Storage::new();
    let events: Vec<_> = Latex::new(tex, &storage)
        .collect::<Result<_, _>>()
        .map_err(|e| anyhow::anyhow!("{e}"))
        .with_context(|| format!("formula ${tex}$"))?;
    let mut mathml = String::new();
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    push_mathml(&mut mathml, events.into_iter().map(Ok::<_, std::convert::Infallible>), config)?;
    // A root sign has a minimum height. Without the strut, a sign with low contents would reach
    // below the line.
    let mathml = mathml.replace("<msqrt>", &format!("<msqrt>{STRUT}"));
    // Without these attributes, a bar of `\lvert` or `\rvert` would have the space of a relation
    // around it.
    let mathml = mathml.replace(">|</mo>", " lspace=\"0\" rspace=\"0\">|</mo>");
    let mathml = shield(&mathml);
    Ok(match display_mode {
        DisplayMode::Inline => mathml,
        // On a narrow screen, a wide formula scrolls instead of the page.
        DisplayMode::Block => format!("<span class=\"formula\">{mathml}</span>"),
    })
}

/// Replaces the characters in tags that Markdown would interpret.
fn shield(mathml: &str) -> String {
    let mut out = String::with_capacity(mathml.len());
    for c in mathml.chars() {
        match c {
            '\n' => out.push(' '),
            '*' | '_' | '\\' | '`' | '[' | ']' | '|' | '~' | '\'' => {
                out.push_str(&format!("&#{};", c as u32));
            }
            _ => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::render;

    #[test]
    fn formulas_become_mathml_and_code_stays() {
        let page =
            render("The cutoff $c$, in `$code$`.\n\n```sh\necho $HOME $PATH\n```\n").unwrap();
        assert!(page.contains("<math") && page.contains("<mi>c</mi>"), "{page}");
        assert!(page.contains("`$code$`") && page.contains("echo $HOME $PATH"), "{page}");
    }

    #[test]
    fn nothing_in_a_formula_is_markdown() {
        let page = render("$a * b * c_1$ and $\\lVert d \\rVert_2$").unwrap();
        assert!(!page.contains(['*', '_', '|']), "{page}");
    }

    #[test]
    fn punctuation_stays_at_its_formula() {
        let page = render("It falls ($s < 0$)? If $s$ is 0, $t$.").unwrap();
        assert!(page.contains("falls <span class=\"glued\">(<math"), "{page}");
        assert!(page.contains("</math>)?</span> If <math"), "{page}");
        assert!(page.contains("</math> is"), "{page}");
        assert!(page.ends_with("</math>.</span>"), "{page}");
    }

    #[test]
    fn a_bad_formula_is_an_error_that_quotes_it() {
        let error = render("$\\frac{1}$").unwrap_err();
        assert!(error.to_string().contains("\\frac{1}"), "{error}");
    }
}
