//! Code that no source may contain.
//!
//! These are attributes and macros that run code before `main` or replace other code.
//! `forbid(unsafe_code)` accepts some of them. Every file is searched, whatever its extension,
//! because `include!` reads any file.

use std::mem;
use std::str::FromStr;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use lab_kit::sources::Sources;

const NAMES: [&str; 6] =
    ["no_mangle", "export_name", "link_section", "link_name", "naked_asm", "global_asm"];

/// Text that messages show for an unsafe attribute.
const UNSAFE: &str = "unsafe(\u{2026})";

/// Finds the first forbidden code, and formats it with its location.
pub(crate) fn find(sources: &Sources) -> Option<String> {
    sources.iter().find_map(|(path, bytes)| {
        let source = String::from_utf8_lossy(bytes);
        let (what, line) = find_in(&source)?;
        Some(format!("{path}, line {line}: no submission may say `{what}`"))
    })
}

/// Returns the first forbidden code of a file, and its line number, counted from 1.
fn find_in(source: &str) -> Option<(&'static str, usize)> {
    match TokenStream::from_str(source) {
        Ok(tokens) => in_tokens(tokens),
        // The compiler may accept sources that this library does not, so every mention counts.
        Err(_) => in_text(source),
    }
}

/// Searches tokens without recursion, because a file may nest brackets deeply to exhaust the stack.
fn in_tokens(tokens: TokenStream) -> Option<(&'static str, usize)> {
    let mut open = vec![tokens.into_iter()];
    let mut after_unsafe = false;
    while let Some(tokens) = open.last_mut() {
        let Some(token) = tokens.next() else {
            open.pop();
            continue;
        };
        let line = token.span().start().line;
        let was_unsafe = mem::take(&mut after_unsafe);
        match token {
            TokenTree::Ident(ident) => {
                let ident = ident.to_string();
                let ident = ident.strip_prefix("r#").unwrap_or(&ident);
                if let Some(name) = NAMES.into_iter().find(|name| *name == ident) {
                    return Some((name, line));
                }
                after_unsafe = ident == "unsafe";
            }
            TokenTree::Group(group) => {
                // The compiler itself refuses unsafe blocks, functions and traits.
                if was_unsafe && group.delimiter() == Delimiter::Parenthesis {
                    return Some((UNSAFE, line));
                }
                open.push(group.stream().into_iter());
            }
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
    None
}

fn in_text(source: &str) -> Option<(&'static str, usize)> {
    let name = NAMES.into_iter().find_map(|name| Some((name, source.find(name)?)));
    let (what, at) = name.or_else(|| {
        let mut all = source.match_indices("unsafe");
        let (at, _) =
            all.find(|(at, word)| source[at + word.len()..].trim_start().starts_with('('))?;
        Some((UNSAFE, at))
    })?;
    Some((what, 1 + source[..at].matches('\n').count()))
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
    fn what_is_no_rust_and_what_nests_deeply_is_searched() {
        assert_eq!(find_in("\"open\n no_mangle"), Some(("no_mangle", 2)));
        assert!(find_in("\" unsafe\n(naked)").is_some());
        assert_eq!(find_in("a picture: \" unsafe { }"), None);
        let deep = 100_000;
        let source = format!("{}no_mangle{}", "(".repeat(deep), ")".repeat(deep));
        assert!(find_in(&source).is_some());
    }

    #[test]
    fn it_is_said_where() {
        let bytes = b"fn f() {}\n\n#[no_mangle]\nfn g() {}".to_vec();
        let message = find(&[("src/data.txt".to_owned(), bytes)].into()).unwrap();
        assert_eq!(message, "src/data.txt, line 3: no submission may say `no_mangle`");
    }
}
