//! Rust source as tokens, without what a copyist changes first.

use ra_ap_rustc_lexer::{FrontmatterAllowed, TokenKind, tokenize};

/// A token, and where it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Token {
    /// What it is. Every name is the same, every number is the same.
    pub(super) code: u32,
    /// Its file, by number.
    pub(super) file: u16,
    /// Its line, from 1.
    pub(super) line: u32,
}

/// Codes below this are characters, from here on keywords and kinds.
const KINDS: u32 = 0x11_0000;
const NAME: u32 = KINDS;
const LITERAL: u32 = KINDS + 1;
const LIFETIME: u32 = KINDS + 2;
const KEYWORD: u32 = KINDS + 16;
/// From here on: the end of a file, another one for each.
const END: u32 = KINDS + 0x1000;

/// Words that are no names. `self` and the primitive types are left to be names: a copyist may
/// turn a method into a function.
const KEYWORDS: [&str; 33] = [
    "as", "async", "await", "break", "const", "continue", "dyn", "else", "enum", "extern", "fn",
    "for", "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref",
    "return", "static", "struct", "trait", "type", "unsafe", "use", "where", "while", "yield",
];

/// The tokens of a file, without comments and layout, closed by one that no other file has.
/// `salt` tells the ends of different submissions apart. Code that does not compile has tokens too.
pub(super) fn tokens(source: &str, file: u16, salt: u32) -> Vec<Token> {
    let mut tokens = Vec::new();
    let (mut at, mut line) = (0, 1);
    for token in tokenize(source, FrontmatterAllowed::No) {
        let text = &source[at..at + token.len as usize];
        if let Some(code) = code(token.kind, text) {
            tokens.push(Token { code, file, line });
        }
        line += text.matches('\n').count() as u32;
        at += text.len();
    }
    tokens.push(Token { code: END + salt * 0x100 + u32::from(file), file, line });
    tokens
}

fn code(kind: TokenKind, text: &str) -> Option<u32> {
    Some(match kind {
        TokenKind::Whitespace
        | TokenKind::LineComment { .. }
        | TokenKind::BlockComment { .. }
        | TokenKind::Frontmatter { .. } => return None,
        TokenKind::Ident => match KEYWORDS.iter().position(|word| *word == text) {
            Some(keyword) => KEYWORD + keyword as u32,
            None => NAME,
        },
        TokenKind::RawIdent => NAME,
        TokenKind::Literal { .. } => LITERAL,
        TokenKind::Lifetime { .. } | TokenKind::RawLifetime => LIFETIME,
        _ => text.chars().next().map_or(NAME, u32::from),
    })
}

#[cfg(test)]
mod tests {
    use super::tokens;

    fn codes(source: &str) -> Vec<u32> {
        tokens(source, 0, 0).iter().map(|token| token.code).collect()
    }

    #[test]
    fn names_numbers_comments_and_layout_do_not_count() {
        let one = "// sum\nlet total = a.iter().sum::<f64>() + 1.5;";
        let two = "let  s=b.iter() /* all */ .fold::<f32>()\n + 7;";
        assert_eq!(codes(one), codes(two));
    }

    #[test]
    fn keywords_and_signs_do() {
        assert_ne!(codes("if a < b"), codes("while a < b"));
        assert_ne!(codes("a < b"), codes("a > b"));
    }

    #[test]
    fn lines_are_counted() {
        let lines: Vec<u32> =
            tokens("a\n\n/*\n*/ b", 0, 0).iter().map(|token| token.line).collect();
        assert_eq!(lines, [1, 4, 4]);
    }

    #[test]
    fn broken_code_has_tokens_too() {
        assert!(codes("fn f( { \"open").len() > 4);
    }
}
