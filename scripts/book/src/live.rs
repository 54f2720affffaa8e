//! The scripts of the boxes that play, on the pages that have one.

/// In the order in which they need each other; they lie in book/src/live.
const SCRIPTS: [&str; 12] = [
    "random",
    "soft",
    "searches",
    "hard",
    "player",
    "panel",
    "searching",
    "energy",
    "windows",
    "contact",
    "collisions",
    "boxes",
];

/// The page, with the scripts at its end if it has a `<figure class="live" …>`. The page lies
/// `depth` folders below the book's own.
pub(crate) fn scripts(page: String, depth: usize) -> String {
    if !page.contains("<figure class=\"live\"") {
        return page;
    }
    let root = "../".repeat(depth);
    let tag = |name| format!("<script src=\"{root}live/{name}.js\"></script>\n");
    format!("{page}\n\n{}", SCRIPTS.map(tag).concat())
}

#[cfg(test)]
mod tests {
    use super::scripts;

    #[test]
    fn only_pages_with_a_box_have_scripts() {
        assert_eq!(scripts("# A\n\n<figure>".into(), 0), "# A\n\n<figure>");
        let page = scripts("<figure class=\"live\" data-box=\"idea\">".into(), 1);
        assert!(page.contains("<script src=\"../live/random.js\"></script>"), "{page}");
    }
}
