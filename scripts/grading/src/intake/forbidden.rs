//! Code that no source may contain.
//!
//! These are attributes and macros that run code before `main` or replace other code.
//! `forbid(unsafe_code)` accepts some of them. Every file is searched, whatever its extension,
//! because `include!` reads any file.

use ra_ap_rustc_lexer::{FrontmatterAllowed, TokenKind, strip_shebang, tokenize};

use lab_kit::submission::Sources;

const NAMES: [&str; 6] =
    ["no_mangle", "export_name", "link_section", "link_name", "naked_asm", "global_asm"];

/// Finds the first forbidden code, and formats it with its location.
pub(crate) fn find(sources: &Sources) -> Option<String> {
    sources.iter().find_map(|(path, bytes)| {
        let source = String::from_utf8_lossy(bytes);
        let (what, line) = find_in(&source)?;
        Some(format!("{path}, line {line}: no submission may say `{what}`"))
    })
}

fn find_in(source: &str) -> Option<(&str, usize)> {
    let mut at = strip_shebang(source).unwrap_or(0);
    let mut after_unsafe = false;
    for token in tokenize(&source[at..], FrontmatterAllowed::No) {
        let text = &source[at..at + token.len as usize];
        let line = || 1 + source[..at].matches('\n').count();
        match token.kind {
            TokenKind::Ident | TokenKind::RawIdent => {
                let name = text.strip_prefix("r#").unwrap_or(text);
                if NAMES.contains(&name) {
                    return Some((name, line()));
                }
                after_unsafe = text == "unsafe";
            }
            // The compiler itself refuses unsafe blocks, functions and traits.
            TokenKind::OpenParen if after_unsafe => return Some(("unsafe(\u{2026})", line())),
            TokenKind::Whitespace
            | TokenKind::LineComment { .. }
            | TokenKind::BlockComment { .. } => {}
            _ => after_unsafe = false,
        }
        at += text.len();
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{find, find_in};

    #[test]
    fn what_runs_before_main_is_refused() {
        for source in [
            "#[unsafe(naked)] extern \"C\" fn f() {}",
            "#[unsafe /* x */\n(no_mangle)] fn f() {}",
            "#![unsafe (other)]",
            "core::arch::naked_asm!(\"ret\")",
            "#[link_section = \".init_array\"] static F: fn() = f;",
            "trait T { #[r#export_name = \"main\"] fn f() {} }",
            "macro_rules! m { ($a:ident) => { #[$a] fn f() {} } } m!(no_mangle);",
            "#!/usr/bin/env \"\n#[no_mangle] fn f() {}",
        ] {
            assert!(find_in(source).is_some(), "{source}");
        }
    }

    #[test]
    fn texts_comments_and_plain_code_are_let_through() {
        for source in [
            "// #[unsafe(naked)] and no_mangle",
            "/* link_section */ const A: &str = \"export_name unsafe(\";",
            "unsafe { f() } unsafe fn g() {}",
            "fn not_unsafe() { (no_mangled)() }",
        ] {
            assert_eq!(find_in(source), None, "{source}");
        }
    }

    #[test]
    fn it_is_said_where() {
        let bytes = b"fn f() {}\n\n#[no_mangle]\nfn g() {}".to_vec();
        let message = find(&[("src/data.txt".to_owned(), bytes)].into()).unwrap();
        assert_eq!(message, "src/data.txt, line 3: no submission may say `no_mangle`");
    }
}
