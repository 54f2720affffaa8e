//! The attribute `test` of the graders.
//!
//! What it writes calls `oracle`, so a package whose tests use it needs both. The command needs `oracle` alone, and
//! has one package less to compile.

use proc_macro::{Delimiter, Group, TokenStream, TokenTree};

/// A test as the standard one, whose body fails with the name of its task if it does not end.
#[proc_macro_attribute]
pub fn test(_: TokenStream, item: TokenStream) -> TokenStream {
    let mut item: Vec<TokenTree> = item.into_iter().collect();
    let body = item.pop();
    let name = item.windows(2).find(|pair| pair[0].to_string() == "fn").map(|pair| &pair[1]);
    let name = name.map(ToString::to_string).unwrap_or_default();
    let mut arguments = tokens(&format!("{name:?}, ||"));
    arguments.extend(body);
    let mut call = tokens("::oracle::watched");
    call.extend([TokenTree::from(Group::new(Delimiter::Parenthesis, arguments))]);
    let mut test = tokens("#[::core::prelude::v1::test]");
    test.extend(item);
    test.extend([TokenTree::from(Group::new(Delimiter::Brace, call))]);
    test
}

fn tokens(source: &str) -> TokenStream {
    source.parse().expect("it is written here")
}
